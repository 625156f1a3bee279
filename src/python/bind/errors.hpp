// Raises errors that only Python's integers can cause, which have a sign and any size.
#pragma once

#include <pybind11/pybind11.h>

#include "ecods/error.hpp"

namespace ecods::python {

// Raises StaleBody for an integer that no id can be: it is negative, or has more than 64 bits.
[[noreturn]] void raise_stale(const pybind11::object& number, ListIndex index = {});

// Raises InvalidMesh of an index that was negative before it was taken for one of 64 bits without a sign.
[[noreturn]] void raise_negative(const InvalidMesh& error);

}  // namespace ecods::python
