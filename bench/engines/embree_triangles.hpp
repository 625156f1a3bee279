// Embree's device, triangles as it has them, and segments as its rays.
#pragma once

#include <embree3/rtcore.h>

#include <span>

#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"

namespace ecods::bench {

// Of one thread, and without wider instructions than ECoDS is limited to. Throws std::runtime_error if Embree gives
// none. Release it.
RTCDevice make_embree_device();

// A scene of one geometry, ready to be asked. Release it.
RTCScene make_embree_scene(RTCDevice device, std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                           RTCSceneFlags flags);

// From the segment's first end, in units of its length.
RTCRayHit to_embree(const Segment& segment);

}  // namespace ecods::bench
