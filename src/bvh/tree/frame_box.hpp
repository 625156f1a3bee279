// A FrameBox is a box in the coordinates of a local frame, for building and refitting trees. Its vectors have four
// floats, of which three are used.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <utility>

#include "base/next.hpp"
#include "base/outward.hpp"
#include "bvh/tree/mesh_bvh.hpp"
#include "simd/vec.hpp"

namespace ecods {

using Float4 = Vec<float, 4>;

struct FrameBox {
    static constexpr float infinity = std::numeric_limits<float>::infinity();

    Float4 min{infinity, infinity, infinity, infinity};
    Float4 max{-infinity, -infinity, -infinity, -infinity};

    void include(const FrameBox& box) noexcept {
        min = ecods::min(min, box.min);
        max = ecods::max(max, box.max);
    }
    // Returns half of the surface area of the box.
    float surface() const noexcept {
        const Float4 e = max - min;
        return e[0] * e[1] + e[1] * e[2] + e[2] * e[0];
    }
};

// Returns a box that contains the triangle: the box of its corners as computed, enlarged by their error bound,
// coordinate_error. The box is infinite if the frame is unbounded.
inline FrameBox box_of(const Mesh& mesh, const Triangle& triangle, const LocalFrame& frame) {
    FrameBox box;
    if (!frame.is_bounded) {
        std::swap(box.min, box.max);
        return box;
    }
    Vec3 min = frame.coordinates(mesh.vertices()[triangle[0]]);
    Vec3 max = min;
    for (const std::size_t k : {1u, 2u}) {
        const Vec3 y = frame.coordinates(mesh.vertices()[triangle[k]]);
        min = min.cwiseMin(y);
        max = max.cwiseMax(y);
    }
    for (int k = 0; k < 3; ++k) {
        box.min[k] = round_down(min[k] - coordinate_error);
        box.max[k] = round_up(max[k] + coordinate_error);
    }
    box.min[3] = box.max[3] = 0;
    return box;
}

// Sets the center and the half size of a box on one axis to an interval that contains [min, max].
inline void set_span(float min, float max, float& center, float& half) noexcept {
    center = max == FrameBox::infinity ? 0 : 0.5f * min + 0.5f * max;
    const double c = static_cast<double>(center);
    half = round_up(next_up(std::max(static_cast<double>(max) - c, c - static_cast<double>(min))));
}

inline void set_lane(BvhNode& node, std::size_t lane, const FrameBox& box) noexcept {
    for (std::size_t k = 0; k < 3; ++k) set_span(box.min[k], box.max[k], node.center[k][lane], node.half[k][lane]);
}

inline void set_root(MeshBvh& tree, const FrameBox& box) noexcept {
    for (std::size_t k = 0; k < 3; ++k) set_span(box.min[k], box.max[k], tree.root_center[k], tree.root_half[k]);
}

}  // namespace ecods
