// One picture: the parts of a clash in two colors, other parts faint, the contact highlighted and never hidden.
#pragma once

#include "programs/clash/picture/image.hpp"
#include "programs/clash/picture/scene.hpp"

namespace ecods::clash {

struct DrawOptions {
    double line_width = 2;   // of the marks of contact, in pixels
    double contours = 0.72;  // their opacity
};

// The scene as the camera, whose target is relative to the scene's origin, sees it.
Image draw(const ClashScene& scene, const Camera& camera, std::size_t width, std::size_t height,
           const DrawOptions& options);

// How much of a small picture shows what, as shares of its pixels.
struct Shares {
    double first = 0;
    double second = 0;
    double contact = 0;         // nothing in front of it
    double veiled_contact = 0;  // seen through a part

    // Both of it in each corner of the picture: upper right, upper left, lower right, lower left. A corner is as wide
    // and high as this part of the picture.
    static constexpr double corner_share = 0.36;
    std::array<double, 4> contact_in_corners{};
};
Shares shares_seen(const ClashScene& scene, const Camera& camera, std::size_t width, std::size_t height);

}  // namespace ecods::clash
