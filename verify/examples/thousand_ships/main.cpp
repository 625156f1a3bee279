// A thousand ships that fly, turn and bounce in a room: which touch, as they move?
//
// usage: ecods_thousand_ships [PICTURE.pov]
#include <fmt/core.h>

#include <set>
#include <vector>

#include "ecods/world.hpp"
#include "examples/stage.hpp"
#include "scenes/room.hpp"

int main(int argc, char** argv) {
    namespace scenes = ecods::scenes;
    constexpr std::size_t ship_count = 1000;
    const scenes::Scene room = scenes::room(
        {.ship_count = ship_count, .frame_count = 100, .side = scenes::calibrated_side_by_density(ship_count)});

    // Bodies that are given the same mesh share its tree.
    ecods::World world;
    std::vector<ecods::BodyId> ships;
    for (const scenes::SceneBody& body : room.bodies)
        ships.push_back(world.create_body(room.meshes[body.mesh_index].mesh, body.pose));
    world.update();
    fmt::print("{} ships, {} touch another at the start\n", ships.size(), world.colliding_pairs().size());

    std::size_t began = 0, ended = 0;
    for (std::size_t i = 0; i < room.frames.size(); ++i) {
        for (const scenes::Move& move : room.frames[i].moves) world.set_pose(ships[move.body_index], move.pose);
        world.update();
        began += world.began().size();
        ended += world.ended().size();
        if ((i + 1) % 20 == 0) {
            fmt::print("frame {:3}: {} pairs touch; {} came and {} went since the last line\n", i + 1,
                       world.colliding_pairs().size(), began, ended);
            began = ended = 0;
        }
    }

    // Incremental is from scratch: a new world with the same poses gives the same answers.
    ecods::World fresh;
    for (const ecods::BodyId ship : ships) fresh.create_body(room.meshes[0].mesh, world.pose(ship));
    fresh.update();
    fmt::print("a fresh world agrees: {}\n", fresh.digest() == world.digest() ? "yes" : "no");

    if (argc > 1) {
        std::set<ecods::BodyId> touching;
        for (const ecods::BodyPair& pair : world.colliding_pairs()) touching.insert({pair.a, pair.b});
        using namespace ecods::examples;
        Stage stage({30, -38, 24}, {0, 0, -1}, 42);
        for (const ecods::BodyId ship : ships)
            stage.add(*room.meshes[0].mesh, world.pose(ship), touching.contains(ship) ? red : gray);
        stage.write(argv[1]);
    }
}
