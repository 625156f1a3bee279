// The ECoDS report's experiment: ships that fly, turn and bounce in a closed room.
#pragma once

#include <cstddef>
#include <cstdint>

#include "scenes/scene.hpp"

namespace ecods::scenes {

// The side of the cube in which the centres of the ships stay, such that a frame has about as many colliding and
// candidate pairs as in the report.
double calibrated_side();                              // for 32 ships; for any number, the report's case 1
double calibrated_side_by_density(std::size_t ships);  // as many ships to a volume as for 32: the report's case 2

struct RoomOptions {
    std::size_t ship_count = 32;
    std::size_t frame_count = 200;  // steps after the rest
    double side = calibrated_side();
    double moving_share = 1;  // the first so many of the ships move, rounded to a whole number; the others hover
    double speed_max = 0.12;  // per frame, along each axis
    double spin_max = 0.08;   // radians per frame
    std::uint32_t seed = 1;
};

// The walls turn a ship back as soon as its centre leaves the cube [-side / 2, side / 2]^3, so a wall of the room that
// is seen stands ship_radius() further out. The walls are no body, and ships fly through each other. All poses are
// computed here, once, and are the same on every machine; whoever runs the scene is given the same bits.
Scene room(const RoomOptions& options);

}  // namespace ecods::scenes
