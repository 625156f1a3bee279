// Binds the questions of World about two subjects, each of which is a body of the world or a posed mesh.
#include "python/bind/patch_limits.hpp"
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
             "Relation of the first of two bodies to the second, insides of solids included.");
    type.def(
        "intersecting_triangles",
        [](const SharedWorld& self, const Subject& x, const Subject& y) {
            return from_triangles(asked_of_pair<>(ECODS_CALL(intersecting_triangles))(self, x, y));
        },
        a, b,
        "Every pair of triangles that share a point, ascending: (k, 2) uint32. None may, where a part of a body is "
        "inside a solid.");
    type.def("distance", asked_of_pair<>(ECODS_CALL(distance)), a, b, "The distance of two bodies, rounded once.");
    type.def("within", asked_of_pair<double>(ECODS_CALL(within)), a, b, max_distance,
             "True if the distance is at most max_distance, decided for the real number. Raises InvalidArgument.");
    type.def("closest", asked_of_pair<>(ECODS_CALL(closest)), a, b, "ClosestPoints of two bodies.");
    type.def("intersections", asked_of_pair<>(ECODS_CALL(intersections)), a, b,
             "The shared points of intersecting triangles: a list of TriangleIntersection.");
    type.def("close_features", asked_of_pair<double>(ECODS_CALL(close_features)), a, b, max_distance,
             "Pairs of features within max_distance: a list of CloseFeatures. Raises InvalidArgument.");
    type.def("depth", asked_of_pair<>(ECODS_CALL(depth)), a, b,
             "Depth of two convex bodies, ConvexSolid or Rounded, in each other; None if they share no point. Raises "
             "NotSupported, SingularPose.");
    type.def("signed_distance", asked_of_pair<>(ECODS_CALL(signed_distance)), a, b,
             "SignedDistance of two ConvexSolids, of a Rounded and a body, or of a body and a HalfSpace. Raises "
             "NotSupported, SingularPose.");
    type.def("depth_bounds", asked_of_pair<>(ECODS_CALL(depth_bounds)), a, b,
             "DepthBounds of two Solids; None if they share no point. Raises NotSupported, SingularPose.");
    const LimitArguments limits;
    type.def(
        "contact_patch",
        [](const SharedWorld& self, const Subject& first, const Subject& second, std::uint32_t max_corners,
           double min_cos_squared, double max_gap) {
            return self.read([&](const World& world) {
                return world.contact_patch(to_asked(first), to_asked(second), {max_corners, min_cos_squared, max_gap});
            });
        },
        a, b, limits.max_corners, limits.min_cos_squared, limits.max_gap,
        "ContactPatch of two convex bodies, as contact_patch(). Raises NotSupported, SingularPose, InvalidArgument.");
}

}  // namespace ecods::python
