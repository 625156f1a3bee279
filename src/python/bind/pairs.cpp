// Binds questions about two bodies: intersection.hpp, distance.hpp, cast.hpp.
#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

const double infinity = std::numeric_limits<double>::infinity();

void add_intersections(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    m.def("intersects", asked_with_witness<PosedMesh, PosedMesh>(ECODS_QUESTION(intersects)), a, b, witness,
          "True if two bodies share a point. Exact. A body is a Mesh, a Solid or a ConvexSolid, or one of them "
          "at(pose); a "
          "Mesh is its surface, a Solid all points on and inside it.");
    m.def("relation", asked<PosedMesh, PosedMesh>(ECODS_QUESTION(relation)), a, b,
          "Relation of a to b; of two surfaces the strongest of any two of their triangles. Exact.");
    m.def(
        "intersecting_triangles",
        [](const PosedMesh& x, const PosedMesh& y) {
            return from_triangles(ask([&] { return intersecting_triangles(x, y); }));
        },
        a, b,
        "Every pair of triangles that share a point, ascending: (k, 2) uint32, indices of faces of a and of b. None "
        "may, "
        "where a part of a body is inside a solid.");
    m.def("intersections", asked<PosedMesh, PosedMesh>(ECODS_QUESTION(intersections)), a, b,
          "Every pair of triangles that share a point, as a list of TriangleIntersection: the shared points, and the "
          "normal if it is defined.");
}

void add_distances(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    const py::arg max_distance("max_distance");
    m.def("distance", asked_with_witness<PosedMesh, PosedMesh>(ECODS_QUESTION(distance)), a, b, witness,
          "The distance in the unit of the coordinates: the true number, rounded once; 0 exactly when they intersect.");
    m.def(
        "within", asked_with_witness<PosedMesh, PosedMesh, double>(ECODS_QUESTION(within)), a, b, max_distance, witness,
        "True if the distance is at most max_distance, decided for the real number. Raises InvalidArgument if that is "
        "negative or NaN.");
    m.def("closest", asked_with_witness<PosedMesh, PosedMesh>(ECODS_QUESTION(closest)), a, b, witness,
          "ClosestPoints: two points at the least distance, and the features that hold them.");
    m.def("closest_point", asked<Vec3, PosedMesh>(ECODS_QUESTION(closest)), py::arg("point"), py::arg("body"),
          "ClosestPoint of a body to a point (3,); at distance 0 inside a Solid. Exact. Raises InvalidArgument.");
    m.def("signed_distance", asked<Vec3, PosedMesh>(ECODS_QUESTION(signed_distance)), py::arg("point"), py::arg("body"),
          "The distance of a point (3,) from the body's surface, rounded once: negative inside a Solid, 0 exactly on "
          "the surface. (The sign of trimesh is the other one.) Raises InvalidArgument.");
    m.def("distance_bounds", asked_for_distance_bounds<PosedMesh, PosedMesh>(), a, b, py::arg("relative") = 0.0,
          py::arg("absolute") = 0.0, py::arg("max_distance") = infinity, witness,
          "An interval with the distance in it: upper - lower <= max(absolute, relative * lower), or both are adjacent "
          "doubles. Once lower is above max_distance, upper may be infinity. Raises InvalidArgument.");
    m.def(
        "signed_distance_bounds", asked_with_witness<PosedMesh, PosedMesh>(ECODS_QUESTION(signed_distance_bounds)), a,
        b, witness,
        "An interval with the signed distance in it: the distance, minus the depth of two solids, or 0 where a surface "
        "is met. Both ends are the same number, unless solids overlap that are not both convex.");
    m.def(
        "close_triangles", asked<PosedMesh, PosedMesh, double>(ECODS_QUESTION(close_triangles)), a, b, max_distance,
        "Every pair of triangles within max_distance, as a list of ClosestPoints; what is inside a solid is not asked. "
        "Raises InvalidArgument.");
    m.def("close_features", asked<PosedMesh, PosedMesh, double>(ECODS_QUESTION(close_features)), a, b, max_distance,
          "The pairs of features within max_distance that hold closest points of triangles: a list of CloseFeatures.");
}

void add_casts(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    const auto max_time = py::arg("max_time") = 1.0;
    m.def("cast", asked_with_witness<PosedMesh, Vec3, PosedMesh, double>(ECODS_QUESTION(cast)), a, py::arg("motion"), b,
          max_time, witness,
          "FirstContact of a, translated by time times motion (3,), with b, which stays; None if there is none up to "
          "max_time. Contact at time 0 and grazing count. Exact. Raises InvalidArgument.");
    m.def("cast", asked_with_witness<MovingMesh, MovingMesh, double>(ECODS_QUESTION(cast)), a, b, max_time, witness,
          "FirstContact of two bodies that each go from one pose to another (Mesh.moving): each point moves straight "
          "from its first place to its last, so that a body that turns is not rigid on its way.");
}

}  // namespace

void bind_pair_questions(py::module_& m) {
    add_record(m, "Witness",
               "A memory of the features that decided a pair last time: passed again for a pair that has moved little, "
               "it saves time. It is only tried first; no answer depends on it. Questions change it.",
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
