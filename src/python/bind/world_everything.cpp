// World: questions about all of its bodies, as of now.
#include "python/bind/world.hpp"

namespace ecods::python {
namespace {

using Filter = std::optional<CollisionFilter>;
constexpr double infinity = World::no_limit;

void add_finding(WorldClass& type, const py::arg_v& filter) {
    type.def(
        "overlapping_bodies",
        [](SharedWorld& self, const Aabb& box) { return from_bodies(reading(&World::overlapping_bodies)(self, box)); },
        py::arg("box"), "Bodies whose boxes share a point with this one (2, 3): (k,) uint64. Raises InvalidArgument.");
    type.def(
        "intersecting_bodies",
        [](SharedWorld& self, const PosedMesh& what, const Filter& only) {
            return from_bodies(self.ask([&](auto& world, auto&... memory) {
                return world.intersecting_bodies(*what.shape, what.pose, memory..., only);
            }));
        },
        py::arg("what"), filter, "Bodies that share a point with a Mesh or Posed: (k,) uint64, ascending. Exact.");
    type.def("bodies_containing", asked_of_world<Vec3>(ECODS_CALL(bodies_containing)), py::arg("point"),
             "BodiesContaining: the solids with the point (3,) in them or on them. Raises InvalidArgument.");
}

void add_nearest(WorldClass& type, const py::arg_v& filter) {
    const auto limit = py::arg("limit") = infinity;
    type.def(
        "nearest",
        [](SharedWorld& self, BodyId body, double most) {
            return self.ask([&](auto& world, auto&... memory) { return world.nearest(body, memory..., most); });
        },
        py::arg("what"), limit,
        "NearestBody to a body, among those within the limit with which it is not filtered out, or None. Of equal "
        "distances the least id. Raises InvalidArgument.");
    type.def(
        "nearest",
        [](SharedWorld& self, const PosedMesh& what, double most, const Filter& only) {
            return self.ask([&](auto& world, auto&... memory) {
                return world.nearest(*what.shape, what.pose, memory..., most, only);
            });
        },
        py::arg("what"), limit, filter, "NearestBody to a Mesh or Posed, or None.");
    type.def(
        "closest_pair",
        [](SharedWorld& self, double most) {
            return self.ask([&](auto& world, auto&... memory) { return world.closest_pair(memory..., most); });
        },
        limit, "ClosestPair of all that are not filtered out, within the limit, or None. Raises InvalidArgument.");
    type.def(
        "depths", [](SharedWorld& self) { return self.change([](World& world) { return world.depths(); }); },
        "Pairs of ConvexSolids that share a point: a list of BodyDepth. Raises SingularPose.");
    type.def(
        "solid_distances",
        [](SharedWorld& self, double most) {
            return self.change([&](World& world) { return world.solid_distances(most); });
        },
        py::arg("limit"), "Pairs of ConvexSolids within the limit: a list of SolidDistance. Raises SingularPose.");
}

template <class Line>
void add_hits(WorldClass& type, const py::arg_v& filter) {
    type.def(
        "first_hit",
        [](SharedWorld& self, const Line& line, const Filter& only) {
            return self.ask([&](auto& world, auto&... memory) { return world.first_hit(line, memory..., only); });
        },
        py::arg("line"), filter, "BodyHit of least real parameter of a Segment or Ray, or None.");
    type.def(
        "all_hits",
        [](SharedWorld& self, const Line& line, const Filter& only) {
            return self.ask([&](auto& world, auto&... memory) { return world.all_hits(line, memory..., only); });
        },
        py::arg("line"), filter, "All that a Segment or Ray hits: a list of BodyHit, by real parameter.");
}

void add_casts(WorldClass& type, const py::arg_v& filter) {
    const auto time_max = py::arg("time_max") = 1.0;
    type.def(
        "cast",
        [](SharedWorld& self, BodyId body, const Vec3& motion, double most) {
            return self.ask([&](auto& world, auto&... memory) { return world.cast(body, motion, memory..., most); });
        },
        py::arg("what"), py::arg("motion"), time_max,
        "BodyContact: what a body meets first while it is translated by time times motion (3,), up to time_max, or "
        "None. Nothing moves. Raises InvalidArgument.");
    type.def(
        "cast",
        [](SharedWorld& self, const PosedMesh& what, const Vec3& motion, double most, const Filter& only) {
            return self.ask([&](auto& world, auto&... memory) {
                return world.cast(*what.shape, what.pose, motion, memory..., most, only);
            });
        },
        py::arg("what"), py::arg("motion"), time_max, filter, "The same of a Mesh or Posed that is no body.");
    type.def(
        "meetings",
        [](SharedWorld& self, const py::object& bodies, const py::object& poses) {
            const auto ids = to_bodies(bodies);
            const auto places = to_poses(poses, ids);
            return self.ask([&](auto& world, auto&... memory) { return world.meetings(ids, places, memory...); });
        },
        py::arg("bodies"), py::arg("poses"),
        "All pairs that meet while these bodies (k,) go to new poses (k, 4, 4), each point straight from its old place "
        "to its new one, and the others stay: a list of Meeting, by time. Raises as set_poses() does.");
}

}  // namespace

void add_questions_about_everything(WorldClass& type) {
    const auto filter = py::arg("filter") = py::none();
    add_finding(type, filter);
    add_nearest(type, filter);
    add_hits<Segment>(type, filter);
    add_hits<Ray>(type, filter);
    add_casts(type, filter);
    type.def(
        "certify",
        [](SharedWorld& self) { return self.read([](const World& world) { return world.certify(thread_memory()); }); },
        "WorldCertificate of colliding_pairs() and close_pairs(). Raises NotUpdated.");
}

}  // namespace ecods::python
