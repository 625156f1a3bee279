// Pictures of clashes, and the cameras from which they are taken.
#pragma once

#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "programs/clash/picture/camera.hpp"
#include "programs/clash/report.hpp"

namespace ecods::clash {

// In the order of the report's clashes, of the first ones.
struct Picture {
    Camera camera;    // in the report's coordinates
    std::string png;  // the bytes of a file
};

constexpr std::size_t picture_width = 480;
constexpr std::size_t picture_height = 320;

// Whether this program was built with libpng.
bool can_make_pictures() noexcept;

// Pictures of the first `count` clashes, or of all if there are fewer. A picture depends on the report alone, not on
// the number of jobs. `step` is called after each, from any thread. Throws std::runtime_error if
// can_make_pictures() is false.
std::vector<Picture> make_pictures(const ClashReport& report, std::size_t count, std::size_t jobs,
                                   const std::function<void()>& step);

// From where a clash is shown of which there is no picture.
Camera camera_without_picture(const ClashReport& report, const Clash& clash);

}  // namespace ecods::clash
