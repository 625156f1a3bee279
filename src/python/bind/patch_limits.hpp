// LimitArguments are the arguments of Python functions for the limits of a contact patch.
#pragma once

#include "ecods/contact.hpp"
#include "python/bind/arrays.hpp"

namespace ecods::python {

struct LimitArguments {
    const PatchLimits all{};
    py::arg_v max_corners = py::arg("max_corners") = all.max_corners;
    py::arg_v min_cos_squared = py::arg("min_cos_squared") = all.min_cos_squared;
    py::arg_v max_gap = py::arg("max_gap") = all.max_gap;
};

}  // namespace ecods::python
