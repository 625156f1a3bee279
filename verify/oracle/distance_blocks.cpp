#include "oracle/distance_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace ecods::oracle {
namespace {

Box nothing() {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

void add(Box& box, const std::array<double, 3>& min, const std::array<double, 3>& max) {
    for (std::size_t k = 0; k < 3; ++k) {
        box.min[k] = std::min(box.min[k], min[k]);
        box.max[k] = std::max(box.max[k], max[k]);
    }
}

Box box_of(const Triangle& triangle, const std::vector<Vector<Interval>>& vertices) {
    Box box = nothing();
    for (const std::uint32_t v : triangle) {
        const auto& p = vertices[v];
        add(box, {p[0].inf(), p[1].inf(), p[2].inf()}, {p[0].sup(), p[1].sup(), p[2].sup()});
    }
    return box;
}

}  // namespace

// Rounding is upwards: what is to be rounded downwards is negative.
double lower_bound(const Box& a, const Box& b) {
    double minus_square = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double minus_gap = std::min(a.max[k] - b.min[k], b.max[k] - a.min[k]);
        if (minus_gap < 0) minus_square += minus_gap * -minus_gap;
    }
    return -minus_square;
}

// Halved along the longest side until blocks are small; the number of pairs of blocks is that of the pairs in one, or
// so.
TriangleBlocks::TriangleBlocks(std::span<const Triangle> triangles, const std::vector<Vector<Interval>>& vertices)
    : order(triangles.size()) {
    std::vector<Box> of_triangle;
    for (const Triangle& triangle : triangles) of_triangle.push_back(box_of(triangle, vertices));
    std::iota(order.begin(), order.end(), 0);
    const auto size_max = static_cast<std::uint32_t>(4 + std::sqrt(static_cast<double>(triangles.size())) / 4);
    std::vector<std::array<std::uint32_t, 2>> open{{0, static_cast<std::uint32_t>(order.size())}};
    while (!open.empty()) {
        const auto [begin, end] = open.back();
        open.pop_back();
        Box box = nothing();
        for (std::uint32_t i = begin; i < end; ++i) add(box, of_triangle[order[i]].min, of_triangle[order[i]].max);
        if (end - begin <= size_max) {
            blocks.push_back({box, begin, end});
            continue;
        }
        std::size_t axis = 0;
        for (std::size_t k = 1; k < 3; ++k) {
            if (box.max[k] - box.min[k] > box.max[axis] - box.min[axis]) axis = k;
        }
        const std::uint32_t middle = begin + (end - begin) / 2;
        std::nth_element(
            order.begin() + begin, order.begin() + middle, order.begin() + end,
            [&](std::uint32_t i, std::uint32_t j) { return of_triangle[i].min[axis] < of_triangle[j].min[axis]; });
        open.push_back({begin, middle});
        open.push_back({middle, end});
    }
    for (const std::uint32_t i : order) boxes.push_back(of_triangle[i]);
}

std::vector<BlockPair> block_pairs(const TriangleBlocks& a, const TriangleBlocks& b) {
    std::vector<BlockPair> pairs;
    for (std::uint32_t i = 0; i < a.blocks.size(); ++i) {
        for (std::uint32_t j = 0; j < b.blocks.size(); ++j) {
            pairs.push_back({lower_bound(a.blocks[i].box, b.blocks[j].box), i, j});
        }
    }
    std::ranges::sort(pairs, {}, &BlockPair::lower);
    return pairs;
}

}  // namespace ecods::oracle
