// PairKernel tests the eight lanes of a node against the eight lanes of another, on two sets of axes and on the slabs
// of both nodes. A class Measure defines the test: if lanes overlap, are near, or may meet.
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

// Instantiates a function of two nodes for all kinds of nodes: INSTANCE(X, Y) must be one explicit instantiation.
#define ECODS_FOR_ALL_NODES(INSTANCE) \
    INSTANCE(BvhNode, BvhNode)        \
    INSTANCE(BvhNode, TreeLeaf)       \
    INSTANCE(TreeLeaf, BvhNode)       \
    INSTANCE(TreeLeaf, TreeLeaf)

#define ECODS_TEXT "bvh/masks/pair_kernel_text.hpp"
#include "simd/each_set.hpp"
