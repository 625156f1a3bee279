#include <ecods/ecods.hpp>

#include <iostream>

int main() {
    const auto tetrahedron =
        ecods::Mesh::create({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
    ecods::World world;
    const auto a = world.create_body(tetrahedron, {});
    const auto b = world.create_body(tetrahedron, {.R = ecods::Mat3::Identity(), .t = {5, 0, 0}});
    for (const double x : {5.0, 1.0, 0.5}) {
        world.set_pose(b, {.R = ecods::Mat3::Identity(), .t = {x, 0, 0}});
        world.update();
        std::cout << "at " << x << ": " << world.colliding_pairs().size() << " pair, " << world.began().size()
                  << " began, " << world.intersecting_triangles(a, b).size() << " triangle pairs\n";
    }
    try {
        world.set_pose(a, {.R = ecods::Mat3::Identity() / 0.0, .t = {}});
    } catch (const ecods::Error& error) {
        std::cout << error.what() << '\n';
    }
}
