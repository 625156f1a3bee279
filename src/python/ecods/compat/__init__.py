"""Modules that answer the calls of other libraries, so that programs written for these run on ECoDS."""
