// Binds World: its bodies and their properties.
#include "python/bind/world.hpp"

#include <string>
#include <variant>

#include "ecods/error.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"

namespace ecods::python {
namespace {

// Returns the pose to which a body is to move. An error names the body, like the errors of World::set_pose.
Pose pose_for(BodyId body, const py::object& pose) {
    try {
        return to_pose(pose);
    } catch (const InvalidArgument& error) {
        throw error.at(body);
    }
}

void add_bodies(WorldClass& type, const py::arg& body) {
    type.def(
        "create_body",
        [](SharedWorld& self, const AnyShape& mesh, const Pose& pose, std::uint64_t groups, std::uint64_t mask,
           std::uint64_t user_data) {
            const BodyOptions options{.shape = to_shape(mesh),
                                      .pose = pose,
                                      .filter = {.groups = groups, .mask = mask},
                                      .user_data = user_data};
            return self.change([&](World& world) { return world.create_body(options); });
        },
        py::arg("mesh"), py::arg("pose") = py::none(), py::kw_only(), py::arg("groups") = CollisionFilter{}.groups,
        py::arg("mask") = CollisionFilter{}.mask, py::arg("user_data") = 0,
        "Makes a body of a Mesh, Solid, ConvexSolid, Rounded or HalfSpace, and returns its id, an int. Bodies of one "
        "Mesh share "
        "its tree. `groups` and `mask` are bits: two "
        "bodies may meet if each is in a group that the other's mask names. Raises InvalidArgument.");
    type.def("destroy_body", changing(&World::destroy_body), body,
             "Destroys a body; its id is stale from now on. Raises StaleBody, as every call that is given an id does.");
    type.def(
        "set_pose",
        [](SharedWorld& self, BodyId id, const py::object& pose) {
            const Pose place = pose_for(id, pose);
            self.change([&](World& world) { world.set_pose(id, place); });
        },
        body, py::arg("pose"),
        "Moves a body: at once for questions, and at update() for the lists. Raises InvalidArgument.");
    type.def(
        "set_poses",
        [](SharedWorld& self, const py::object& bodies, const py::object& poses) {
            const auto ids = to_bodies(bodies);
            const auto places = to_poses(poses, ids);
            self.change([&](World& world) { world.set_poses(ids, places); });
        },
        py::arg("bodies"), py::arg("poses"),
        "Moves many bodies, (k,) ids and (k, 4, 4) or (k, 3, 4) poses: all of them, or none if it raises "
        "InvalidArgument or StaleBody, with the index of the entry.");
    type.def(
        "set_shape",
        [](SharedWorld& self, BodyId id, const AnyShape& mesh) {
            self.change([&](World& world) { world.set_shape(id, to_shape(mesh)); });
        },
        body, py::arg("mesh"),
        "Gives a body another Mesh, Rounded or HalfSpace; Mesh.refit() makes one for a mesh that deforms.");
    type.def("set_user_data", changing(&World::set_user_data), body, py::arg("data"),
             "Stores a number of the caller's, below 2**64, with the body.");
    type.def("reserve", changing(&World::reserve), py::arg("body_count"), "Reserves memory for so many bodies.");
}

void add_facts(WorldClass& type, const py::arg& body) {
    type.def(
        "is_alive",
        [](SharedWorld& self, const AnyId& id) {
            return self.read([&](const World& world) { return world.is_alive(id.body); });
        },
        body, "True if the id names a body of this world.");
    type.def("pose", reading(&World::pose), body, "The pose set last, (4, 4) float64.");
    const auto shape = [](const SharedWorld& self, BodyId id) {
        return to_any_shape(reading(&World::shape)(self, id));
    };
    type.def("shape", shape, body, "The Mesh, Solid, ConvexSolid, Rounded or HalfSpace set last.");
    type.def(
        "mesh",
        [shape](const SharedWorld& self, BodyId id) {
            const AnyShape found = shape(self, id);
            if (const auto* mesh = std::get_if<std::shared_ptr<MeshShape>>(&found)) return *mesh;
            throw NotSupported("slot " + std::to_string(id.slot) +
                               ": its body is a Rounded or a HalfSpace, and no mesh; see shape()");
        },
        body, "The Mesh, Solid or ConvexSolid set last. Raises NotSupported for a Rounded or a HalfSpace.");
    type.def(
        "posed",
        [shape](const SharedWorld& self, BodyId id) {
            const Pose pose = reading(&World::pose)(self, id);
            return std::visit(
                [&](auto one) -> std::variant<PosedMesh, PosedRounded, PosedHalfSpace> {
                    return Posed(std::move(one), pose);
                },
                shape(self, id));
        },
        body, "The body as a Posed, PosedRounded or PosedHalfSpace, for questions that need no world.");
    type.def("box", reading(&World::box), body, "A box (2, 3) that contains the body.");
    type.def("user_data", reading(&World::user_data), body, "The number given last; 0 at first.");
    type.def(
        "bodies", [](SharedWorld& self) { return from_bodies(reading(&World::bodies)(self)); },
        "All ids, ascending: (n,) uint64.");
    type.def("__len__", [](SharedWorld& self) {
        return self.read([](const World& world) { return world.statistics().body_count; });
    });
}

void add_filters(WorldClass& type, const py::arg& body) {
    type.def(
        "set_filter",
        [](SharedWorld& self, BodyId id, std::uint64_t groups, std::uint64_t mask) {
            self.change([&](World& world) { world.set_filter(id, {.groups = groups, .mask = mask}); });
        },
        body, py::arg("groups"), py::arg("mask"),
        "Sets the groups that a body is in, `groups`, and the groups that it meets, `mask`, as bits.");
    type.def("filter", reading(&World::filter), body, "The CollisionFilter set last.");
    type.def("set_pair_enabled", changing(&World::set_pair_enabled), py::arg("a"), py::arg("b"), py::arg("is_enabled"),
             "Switches one pair off, or on again. Raises SameBody.");
    type.def("is_pair_enabled", reading(&World::is_pair_enabled), py::arg("a"), py::arg("b"),
             "True unless set_pair_enabled() switched the pair off, whatever the filters are.");
}

}  // namespace

void bind_world(py::module_& m) {
    add_record(m, "CollisionFilter", "The groups that a body is in, and the groups that it meets, as bits.",
               Field{"groups", &CollisionFilter::groups, "The groups that the body is in."},
               Field{"mask", &CollisionFilter::mask, "The groups that the body meets."})
        .def(py::init([](std::uint64_t groups, std::uint64_t mask) {
                 return CollisionFilter{.groups = groups, .mask = mask};
             }),
             py::arg("groups") = CollisionFilter{}.groups, py::arg("mask") = CollisionFilter{}.mask);
    WorldClass type(m, "World",
                    "Many moving bodies: which of them touch, which come close, and which is the nearest? Changes take "
                    "effect at once for questions, and at update() for the lists. Any thread may call; calls that only "
                    "ask run beside each other. A copy, or a pickle, has the present bodies under the same ids, with "
                    "their filters, data and switched pairs, the clearance and the options; ids that were stale are "
                    "stale in the copy, too. The copy is like a world before its first update, and is not traced. "
                    "Copies share the meshes. The cost is that of creating the bodies.");
    type.def(
        py::init<BroadPhaseKind, std::size_t>(), py::arg("broad_phase") = "automatic", py::arg("threads") = 1,
        "`threads` is the number of threads that run the two-body tests of update(), closest_pairs(), depths() and "
        "signed_distances(). No answer depends on `broad_phase` or on `threads`.");
    const py::arg body("body");
    add_bodies(type, body);
    add_facts(type, body);
    add_filters(type, body);
    add_lists(type);
    add_pair_questions(type);
    add_questions_about_everything(type);
    add_trace_calls(type);
    add_copying(type);
}

}  // namespace ecods::python
