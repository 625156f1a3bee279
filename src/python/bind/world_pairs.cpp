// World: questions about two of its bodies, as of now.
#include "python/bind/world.hpp"

namespace ecods::python {

void add_pair_questions(WorldClass& type) {
    const py::arg a("a");
    const py::arg b("b");
    const py::arg d("d");
    type.def("intersects", asked_of_world<BodyId, BodyId>(ECODS_CALL(intersects)), a, b,
             "Whether two bodies share a point, as of now. Raises StaleBody, SameBody, as all of these do.");
    type.def("relation", asked_of_world<BodyId, BodyId>(ECODS_CALL(relation)), a, b, "Relation of two bodies.");
    type.def(
        "intersecting_triangles",
        [](SharedWorld& self, BodyId x, BodyId y) {
            return from_triangles(
                self.ask([&](auto& world, auto&... memory) { return world.intersecting_triangles(x, y, memory...); }));
        },
        a, b, "Every pair of triangles that share a point, ascending: (k, 2) uint32.");
    type.def("distance", asked_of_world<BodyId, BodyId>(ECODS_CALL(distance)), a, b,
             "The distance of two bodies, rounded once.");
    type.def("within", asked_of_world<BodyId, BodyId, double>(ECODS_CALL(within)), a, b, d,
             "Whether the distance is at most d, decided for the real number. Raises InvalidArgument.");
    type.def("closest", asked_of_world<BodyId, BodyId>(ECODS_CALL(closest)), a, b, "ClosestPoints of two bodies.");
    type.def("intersections", asked_of_world<BodyId, BodyId>(ECODS_CALL(intersections)), a, b,
             "What intersecting triangles share: a list of TriangleIntersection.");
    type.def("close_features", asked_of_world<BodyId, BodyId, double>(ECODS_CALL(close_features)), a, b, d,
             "Pairs of features within d: a list of CloseFeatures. Raises InvalidArgument.");
    type.def("solid_relation", asked_of_world<BodyId, BodyId>(ECODS_CALL(solid_relation)), a, b,
             "SolidRelation of two bodies. Raises NotSupported if one is no Solid.");
    type.def("solid_distance", asked_of_world<BodyId, BodyId>(ECODS_CALL(solid_distance)), a, b,
             "The distance of two ConvexSolids, interiors included. Raises NotSupported, SingularPose.");
    type.def("solid_closest", asked_of_world<BodyId, BodyId>(ECODS_CALL(solid_closest)), a, b,
             "ClosestPoints of two ConvexSolids; None where they meet.");
    type.def("depth", asked_of_world<BodyId, BodyId>(ECODS_CALL(depth)), a, b,
             "Depth of two ConvexSolids in each other; None if they share no point.");
    type.def("depth_bounds", asked_of_world<BodyId, BodyId>(ECODS_CALL(depth_bounds)), a, b,
             "DepthBounds of two Solids; None if they share no point.");
}

}  // namespace ecods::python
