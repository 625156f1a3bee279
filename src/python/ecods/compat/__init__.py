"""Modules that answer the calls of other libraries, so that programs written for those libraries run on ECoDS."""
