// The parts of the module, in the order in which they are bound: a signature names what is bound before it.
#pragma once

#include <pybind11/pybind11.h>

namespace ecods::python {

void bind_enums(pybind11::module_& m);
void bind_errors(pybind11::module_& m);
void bind_meshes(pybind11::module_& m);
void bind_results(pybind11::module_& m);
void bind_pair_questions(pybind11::module_& m);
void bind_line_questions(pybind11::module_& m);
void bind_solid_questions(pybind11::module_& m);
void bind_casts(pybind11::module_& m);
void bind_many(pybind11::module_& m);
void bind_predicates(pybind11::module_& m);
void bind_certificates(pybind11::module_& m);
void bind_broad_phase(pybind11::module_& m);
void bind_trace(pybind11::module_& m);
void bind_world(pybind11::module_& m);
void bind_process(pybind11::module_& m);

}  // namespace ecods::python
