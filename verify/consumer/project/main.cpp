#include <ecods/ecods.hpp>
#include <iostream>
#include <vector>

int main() {
    const std::vector<ecods::Vec3> vertices{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    const std::vector<ecods::Triangle> triangles{{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}};
    const auto corner = ecods::Mesh::create(vertices, triangles);
    ecods::World world;
    const auto a = world.create_body(corner, {});
    const auto b = world.create_body(corner, {});
    for (const double x : {5.0, 1.0, 0.5}) {
        world.set_pose(b, {.R = ecods::Mat3::Identity(), .t = {x, 0, 0}});
        world.update();
        std::cout << "at " << x << ": " << world.relation(a, b);
        std::cout << ", distance " << world.distance(a, b) << ", " << world.began().size() << " began\n";
    }
}
