// Binds the questions of World about two subjects, each of which is a body of the world or a posed mesh.
#include "python/bind/world.hpp"

namespace ecods::python {

void add_pair_questions(WorldClass& type) {
    const py::arg a("a");
    const py::arg b("b");
    const py::arg max_distance("max_distance");
    type.def("intersects", asked_of_pair<>(ECODS_CALL(intersects)), a, b,
             "True if two bodies share a point, as of now. In all questions about two bodies, each body is an id, a "
             "Mesh or a Posed. All of them raise StaleBody and SameBody.");
    type.def("relation", asked_of_pair<>(ECODS_CALL(relation)), a, b,
             "Relation of two bodies as surfaces: apart, touching or crossing.");
    type.def(
        "intersecting_triangles",
        [](const SharedWorld& self, const Subject& x, const Subject& y) {
            return from_triangles(asked_of_pair<>(ECODS_CALL(intersecting_triangles))(self, x, y));
        },
        a, b, "Every pair of triangles that share a point, ascending: (k, 2) uint32.");
    type.def("distance", asked_of_pair<>(ECODS_CALL(distance)), a, b, "The distance of two bodies, rounded once.");
    type.def("within", asked_of_pair<double>(ECODS_CALL(within)), a, b, max_distance,
             "True if the distance is at most max_distance, decided for the real number. Raises InvalidArgument.");
    type.def("closest", asked_of_pair<>(ECODS_CALL(closest)), a, b, "ClosestPoints of two bodies.");
    type.def("intersections", asked_of_pair<>(ECODS_CALL(intersections)), a, b,
             "The shared points of intersecting triangles: a list of TriangleIntersection.");
    type.def("close_features", asked_of_pair<double>(ECODS_CALL(close_features)), a, b, max_distance,
             "Pairs of features within max_distance: a list of CloseFeatures. Raises InvalidArgument.");
    type.def("solid_relation", asked_of_pair<>(ECODS_CALL(solid_relation)), a, b,
             "Relation of two Solids: anything but crossing. Raises NotSupported if one is no Solid.");
    type.def("solid_distance", asked_of_pair<>(ECODS_CALL(solid_distance)), a, b,
             "The distance of two ConvexSolids, interiors included. Raises NotSupported, SingularPose.");
    type.def("solid_closest", asked_of_pair<>(ECODS_CALL(solid_closest)), a, b,
             "ClosestPoints of two ConvexSolids; None if they share a point.");
    type.def("depth", asked_of_pair<>(ECODS_CALL(depth)), a, b,
             "Depth of two ConvexSolids in each other; None if they share no point.");
    type.def("depth_bounds", asked_of_pair<>(ECODS_CALL(depth_bounds)), a, b,
             "DepthBounds of two Solids; None if they share no point.");
}

}  // namespace ecods::python
