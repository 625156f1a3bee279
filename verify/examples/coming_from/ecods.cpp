// The program of fcl.cpp for ECoDS.
#include <fmt/core.h>

#include <memory>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/world.hpp"
#include "scenes/shapes.hpp"

int main() {
    const auto mesh = ecods::scenes::torus(32, 16, 0.3);
    const ecods::MeshShape torus(mesh);
    for (const double x : {3.0, 2.0, 1.0}) {
        const ecods::Posed<ecods::MeshShape> still(torus, {}), moved(torus, {.t = {x, 0.1, 0.2}});
        const std::size_t count = intersecting_triangles(still, moved).size();
        fmt::print("{}: {}, {} pairs of triangles, distance {:.9f}\n", x, count > 0 ? "collide" : "apart", count,
                   distance(still, moved));
    }

    ecods::World world;
    for (int i = 0; i < 8; ++i) world.create_body(mesh, {.t = {1.9 * i, 0.1 * i, 0.2}});
    world.update();
    fmt::print("{} pairs of {} collide\n", world.colliding_pairs().size(), world.bodies().size());
}
