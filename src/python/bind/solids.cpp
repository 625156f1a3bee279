// Binds questions about solids: solid.hpp.
#include "ecods/solid.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

using Body = const PosedMesh&;

// Returns a function that asks question(a, b) about two Solids.
template <class Question>
auto asked_of_solids(Question question) {
    return [question](Body a, Body b) {
        const auto p = as<Solid>(a, "a");
        const auto q = as<Solid>(b, "b");
        return ask([&] { return question(p, q); });
    };
}

// Returns a function that asks question(a, b, ask) about two ConvexSolids, with a witness.
template <class Question>
auto asked_of_convex_solids(Question question) {
    return [question](Body a, Body b, PairWitness* witness) {
        const auto p = as<ConvexSolid>(a, "a");
        const auto q = as<ConvexSolid>(b, "b");
        return ask(witness, [&](const Ask& how) { return question(p, q, how); });
    };
}

void add_checks(py::module_& m) {
    m.def(
        "check_solid", [](const MeshShape& mesh) { check_solid(mesh.mesh()); }, py::arg("mesh"),
        py::call_guard<py::gil_scoped_release>(),
        "Raises NotSolid, which names the place, unless the mesh bounds a solid.");
    m.def(
        "self_intersections",
        [](const MeshShape& mesh) { return from_triangles(ask([&] { return self_intersections(mesh.mesh()); })); },
        py::arg("mesh"),
        "Every pair of triangles that share a segment or more that is not a side of both: (k, 2) uint32.");
}

}  // namespace

void bind_solid_questions(py::module_& m) {
    const py::arg a("a");
    const py::arg b("b");
    const auto witness = py::arg("witness") = py::none();
    add_checks(m);
    m.def(
        "locate",
        [](const Vec3& point, Body solid) {
            const auto posed = as<Solid>(solid, "solid");
            return ask([&] { return locate(point, posed); });
        },
        py::arg("point"), py::arg("solid"),
        "Location of a point (3,): outside, on or inside. Exact. Raises InvalidArgument.");
    m.def("solid_relation", asked_of_solids(ECODS_QUESTION(solid_relation)), a, b,
          "Relation of two Solids: apart, touching, overlapping, inside, contains or equal. Exact.");
    m.def(
        "surface_relation",
        [](Body surface, Body solid) {
            const auto posed = as<Solid>(solid, "solid");
            return ask([&] { return surface_relation(surface, posed); });
        },
        py::arg("surface"), py::arg("solid"),
        "Relation of a mesh to a Solid: apart, touching, crossing or inside. Exact.");
    m.def("depth_bounds", asked_of_solids(ECODS_QUESTION(depth_bounds)), a, b,
          "DepthBounds of two Solids, convex or not; None if they share no point. Raises SingularPose.");
    m.def("solid_distance", asked_of_convex_solids(ECODS_QUESTION(solid_distance)), a, b, witness,
          "The distance of two ConvexSolids, interiors included: rounded once. Raises SingularPose.");
    m.def("solid_closest", asked_of_convex_solids(ECODS_QUESTION(solid_closest)), a, b, witness,
          "ClosestPoints of two ConvexSolids; None if they share a point. Raises SingularPose.");
    m.def("depth", asked_of_convex_solids(ECODS_QUESTION(depth)), a, b, witness,
          "Depth of two ConvexSolids in each other; None if they share no point. Raises SingularPose.");
}

}  // namespace ecods::python
