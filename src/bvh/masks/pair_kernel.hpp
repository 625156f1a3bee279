// Tests eight lanes of a node against eight of another, on the two sets of axes and on the slabs of both. A measure
// says what is tested: whether lanes overlap, are near, or may meet.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

#include "bvh/masks/projected_lanes.hpp"
#include "simd/dispatch.hpp"

// Defines a function of two nodes for all kinds of them: INSTANCE(X, Y) is its explicit instantiation.
#define ECODS_FOR_ALL_NODES(INSTANCE) \
    INSTANCE(BvhNode, BvhNode)        \
    INSTANCE(BvhNode, TreeLeaf)       \
    INSTANCE(TreeLeaf, BvhNode)       \
    INSTANCE(TreeLeaf, TreeLeaf)

#define ECODS_TEXT "bvh/masks/pair_kernel_text.hpp"
#include "simd/each_set.hpp"
