// Meshes and bodies as FCL has them, in double precision. A scene has one BVHModel of OBBRSS nodes for each mesh,
// shared by its bodies.
#pragma once

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/shape/convex.h>
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

// A workload's meshes, each by its index.
template <class Volume>
using FclModels = std::vector<std::shared_ptr<fcl::BVHModel<Volume>>>;

template <class Volume>
FclModels<Volume> to_fcl_models(const std::vector<scenes::NamedMesh>& meshes) {
    FclModels<Volume> models;
    for (const scenes::NamedMesh& named : meshes) models.push_back(to_fcl_model<Volume>(named));
    return models;
}

// A convex mesh.
inline std::shared_ptr<fcl::Convexd> to_fcl_convex(const Mesh& mesh) {
    const auto vertices =
        std::make_shared<const std::vector<fcl::Vector3d>>(mesh.vertices().begin(), mesh.vertices().end());
    const auto faces = std::make_shared<std::vector<int>>();
    for (const Triangle& t : mesh.triangles()) {
        faces->push_back(3);
        for (const std::uint32_t index : t) faces->push_back(static_cast<int>(index));
    }
    auto convex = std::make_shared<fcl::Convexd>(vertices, static_cast<int>(mesh.triangles().size()), faces);
    convex->computeLocalAABB();
    return convex;
}

// Bodies, each with its index as its user data.
class FclObjects {
  public:
    void add(const std::shared_ptr<fcl::CollisionGeometryd>& geometry, const fcl::Transform3d& transform) {
        objects_.push_back(std::make_unique<fcl::CollisionObjectd>(geometry, transform));
        objects_.back()->setUserData(reinterpret_cast<void*>(static_cast<std::uintptr_t>(objects_.size() - 1)));
        objects_.back()->computeAABB();
        all_.push_back(objects_.back().get());
    }

    std::size_t size() const { return objects_.size(); }
    fcl::CollisionObjectd& operator[](std::size_t index) { return *objects_[index]; }
    const std::vector<fcl::CollisionObjectd*>& all() const { return all_; }

  private:
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects_;
    std::vector<fcl::CollisionObjectd*> all_;
};

inline FclObjects to_fcl(const scenes::Scene& scene) {
    const auto models = to_fcl_models<fcl::OBBRSSd>(scene.meshes);
    FclObjects objects;
    for (const scenes::SceneBody& body : scene.bodies) objects.add(models[body.mesh_index], to_fcl(body.pose));
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
