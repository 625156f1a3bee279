#include "fuzz/scene.hpp"

#include "fuzz/failure.hpp"

namespace ecods::fuzz {

void Scene::create(const std::shared_ptr<const Mesh>& mesh, const Pose& pose) {
    const BodyId id = worlds[0].create_body(mesh, pose);
    require(worlds[1].create_body(mesh, pose) == id, "ids", "two worlds with one history gave different ids");
    bodies.push_back({.id = id, .mesh = mesh, .pose = pose});
}

void Scene::destroy(std::size_t index) {
    for (World& world : worlds) world.destroy_body(bodies[index].id);
    dead.push_back(bodies[index].id);
    bodies.erase(bodies.begin() + static_cast<std::ptrdiff_t>(index));
}

void Scene::set_pose(std::size_t index, const Pose& pose) {
    Body& body = bodies[index];
    for (World& world : worlds) world.set_pose(body.id, pose);
    body = {.id = body.id, .mesh = body.mesh, .pose = pose};
}

void Scene::set_mesh(std::size_t index, const std::shared_ptr<const Mesh>& mesh) {
    Body& body = bodies[index];
    for (World& world : worlds) world.set_shape(body.id, mesh);
    body = {.id = body.id, .mesh = mesh, .pose = body.pose};
}

void Scene::update() {
    for (World& world : worlds) world.update();
}

}  // namespace ecods::fuzz
