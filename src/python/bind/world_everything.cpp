// Binds the questions of World about all of its present bodies.
#include "python/bind/patch_limits.hpp"
#include "python/bind/world.hpp"

namespace ecods::python {
namespace {

using Filter = std::optional<CollisionFilter>;

constexpr std::uint64_t every_group = ~std::uint64_t{0};

void add_finding(WorldClass& type, const py::arg& what, const py::arg_v& filter) {
    type.def(
        "overlapping_bodies",
        [](const SharedWorld& self, const Aabb& box) {
            return from_bodies(reading(&World::overlapping_bodies)(self, box));
        },
        py::arg("box"), "Bodies whose boxes share a point with this box (2, 3): (k,) uint64. Raises InvalidArgument.");
    type.def(
        "intersecting_bodies",
        [](const SharedWorld& self, const Subject& subject, const Filter& only) {
            return from_bodies(
                self.read([&](const World& world) { return world.intersecting_bodies(to_asked(subject, only)); }));
        },
        what, filter,
        "Bodies that share a point with a body, a Mesh or a Posed: (k,) uint64, ascending. Exact. With a filter, only "
        "the bodies that it may meet. If the question is about a body, bodies with which it is filtered out do not "
        "count. Both hold for nearest() and cast(), too.");
    type.def("bodies_containing", asked_of_world<Vec3>(ECODS_CALL(bodies_containing)), py::arg("point"),
             "BodiesContaining: the Solids and Rounded bodies with the point (3,) in them or on them. Raises "
             "InvalidArgument.");
}

void add_nearest(WorldClass& type, const py::arg& what, const py::arg_v& filter) {
    const auto max_distance = py::arg("max_distance") = World::no_limit;
    type.def(
        "nearest",
        [](const SharedWorld& self, const Subject& subject, double most, const Filter& only) {
            return self.read([&](const World& world) { return world.nearest(to_asked(subject, only), most); });
        },
        what, max_distance, filter,
        "NearestBody to a body, a Mesh or a Posed, among the bodies within max_distance, or None. If distances are "
        "equal, the body of the least id. Raises InvalidArgument.");
    const auto groups_a = py::arg("groups_a") = every_group, groups_b = py::arg("groups_b") = every_group;
    type.def(
        "closest_pair", asked_of_world<double, std::uint64_t, std::uint64_t>(ECODS_CALL(closest_pair)), max_distance,
        groups_a, groups_b,
        "ClosestPair of all pairs that are not filtered out, within max_distance, or None. With groups, only pairs "
        "of a body in groups_a and one in groups_b count. Raises InvalidArgument.");
    type.def("closest_pairs", asked_of_world<double, std::uint64_t, std::uint64_t>(ECODS_CALL(closest_pairs)),
             py::arg("max_distance"), groups_a, groups_b,
             "All pairs that closest_pair() chooses from: a list of ClosestPair, by distance, then by ids.");
    type.def("depths", asked_of_world<>(ECODS_CALL(depths)),
             "Pairs of convex bodies, rounded ones too, that share a point: a list of BodyDepth. Raises SingularPose.");
    type.def("signed_distances", asked_of_world<double>(ECODS_CALL(signed_distances)), py::arg("max_distance"),
             "The pairs of closest_pairs() without their points: a list of PairDistance, by ids.");
    const LimitArguments limits;
    type.def(
        "contact_patches",
        [](const SharedWorld& self, std::uint32_t max_corners, double min_cos_squared, double max_gap) {
            return self.read([&](const World& world) {
                return world.contact_patches({max_corners, min_cos_squared, max_gap});
            });
        },
        limits.max_corners, limits.min_cos_squared, limits.max_gap,
        "Contact patches of all colliding pairs of convex bodies: a list of BodyPatch, in the order of "
        "colliding_pairs. Raises SingularPose, InvalidArgument.");
}

template <class Line>
void add_hits(WorldClass& type, const py::arg_v& filter) {
    type.def("first_hit", asked_of_world<Line, Filter>(ECODS_CALL(first_hit)), py::arg("line"), filter,
             "BodyHit of least real parameter of a Segment or Ray, or None.");
    type.def("all_hits", asked_of_world<Line, Filter>(ECODS_CALL(all_hits)), py::arg("line"), filter,
             "All hits of a Segment or Ray: a list of BodyHit, by real parameter.");
    type.def("sided_hits", asked_of_world<Line, Filter>(ECODS_CALL(sided_hits)), py::arg("line"), filter,
             "all_hits() with normals and sides: a list of BodySidedHit. Raises NotSupported unless all bodies are "
             "meshes or Solids.");
    type.def("inside_parts", asked_of_world<Line, Filter>(ECODS_CALL(inside_parts)), py::arg("line"), filter,
             "The parts of a Segment or Ray that are inside Solids: a list of BodyInsidePart, by the real parameter "
             "where they begin. Raises as sided_hits() does.");
}

// Binds the overload for motions first: a list of motions is never an array of poses, whereas an object that is no list
// of motions may be an array of poses.
void add_meetings(WorldClass& type) {
    type.def(
        "meetings",
        [](const SharedWorld& self, const py::object& bodies, const std::vector<Motion>& motions) {
            const auto ids = to_bodies(bodies);
            return self.read([&](const World& world) { return world.meetings(ids, motions); });
        },
        py::arg("bodies"), py::arg("motions"),
        "All pairs that meet while each of these bodies (k,) moves by its Translation, Straight, Turn or Along, in a "
        "list, and the others stay: a list of Meeting, by time. Raises NotSupported if one goes Along nodes and "
        "another one moves, StaleBody, InvalidArgument.");
    type.def(
        "meetings",
        [](const SharedWorld& self, const py::object& bodies, const py::object& poses) {
            const auto ids = to_bodies(bodies);
            const auto places = to_poses(poses, ids);
            return self.read([&](const World& world) { return world.meetings(ids, places); });
        },
        py::arg("bodies"), py::arg("poses"),
        "All pairs that meet while these bodies go to new poses (k, 4, 4), each point straight from its old place to "
        "its new one. Raises as set_poses() does.");
}

void add_casts(WorldClass& type, const py::arg& what, const py::arg_v& filter) {
    type.def(
        "cast",
        [](const SharedWorld& self, const Subject& subject, const Vec3& motion, double most, const Filter& only) {
            return self.read([&](const World& world) { return world.cast(to_asked(subject, only), motion, most); });
        },
        what, py::arg("motion"), py::arg("max_time") = 1.0, filter,
        "BodyContact: what a body, a Mesh or a Posed meets first while it is translated by time times motion (3,), up "
        "to max_time, or None. Nothing moves. Raises InvalidArgument.");
    type.def(
        "cast",
        [](const SharedWorld& self, const Subject& subject, const Motion& motion, double most, const Filter& only) {
            return self.read([&](const World& world) { return world.cast(to_asked(subject, only), motion, most); });
        },
        what, py::arg("motion"), py::arg("max_time") = 1.0, filter,
        "The same while it moves by a Translation, a Straight, a Turn or Along nodes. Raises NotSupported for a Turn "
        "and nodes unless it and all that it may meet are meshes or Solids, and for a Straight if it or one of them is "
        "rounded and one of the two is not translated.");
    type.def(
        "cast_to_distance",
        [](const SharedWorld& self, const Subject& subject, const Vec3& motion, double distance, double most,
           const Filter& only) {
            return self.read([&](const World& world) {
                return world.cast_to_distance(to_asked(subject, only), motion, distance, most);
            });
        },
        what, py::arg("motion"), py::arg("distance"), py::arg("max_time") = 1.0, filter,
        "BodyContact: the body that a body, a Mesh or a Posed, translated as in cast(), is first within a distance of, "
        "or None. Raises NotSupported where a half space may be met, InvalidArgument.");
    type.def(
        "entering",
        [](const SharedWorld& self, const Subject& subject, const Vec3& motion, double most, const Filter& only) {
            return self.read([&](const World& world) { return world.entering(to_asked(subject, only), motion, most); });
        },
        what, py::arg("motion"), py::arg("max_time") = 1.0, filter,
        "BodyEntry: the body that a body, a Mesh or a Posed goes into first, translated as in cast(), before max_time, "
        "or None. Raises NotSupported unless all are surfaces or all are Solids, InvalidArgument.");
    type.def(
        "contact_point",
        [](const SharedWorld& self, const Subject& subject, const Vec3& motion, const BodyContact& contact) {
            return self.read(
                [&](const World& world) { return world.contact_point(to_asked(subject, {}), motion, contact); });
        },
        what, py::arg("motion"), py::arg("contact"),
        "ContactPoint of a BodyContact that cast() of these arguments returned. Raises NotSupported for other shapes "
        "than meshes, solids and rounded ones.");
    type.def(
        "cast",
        [](const SharedWorld& self, const Deforming& mesh, double most, const Filter& only) {
            return self.read([&](const World& world) { return world.cast(mesh, most, only); });
        },
        py::arg("mesh"), py::arg("max_time") = 1.0, filter,
        "BodyContact: the body that a Deforming mesh meets first, up to max_time, or None. Raises NotSupported if one "
        "that the filter may meet is no Mesh or Solid, InvalidArgument.");
    add_meetings(type);
}

}  // namespace

void add_questions_about_everything(WorldClass& type) {
    const py::arg what("what");
    const auto filter = py::arg("filter") = py::none();
    add_finding(type, what, filter);
    add_nearest(type, what, filter);
    add_hits<Segment>(type, filter);
    add_hits<Ray>(type, filter);
    add_casts(type, what, filter);
    type.def(
        "certify", asked_of_world<>(ECODS_CALL(certify)),
        "WorldCertificate of colliding_pairs() and close_pairs(). Raises NotUpdated, and NotSupported where a body "
        "is a Solid.");
}

}  // namespace ecods::python
