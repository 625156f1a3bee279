// A scene as FCL has it, in double precision: one BVHModel of OBBRSS nodes for each mesh, shared by its bodies.
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/collision_object.h>

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <vector>

#include "scenes/scene.hpp"

namespace ecods::bench {

inline fcl::Transform3d to_fcl(const Pose& pose) {
    fcl::Transform3d transform = fcl::Transform3d::Identity();
    transform.linear() = pose.R;
    transform.translation() = pose.t;
    return transform;
}

// The index of a body rides in its user data.
inline std::size_t index_of(const fcl::CollisionObjectd& object) {
    return static_cast<std::size_t>(reinterpret_cast<std::uintptr_t>(object.getUserData()));
}

template <class Volume>
std::shared_ptr<fcl::BVHModel<Volume>> to_fcl_model(const scenes::NamedMesh& named) {
    std::vector<fcl::Vector3d> vertices(named.mesh->vertices().begin(), named.mesh->vertices().end());
    std::vector<fcl::Triangle> triangles;
    for (const Triangle& t : named.mesh->triangles()) triangles.emplace_back(t[0], t[1], t[2]);
    auto model = std::make_shared<fcl::BVHModel<Volume>>();
    const bool made =
        model->beginModel(static_cast<int>(triangles.size()), static_cast<int>(vertices.size())) == fcl::BVH_OK &&
        model->addSubModel(vertices, triangles) == fcl::BVH_OK && model->endModel() == fcl::BVH_OK;
    if (!made) throw std::runtime_error("FCL cannot build a tree for mesh '" + named.name + "'");
    model->computeLocalAABB();
    return model;
}

inline std::vector<std::unique_ptr<fcl::CollisionObjectd>> to_fcl(const scenes::Scene& scene) {
    std::vector<std::shared_ptr<fcl::BVHModel<fcl::OBBRSSd>>> models;
    for (const scenes::NamedMesh& named : scene.meshes) models.push_back(to_fcl_model<fcl::OBBRSSd>(named));

    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
    for (const scenes::SceneBody& body : scene.bodies) {
        auto object = std::make_unique<fcl::CollisionObjectd>(models[body.mesh_index], to_fcl(body.pose));
        object->setUserData(reinterpret_cast<void*>(static_cast<std::uintptr_t>(objects.size())));
        object->computeAABB();
        objects.push_back(std::move(object));
    }
    return objects;
}

inline void move(fcl::CollisionObjectd& object, const Pose& pose) {
    object.setTransform(to_fcl(pose));
    object.computeAABB();
}

// The boolean query: FCL stops at the first contact, and computes nothing about it.
inline bool collide(const fcl::CollisionObjectd& a, const fcl::CollisionObjectd& b) {
    const fcl::CollisionRequestd request(1, false);
    fcl::CollisionResultd result;
    return fcl::collide(&a, &b, request, result) > 0;
}

}  // namespace ecods::bench
