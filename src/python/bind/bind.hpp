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
void bind_many(pybind11::module_& m);
void bind_predicates(pybind11::module_& m);
void bind_certificates(pybind11::module_& m);
void bind_broad_phase(pybind11::module_& m);
void bind_trace(pybind11::module_& m);
void bind_world(pybind11::module_& m);
void bind_process(pybind11::module_& m);

// Shortens the errors of every function and method that is bound so far about arguments that fit no signature: one
// line, which ecods/refusals.py makes, in place of pybind11's list of signatures with all arguments written out. A call
// that is accepted costs one more by a pointer.
void shorten_refusals(const pybind11::module_& m);

}  // namespace ecods::python
