// Bodies with trees, and which of their triangles the walk from the roots lets through: what is never to be separated.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "ecods/ids.hpp"
#include "environment/instruction_sets.hpp"
#include "unit/bvh/tree_body.hpp"

namespace ecods {

// overlap_mask(), once it is the same for every instruction set.
template <class X, class Y>
std::uint64_t near_lanes_of_all(const std::array<AxisSet, 2>& sets, const X& x, const Y& y) {
    const std::uint64_t near = overlap_mask(sets, x, y);
    for (const InstructionSet set : environment::supported_instruction_sets()) {
        const environment::InstructionSetLimit limit(set);
        EXPECT_EQ(overlap_mask(sets, x, y), near) << environment::name(set);
    }
    return near;
}

inline bool let_through(const Body& a, const Body& b, std::uint32_t i, std::uint32_t j) {
    SeparatingAxes axes;
    if (axes.bind(a.posed(), b.posed(), b.pose.t - a.pose.t) >= 0) return false;
    const auto mask = [&](const auto& x, const auto& y) { return near_lanes_of_all(axes.sets(), x, y); };
    return let_through(a, b, mask, i, j);
}

inline bool let_through_in_every_rounding_mode(const Body& a, const Body& b, std::uint32_t i, std::uint32_t j) {
    bool all = true;
    for (const int mode : rounding_modes) {
        std::fesetround(mode);
        all = all && let_through(a, b, i, j) && let_through(b, a, j, i);
    }
    std::fesetround(FE_TONEAREST);
    return all;
}

// The pairs of triangles that share a point, without a tree.
inline std::vector<TrianglePair> pairs_of(const Body& a, const Body& b) {
    std::vector<TrianglePair> pairs;
    for (std::uint32_t i = 0; i < a.mesh->triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < b.mesh->triangles().size(); ++j) {
            if (triangle_triangle(a.posed_triangle(i), b.posed_triangle(j)) != Relation::apart) {
                pairs.push_back({i, j});
            }
        }
    }
    return pairs;
}

// Moves b towards a along a line until the last double at which they still touch: a contact that is as thin as can be.
// The line begins at `start`, where they touch.
inline void bring_into_contact(const Body& a, Body& b, const Vec3& direction, const Vec3& start) {
    double touching = 0, apart = 8;
    for (int i = 0; i < 70; ++i) {
        const double middle = 0.5 * touching + 0.5 * apart;
        b.pose.t = start + middle * direction;
        (pairs_of(a, b).empty() ? apart : touching) = middle;
    }
    b.pose.t = start + touching * direction;
}
inline void bring_into_contact(const Body& a, Body& b, const Vec3& direction) {
    bring_into_contact(a, b, direction, a.pose.t);
}

}  // namespace ecods
