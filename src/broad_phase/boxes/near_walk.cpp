#include "broad_phase/boxes/near_walk.hpp"

#include <algorithm>
#include <tuple>
#include <vector>

#include "broad_phase/boxes/tree_parts.hpp"
#include "bvh/walks/waiting.hpp"
#include "geometry/box_distance.hpp"

namespace ecods {
namespace {

struct NearPair {
    double lower;
    Part a, b;

    std::uint32_t height() const noexcept { return std::max(a.height, b.height); }
    friend bool operator<(const NearPair& x, const NearPair& y) noexcept {
        return std::tuple(x.lower, y.height(), x.a.index, x.b.index) <
               std::tuple(y.lower, x.height(), y.a.index, y.b.index);
    }
};

class PairWalk {
  public:
    PairWalk(std::span<const BoxTree> trees, std::span<const Aabb> boxes, double limit)
        : parts_(trees, boxes), limit_(limit) {}

    std::uint64_t run(const std::function<double(SlotIndex, SlotIndex)>& visit) {
        const std::vector<Part> roots = parts_.roots();
        for (std::size_t i = 0; i < roots.size(); ++i) {
            for (std::size_t j = i; j < roots.size(); ++j) waiting_.push({0, roots[i], roots[j]});
        }
        while (!waiting_.is_empty() && waiting_.front().lower <= limit_) {
            const NearPair pair = waiting_.pop();
            if (pair.height() == 0) {
                limit_ = std::min(limit_, visit(pair.a.index, pair.b.index));
            } else if (pair.a == pair.b) {
                open(pair.a);
            } else {
                pair.a.height >= pair.b.height ? open(pair.a, pair.b) : open(pair.b, pair.a);
            }
        }
        return tests_;
    }

  private:
    // Queues the pairs of children of a block, and for child blocks also the pair of each child with itself.
    void open(const Part& part) {
        const auto found = parts_.open(part, lanes_);
        for (std::size_t i = 0; i < found.size(); ++i) {
            if (!found[i].part.is_box()) waiting_.push({0, found[i].part, found[i].part});
            for (std::size_t j = i + 1; j < found.size(); ++j) wait(found[i], found[j]);
        }
    }
    void open(const Part& part, const Part& other) {
        const PartBox whole{other, parts_.box_of(other)};
        for (const PartBox& found : parts_.open(part, lanes_)) wait(found, whole);
    }
    void wait(const PartBox& a, const PartBox& b) {
        ++tests_;
        const double lower = distance_below(a.box, b.box);
        if (!(lower <= limit_)) return;
        const bool is_swapped = a.part.is_box() && b.part.is_box() && b.part.index < a.part.index;
        waiting_.push(is_swapped ? NearPair{lower, b.part, a.part} : NearPair{lower, a.part, b.part});
    }

    Parts parts_;
    double limit_;
    Waiting<NearPair> waiting_{8 * BoxBlock::width};
    std::array<PartBox, BoxBlock::width> lanes_;
    std::uint64_t tests_ = 0;
};

}  // namespace

std::uint64_t walk_near(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const Aabb& box, double limit,
                        const std::function<double(SlotIndex)>& visit) {
    const Parts parts(trees, boxes);
    Waiting<BoundedPart> waiting(8 * BoxBlock::width);
    const auto wait = [&](double lower, const Part& part) {
        if (lower <= limit) waiting.push({lower, part.height, part.index, part.tree});
    };
    for (const Part& root : parts.roots()) wait(0, root);
    std::array<PartBox, BoxBlock::width> lanes;
    std::uint64_t tests = 0;
    while (!waiting.is_empty() && waiting.front().lower() <= limit) {
        const BoundedPart next = waiting.pop();
        const Part part{next.height(), next.index(), next.tree()};
        if (part.is_box()) {
            limit = std::min(limit, visit(part.index));
            continue;
        }
        const auto found = parts.open(part, lanes);
        tests += found.size();
        for (const PartBox& inner : found) wait(distance_below(box, inner.box), inner.part);
    }
    return tests;
}

std::uint64_t walk_near_pairs(std::span<const BoxTree> trees, std::span<const Aabb> boxes, double limit,
                              const std::function<double(SlotIndex, SlotIndex)>& visit) {
    return PairWalk(trees, boxes, limit).run(visit);
}

}  // namespace ecods
