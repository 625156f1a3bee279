// Binds the copying and pickling of World. The state of a world is data from which calls make the same world again,
// with the same ids.
#include <array>
#include <map>

#include "ecods/error.hpp"
#include "python/bind/world.hpp"

namespace ecods::python {
namespace {

constexpr int state_version = 2;

using Numbers = py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>;

// A Scene holds the present state of a world; lists by body are in the order of `bodies`.
struct Scene {
    std::vector<BodyId> bodies;
    std::vector<BodyId> next_ids;
    std::vector<AnyShape> meshes;  // each shape once
    std::vector<std::uint64_t> mesh_of;
    std::vector<Pose> poses;
    std::vector<std::uint64_t> groups, masks, data;
    std::vector<BodyPair> disabled;
    std::optional<double> clearance;
    bool are_relations_listed = false;
};

Scene scene_of(const World& world) {
    Scene scene;
    scene.bodies = world.bodies();
    scene.next_ids = world.next_ids();
    std::map<const void*, std::uint64_t> known;
    for (const BodyId body : scene.bodies) {
        const auto shape = world.shape(body);
        const auto [at, is_new] = known.emplace(shape.get(), scene.meshes.size());
        if (is_new) scene.meshes.push_back(to_any_shape(shape));
        scene.mesh_of.push_back(at->second);
        scene.poses.push_back(world.pose(body));
        scene.groups.push_back(world.filter(body).groups);
        scene.masks.push_back(world.filter(body).mask);
        scene.data.push_back(world.user_data(body));
    }
    scene.disabled = world.disabled_pairs();
    scene.clearance = world.clearance();
    scene.are_relations_listed = world.are_relations_listed();
    return scene;
}

py::array_t<double> from_poses(const std::vector<Pose>& poses) {
    py::array_t<double> array({static_cast<py::ssize_t>(poses.size()), py::ssize_t{3}, py::ssize_t{4}});
    double* out = array.mutable_data();
    for (const Pose& pose : poses) {
        for (int i = 0; i < 12; ++i) *out++ = i % 4 == 3 ? pose.t[i / 4] : pose.R(i / 4, i % 4);
    }
    return array;
}

std::vector<std::uint64_t> to_numbers(const py::object& value) {
    const auto array = value.cast<Numbers>();
    return {array.data(), array.data() + array.size()};
}

py::tuple state_of(const SharedWorld& self) {
    const Scene scene = self.read(&scene_of);
    return py::make_tuple(state_version, self.broad_phase(), self.threads(), from_bodies(scene.bodies),
                          from_bodies(scene.next_ids), scene.meshes, from_numbers(scene.mesh_of),
                          from_poses(scene.poses), from_numbers(scene.groups), from_numbers(scene.masks),
                          from_numbers(scene.data), scene.disabled, scene.clearance, scene.are_relations_listed);
}

[[noreturn]] void refuse_state() {
    throw py::value_error("World: the state of another version of ecods");
}

Scene scene_from(const py::tuple& state) {
    if (state.size() != 14 || state[0].cast<int>() != state_version) refuse_state();
    Scene scene;
    scene.bodies = to_bodies(state[3]);
    scene.next_ids = to_bodies(state[4]);
    scene.meshes = state[5].cast<std::vector<AnyShape>>();
    scene.mesh_of = to_numbers(state[6]);
    scene.poses = to_poses(state[7], scene.bodies);
    scene.groups = to_numbers(state[8]);
    scene.masks = to_numbers(state[9]);
    scene.data = to_numbers(state[10]);
    scene.disabled = state[11].cast<std::vector<BodyPair>>();
    scene.clearance = state[12].cast<std::optional<double>>();
    scene.are_relations_listed = state[13].cast<bool>();
    for (const std::size_t count :
         {scene.mesh_of.size(), scene.poses.size(), scene.groups.size(), scene.masks.size(), scene.data.size()}) {
        if (count != scene.bodies.size()) refuse_state();
    }
    for (const std::uint64_t mesh : scene.mesh_of) {
        if (mesh >= scene.meshes.size()) refuse_state();
    }
    return scene;
}

void make(const Scene& scene, World& world) {
    world.reserve(scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        const CollisionFilter filter{.groups = scene.groups[i], .mask = scene.masks[i]};
        world.create_body({.shape = to_shape(scene.meshes[scene.mesh_of[i]]),
                           .pose = scene.poses[i],
                           .filter = filter,
                           .user_data = scene.data[i]});
    }
    for (const BodyPair& pair : scene.disabled) world.set_pair_enabled(pair.a, pair.b, false);
    world.set_clearance(scene.clearance);
    world.set_relations(scene.are_relations_listed);
}

std::unique_ptr<SharedWorld> made_of(const py::tuple& state) {
    const Scene scene = scene_from(state);
    std::vector<BodyId> ids = scene.bodies;
    ids.insert(ids.end(), scene.next_ids.begin(), scene.next_ids.end());
    auto made =
        std::make_unique<SharedWorld>(state[1].cast<BroadPhaseKind>(), state[2].cast<std::size_t>(), std::move(ids));
    made->change([&](World& world) { make(scene, world); });
    return made;
}

std::string world_text(const SharedWorld& self) {
    const std::size_t count = self.read([](const World& world) { return world.statistics().body_count; });
    return "<ecods.World of " + std::to_string(count) + (count == 1 ? " body, " : " bodies, ") +
           std::string(py::str(py::cast(self.broad_phase()))) + ", " + std::to_string(self.threads()) +
           (self.threads() == 1 ? " thread>" : " threads>");
}

}  // namespace

void add_copying(WorldClass& type) {
    type.def(py::pickle(&state_of, &made_of));
    type.def("__repr__", &world_text);
}

}  // namespace ecods::python
