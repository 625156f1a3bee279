// Raises errors that only Python's integers can cause, because Python's integers may be negative or have more than 64
// bits.
#pragma once

#include <pybind11/pybind11.h>

#include "ecods/error.hpp"

namespace ecods::python {

// Raises StaleBody for an integer that cannot be an id, because it is negative or has more than 64 bits. `index` is the
// integer's place in a list, if there is a list.
[[noreturn]] void raise_stale(const pybind11::object& number, ListIndex index = {});

// Raises InvalidMesh with the negative index that Python passed. In `error`, the index is converted to 64 bits without
// a sign.
[[noreturn]] void raise_negative(const InvalidMesh& error);

}  // namespace ecods::python
