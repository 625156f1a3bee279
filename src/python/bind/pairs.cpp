// Questions about two bodies: intersection.hpp, distance.hpp, contact.hpp, cast.hpp.
#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

const double infinity = std::numeric_limits<double>::infinity();

void add_intersections(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    m.def("intersects", asked_with_witness<PosedMesh, PosedMesh>(ECODS_QUESTION(intersects)), a, b, witness,
          "Whether two bodies share a point. Exact. A body is a Mesh, or Mesh.at(pose).");
    m.def("relation", asked<PosedMesh, PosedMesh>(ECODS_QUESTION(relation)), a, b,
          "Relation: disjoint, touching or crossing, the strongest of any two of their triangles. Exact.");
    m.def(
        "intersecting_triangles",
        [](const PosedMesh& x, const PosedMesh& y) {
            return from_triangles(ask([&](auto& memory) { return intersecting_triangles(x, y, memory); }));
        },
        a, b, "Every pair of triangles that share a point, ascending: (k, 2) uint32, indices of faces of a and of b.");
    m.def("intersections", asked<PosedMesh, PosedMesh>(ECODS_QUESTION(intersections)), a, b,
          "The same, as a list of TriangleIntersection: with what they share, and the normal where one is defined.");
}

void add_distances(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    const py::arg d("d");
    m.def("distance", asked_with_witness<PosedMesh, PosedMesh>(ECODS_QUESTION(distance)), a, b, witness,
          "The distance in the unit of the coordinates: the true number, rounded once; 0 exactly when they intersect.");
    m.def("within", asked_with_witness<PosedMesh, PosedMesh, double>(ECODS_QUESTION(within)), a, b, d, witness,
          "Whether the distance is at most d, decided for the real number. Raises InvalidArgument if d is negative or "
          "NaN.");
    m.def("closest", asked_with_witness<PosedMesh, PosedMesh>(ECODS_QUESTION(closest)), a, b, witness,
          "ClosestPoints: where they are closest to each other, and on which features.");
    m.def(
        "distance_bounds",
        [](const PosedMesh& x, const PosedMesh& y, double relative, double absolute, double at_most,
           PairWitness* known) {
            const DistanceTolerance tolerance{.relative = relative, .absolute = absolute, .at_most = at_most};
            return ask(known, [&](auto& memory, auto& w) { return distance_bounds(x, y, tolerance, memory, w); });
        },
        a, b, py::arg("relative") = 0.0, py::arg("absolute") = 0.0, py::arg("at_most") = infinity, witness,
        "An interval with the distance in it: upper - lower <= max(absolute, relative * lower), or both are adjacent "
        "doubles. Once lower is above at_most, upper may be infinity. Raises InvalidArgument.");
    m.def("close_triangles", asked<PosedMesh, PosedMesh, double>(ECODS_QUESTION(close_triangles)), a, b, d,
          "Every pair of triangles within d, as a list of ClosestPoints. Raises InvalidArgument.");
    m.def("close_features", asked<PosedMesh, PosedMesh, double>(ECODS_QUESTION(close_features)), a, b, d,
          "The pairs of features within d that hold closest points of triangles: a list of CloseFeatures.");
}

void add_casts(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    m.def("cast", asked_with_witness<PosedMesh, Vec3, PosedMesh>(ECODS_QUESTION(cast)), a, py::arg("motion"), b,
          witness,
          "FirstContact of a, translated by time times motion (3,), with b, which stays; None if there is none up to "
          "time 1. Contact at time 0 and grazing count. Exact. Raises InvalidArgument.");
    m.def("cast", asked_with_witness<MovingMesh, MovingMesh>(ECODS_QUESTION(cast)), a, b, witness,
          "The same of two meshes of which each goes from one pose to another (Mesh.moving): each point straight from "
          "its one place to the other, so that a mesh that turns is not rigid on its way.");
}

}  // namespace

void bind_pair_questions(py::module_& m) {
    add_record(m, "Witness",
               "What decided a pair the last time: given again for a pair that has moved little, it saves time. It is "
               "tried first and never believed; no answer depends on it. Questions change it.",
               Field{"a", &PairWitness::a, "The library's own; 2**32 - 1 at first."},
               Field{"b", &PairWitness::b, "The library's own; 2**32 - 1 at first."})
        .def(py::init<>());
    const py::arg a("a");
    const py::arg b("b");
    const auto witness = py::arg("witness") = py::none();
    add_intersections(m, a, b, witness);
    add_distances(m, a, b, witness);
    add_casts(m, a, b, witness);
}

}  // namespace ecods::python
