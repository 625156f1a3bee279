// The place from which a clash is seen.
#pragma once

#include "programs/clash/picture/scene.hpp"

namespace ecods::clash {

// Two cameras of one direction, their targets relative to the scene's origin.
struct Views {
    Camera near;          // the contact fills a good part of the picture
    Camera whole;         // both parts as wholes
    bool is_one = false;  // the contact is large enough in the whole: the near one is the same
};

// Of some directions, the one in which most of the contact and enough of both parts is seen; the first of the best.
Views choose_views(const ClashScene& scene, double aspect);

// The same from a fixed direction, without looking: for clashes of which no picture is made.
Views default_views(const ClashScene& scene, double aspect);

}  // namespace ecods::clash
