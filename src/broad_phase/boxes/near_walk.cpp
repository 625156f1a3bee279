#include "broad_phase/boxes/near_walk.hpp"

#include <algorithm>
#include <compare>
#include <utility>
#include <vector>

#include "geometry/box_distance.hpp"

namespace ecods {
namespace {

constexpr std::uint32_t width = BoxBlock::width;

// A block of a tree, or a box. Orders by size, boxes last: what is equally near is opened before a box is visited, and
// boxes come in the order of their slots.
struct Part {
    std::uint32_t height = 0;  // 0: a box, otherwise the block's level and one
    std::uint32_t index = 0;   // of the block in its level, or the box's slot
    std::uint32_t tree = 0;

    bool is_box() const noexcept { return height == 0; }
    friend constexpr bool operator==(const Part&, const Part&) = default;
};

struct PartBox {
    Part part;
    Aabb box;
};

class Parts {
  public:
    Parts(std::span<const BoxTree> trees, std::span<const Aabb> boxes) : trees_(trees), boxes_(boxes) {}

    std::vector<Part> roots() const {
        std::vector<Part> roots;
        for (std::uint32_t tree = 0; tree < trees_.size(); ++tree) {
            if (trees_[tree].alive_count() > 0) roots.push_back({trees_[tree].level_count(), 0, tree});
        }
        return roots;
    }

    Aabb box_of(const Part& part) const {
        return part.is_box() ? boxes_[part.index]
                             : ecods::box_of(trees_[part.tree].block(part.height - 1, part.index).bounds());
    }

    // What lies in a block: up to eight.
    std::span<const PartBox> open(const Part& part, std::array<PartBox, width>& lanes) const {
        const BoxTree& tree = trees_[part.tree];
        const BoxBlock& block = tree.block(part.height - 1, part.index);
        std::size_t count = 0;
        for (std::uint32_t lane = 0; lane < width; ++lane) {
            const PackedBox line = block.get(lane);
            if (line.is_empty()) continue;
            const std::uint32_t child = part.index * width + lane;
            if (part.height > 1) {
                lanes[count++] = {{part.height - 1, child, part.tree}, ecods::box_of(line)};
            } else {
                const SlotIndex slot = tree.slot(child);
                lanes[count++] = {{0, slot, part.tree}, boxes_[slot]};
            }
        }
        return std::span(lanes).first(count);
    }

  private:
    std::span<const BoxTree> trees_;
    std::span<const Aabb> boxes_;
};

// What waits, the least first.
template <class Item>
class Waiting {
  public:
    void push(const Item& item) {
        items_.push_back(item);
        std::push_heap(items_.begin(), items_.end(), later);
    }
    Item pop() {
        std::pop_heap(items_.begin(), items_.end(), later);
        const Item item = items_.back();
        items_.pop_back();
        return item;
    }
    bool has_below(double limit) const { return !items_.empty() && items_.front().lower <= limit; }

  private:
    static bool later(const Item& a, const Item& b) { return b.comes_before(a); }
    std::vector<Item> items_;
};

struct NearPart {
    double lower;
    Part part;

    bool comes_before(const NearPart& other) const noexcept {
        if (lower != other.lower) return lower < other.lower;
        if (part.height != other.part.height) return part.height > other.part.height;
        return part.index < other.part.index;
    }
};

struct NearPair {
    double lower;
    Part a, b;

    std::uint32_t height() const noexcept { return std::max(a.height, b.height); }
    bool comes_before(const NearPair& other) const noexcept {
        if (lower != other.lower) return lower < other.lower;
        if (height() != other.height()) return height() > other.height();
        return std::pair(a.index, b.index) < std::pair(other.a.index, other.b.index);
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
        while (waiting_.has_below(limit_)) {
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
    // The pairs within a block.
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
    Waiting<NearPair> waiting_;
    std::array<PartBox, width> lanes_;
    std::uint64_t tests_ = 0;
};

}  // namespace

std::uint64_t walk_near(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const Aabb& box, double limit,
                        const std::function<double(SlotIndex)>& visit) {
    const Parts parts(trees, boxes);
    Waiting<NearPart> waiting;
    for (const Part& root : parts.roots()) waiting.push({0, root});
    std::array<PartBox, width> lanes;
    std::uint64_t tests = 0;
    while (waiting.has_below(limit)) {
        const Part part = waiting.pop().part;
        if (part.is_box()) {
            limit = std::min(limit, visit(part.index));
            continue;
        }
        for (const PartBox& found : parts.open(part, lanes)) {
            ++tests;
            const double lower = distance_below(box, found.box);
            if (lower <= limit) waiting.push({lower, found.part});
        }
    }
    return tests;
}

std::uint64_t walk_near_pairs(std::span<const BoxTree> trees, std::span<const Aabb> boxes, double limit,
                              const std::function<double(SlotIndex, SlotIndex)>& visit) {
    return PairWalk(trees, boxes, limit).run(visit);
}

}  // namespace ecods
