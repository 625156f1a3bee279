// Binds questions about solids: solid.hpp.
#include "ecods/solid.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
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
        "surface_of", [](const Solid& solid) { return to_python(surface_of(solid)); }, py::arg("solid"),
        "The surface of a Solid alone, with all triangles of its mesh, as a Mesh that shares the tree: the same object "
        "each time.");
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

void add_signed_distance(py::module_& m) {
    add_record(
        m, "SignedDistance",
        "The signed distance of two convex solids, and two points: the closest ones of solids that are apart, "
        "otherwise "
        "those that the shortest translation of b by point_a - point_b brings together. point_b - point_a is distance "
        "times direction.",
        Field{"distance", &SignedDistance::distance,
              "The distance, or minus the depth, rounded once; 0 if they touch."},
        Field{"kind", &SignedDistance::kind, "ClosestKind of the features."},
        Field{"a", &SignedDistance::a, "The feature that holds point_a."},
        Field{"b", &SignedDistance::b, "The feature that holds point_b."},
        Field{"point_a", &SignedDistance::point_a, "(3,) float64, each coordinate rounded once."},
        Field{"point_b", &SignedDistance::point_b, "(3,) float64, each coordinate rounded once."},
        Field{"direction", &SignedDistance::direction, "Unit vector (3,), out of a; the direction of the depth, too."});
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
    m.def("depth_bounds", asked_of_solids(ECODS_QUESTION(depth_bounds)), a, b,
          "DepthBounds of two Solids, convex or not; None if they share no point. Raises SingularPose.");
    m.def("depth", asked_of_convex_solids(ECODS_QUESTION(depth)), a, b, witness,
          "Depth of two ConvexSolids in each other; None if they share no point. Raises SingularPose.");
    add_signed_distance(m);
    m.def("signed_distance", asked_of_convex_solids(ECODS_QUESTION(signed_distance)), a, b, witness,
          "SignedDistance of two ConvexSolids. Raises SingularPose.");
}

}  // namespace ecods::python
