// Declares functions that each bind a part of the module. module.cpp calls these functions in the order of this file,
// because the types in a signature must be bound before the signature.
#pragma once

#include <pybind11/pybind11.h>

namespace ecods::python {

void bind_enums(pybind11::module_& m);
void bind_errors(pybind11::module_& m);
void bind_meshes(pybind11::module_& m);
void bind_builders(pybind11::module_& m);
void bind_results(pybind11::module_& m);
void bind_pair_questions(pybind11::module_& m);
void bind_turns(pybind11::module_& m);
void bind_motions(pybind11::module_& m);
void bind_ways(pybind11::module_& m);
void bind_rounded(pybind11::module_& m);
void bind_half_spaces(pybind11::module_& m);
void bind_contacts(pybind11::module_& m);
void bind_entering(pybind11::module_& m);
void bind_deforming(pybind11::module_& m);
void bind_line_questions(pybind11::module_& m);
void bind_solid_questions(pybind11::module_& m);
void bind_hit_sides(pybind11::module_& m);
void bind_many(pybind11::module_& m);
void bind_predicates(pybind11::module_& m);
void bind_certificates(pybind11::module_& m);
void bind_broad_phase(pybind11::module_& m);
void bind_trace(pybind11::module_& m);
void bind_world(pybind11::module_& m);
void bind_process(pybind11::module_& m);

// Shortens the error for arguments that fit no signature, for every function and method bound so far. In place of
// pybind11's list of signatures and arguments, the error has the one line that ecods/refusals.py makes. A successful
// call costs one more indirect call.
void shorten_refusals(const pybind11::module_& m);

}  // namespace ecods::python
