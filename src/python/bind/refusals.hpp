// One line for arguments that fit no signature, in place of pybind11's list of signatures with all arguments written
// out.
#pragma once

#include <pybind11/pybind11.h>

namespace ecods::python {

// Shortens the errors of every function and method that is bound so far; ecods/refusals.py makes the text. A call that
// is accepted costs one more by a pointer.
void shorten_refusals(const pybind11::module_& m);

}  // namespace ecods::python
