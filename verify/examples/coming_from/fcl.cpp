// A program for FCL; ecods.cpp is the same for ECoDS, line by line.
#include <fcl/fcl.h>
#include <fmt/core.h>

#include <cmath>

#include "scenes/shapes.hpp"

namespace {

using Model = fcl::BVHModel<fcl::OBBRSSd>;

std::shared_ptr<Model> model_of(const ecods::Mesh& mesh) {
    auto model = std::make_shared<Model>();
    std::vector<fcl::Triangle> triangles;
    for (const ecods::Triangle& t : mesh.triangles()) triangles.emplace_back(t[0], t[1], t[2]);
    model->beginModel();
    model->addSubModel({mesh.vertices().begin(), mesh.vertices().end()}, triangles);
    model->endModel();
    return model;
}

}  // namespace

int main() {
    const auto torus = model_of(*ecods::scenes::torus(32, 16, 0.3));
    fcl::CollisionObjectd still(torus), moved(torus);
    for (const double x : {3.0, 2.0, 1.0}) {
        fcl::Transform3d pose = fcl::Transform3d::Identity();
        pose.translation() = fcl::Vector3d(x, 0.1, 0.2);
        moved.setTransform(pose);
        moved.computeAABB();

        fcl::CollisionRequestd ask(100'000, true);
        fcl::CollisionResultd answer;
        const std::size_t count = fcl::collide(&still, &moved, ask, answer);
        fcl::DistanceRequestd ask_distance(true);
        fcl::DistanceResultd distance;
        if (count == 0) fcl::distance(&still, &moved, ask_distance, distance);
        fmt::print("{}: {}, {} pairs of triangles, distance {:.9f}\n", x, count > 0 ? "collide" : "apart", count,
                   count > 0 ? 0 : distance.min_distance);
    }

    fcl::DynamicAABBTreeCollisionManagerd manager;
    fcl::Transform3d pose = fcl::Transform3d::Identity();
    std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
    for (int i = 0; i < 8; ++i) {
        pose.translation() = fcl::Vector3d(1.9 * i, 0.1 * i, 0.2);
        objects.push_back(std::make_unique<fcl::CollisionObjectd>(torus, pose));
        manager.registerObject(objects.back().get());
    }
    manager.setup();
    int pair_count = 0;
    manager.collide(&pair_count, [](fcl::CollisionObjectd* a, fcl::CollisionObjectd* b, void* data) {
        fcl::CollisionRequestd ask;
        fcl::CollisionResultd answer;
        if (fcl::collide(a, b, ask, answer) > 0) ++*static_cast<int*>(data);
        return false;
    });
    fmt::print("{} pairs of {} collide\n", pair_count, objects.size());
}
