// Makes the module ecods._ecods. The package ecods exports everything in it.
#include "python/bind/bind.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_ecods, m) {
    using namespace ecods::python;
    m.doc() = "Exact answers about many moving triangle meshes.";
    bind_enums(m);
    bind_errors(m);
    bind_meshes(m);
    bind_builders(m);
    bind_results(m);
    bind_pair_questions(m);
    bind_turns(m);
    bind_motions(m);
    bind_ways(m);
    bind_line_questions(m);
    bind_solid_questions(m);
    bind_hit_sides(m);
    bind_rounded(m);
    bind_half_spaces(m);
    bind_contacts(m);
    bind_entering(m);
    bind_deforming(m);
    bind_many(m);
    bind_predicates(m);
    bind_certificates(m);
    bind_broad_phase(m);
    bind_trace(m);
    bind_world(m);
    bind_process(m);
    // Sets the module of each type to the package, under whose name types are looked up, printed and pickled.
    for (const auto& item : m.attr("__dict__").cast<py::dict>()) {
        if (py::isinstance<py::type>(item.second)) item.second.attr("__module__") = "ecods";
    }
    shorten_refusals(m);
}
