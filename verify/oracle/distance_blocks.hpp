// Triangles in blocks of neighbours, with boxes around them: most pairs of a large mesh are left out a block at a time.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "oracle/features.hpp"

namespace ecods::oracle {

struct Box {
    std::array<double, 3> min, max;
};

// A lower bound of the squared distance of two boxes of numbers no larger than one. Needs a FloatEnvironment.
double lower_bound(const Box& a, const Box& b);

struct TriangleBlocks {
    struct Block {
        Box box;
        std::uint32_t begin, end;  // of `order`
    };
    std::vector<std::uint32_t> order;  // indices of triangles
    std::vector<Box> boxes;            // [place in order]
    std::vector<Block> blocks;

    TriangleBlocks(std::span<const Triangle> triangles, const std::vector<Vector<Interval>>& vertices);
};

struct BlockPair {
    double lower;
    std::uint32_t a, b;
};

// All of them, the nearest first. Needs a FloatEnvironment.
std::vector<BlockPair> block_pairs(const TriangleBlocks& a, const TriangleBlocks& b);

// Calls visit for each pair of triangles of the two blocks whose boxes may be as near as `upper`, which it may lower.
template <class Visit>
void for_each_pair(const TriangleBlocks& a, const TriangleBlocks& b, const BlockPair& blocks, const double& upper,
                   const Visit& visit) {
    const auto& block_a = a.blocks[blocks.a];
    const auto& block_b = b.blocks[blocks.b];
    for (std::uint32_t i = block_a.begin; i < block_a.end; ++i) {
        if (lower_bound(a.boxes[i], block_b.box) > upper) continue;
        for (std::uint32_t j = block_b.begin; j < block_b.end; ++j) {
            if (lower_bound(a.boxes[i], b.boxes[j]) <= upper) visit(TrianglePair{a.order[i], b.order[j]});
        }
    }
}

}  // namespace ecods::oracle
