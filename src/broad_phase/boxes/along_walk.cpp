#include "broad_phase/boxes/along_walk.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <vector>

#include "broad_phase/boxes/tree_parts.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

constexpr std::uint32_t width = BoxBlock::width;
constexpr double infinity = std::numeric_limits<double>::infinity();

using Numbers = Vec<double, 4>;

using Course = MovingBox::Course;

// Computes `from`, which is MovingBox::meets_from of each box of a block, in the same steps for eight boxes at once.
// The time is infinity for a box that is never met, and for an empty lane.
struct BlockTimes {
    static_assert(width == 8);
    Numbers from[2], to[2];
    KeyLanes never[2];

    ECODS_ALWAYS_INLINE BlockTimes(const BoxBlock& block, const MovingBox& moving) noexcept {
        for (std::size_t half = 0; half < 2; ++half) {
            from[half] = broadcast<Numbers>(0);
            to[half] = broadcast<Numbers>(infinity);
            never[half] = lanes(&block.ends[0][4 * half]) == PackedBox::unreachable;
        }
        take<true>(&block.ends[0], &moving.sides()[0]);
        take<false>(&block.ends[3], &moving.sides()[3]);
        for (std::size_t half = 0; half < 2; ++half) {
            never[half] |= from[half] - MovingBox::time_min > to[half];
            from[half] = select(never[half], broadcast<Numbers>(infinity),
                                min(from[half], broadcast<Numbers>(MovingBox::number_max)));
        }
    }

    // Applies three sides of the moving box, whose partners are the minima of the block's boxes, or the maxima. For a
    // maximum of key k, MovingBox compares -k with the side's key, whereas the block stores ~k = -k - 1.
    template <bool are_minima>
    ECODS_ALWAYS_INLINE void take(const std::array<std::int64_t, width>* ends, const MovingBox::Side* sides) noexcept {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto [course, end, key, factor] = sides[k];
            if (course == Course::without_end) continue;
            const KeyLanes keys[2] = {lanes(&ends[k][0]), lanes(&ends[k][4])};
            if (course == Course::coming) {
                for (std::size_t half = 0; half < 2; ++half) {
                    const Numbers at = doubles_of(are_minima ? keys[half] : ~keys[half]);
                    const Numbers gap = are_minima ? at - end : -end - at;
                    const Numbers counted = min(broadcast<Numbers>(MovingBox::number_max), gap);
                    from[half] = max((counted - MovingBox::gap_min) * factor, from[half]);
                }
                continue;
            }
            for (std::size_t half = 0; half < 2; ++half) never[half] |= keys[half] > (are_minima ? key : key - 1);
            if (course == Course::resting) continue;
            for (std::size_t half = 0; half < 2; ++half) {
                const Numbers at = doubles_of(are_minima ? keys[half] : ~keys[half]);
                const Numbers left = are_minima ? end - at : at + end;
                to[half] = min((left + MovingBox::gap_min) * factor, to[half]);
            }
        }
    }
};

ECODS_ALWAYS_INLINE void meet_all_lanes(const BoxBlock& block, const MovingBox& moving, double* from) noexcept {
    const BlockTimes times(block, moving);
    store(from, times.from[0]);
    store(from + 4, times.from[1]);
}

class Walk {
  public:
    Walk(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const MovingBox& moving, double limit,
         const std::function<double(SlotIndex)>& visit)
        : trees_(trees), boxes_(boxes), moving_(moving), limit_(MovingBox::latest(limit)), visit_(visit) {}

    // Visits boxes in the order of their times, and returns the number of box tests. The next part mostly lies in the
    // part that was opened last, so its first child is kept in `next`, and only the other children are queued.
    ECODS_ALWAYS_INLINE std::uint64_t run() {
        for (std::uint32_t tree = 0; tree < trees_.size(); ++tree) {
            const std::uint32_t height = trees_[tree].level_count() + BoundedPart::position;
            if (trees_[tree].alive_count() > 0) waiting_.push({0, height, 0, tree});
        }
        while (!waiting_.is_empty() && waiting_.front().lower() <= limit_) {
            BoundedPart next = waiting_.pop();
            bool counts = true;
            while (counts && next.height() != BoundedPart::box) {
                counts = look_into(next);
                if (!counts || waiting_.is_empty() || next < waiting_.front()) continue;
                const BoundedPart first = waiting_.front();
                waiting_.replace_front(next);
                next = first;
            }
            if (counts) limit_ = std::min(limit_, MovingBox::latest(visit_(next.index())));
        }
        return tests_;
    }

  private:
    // Replaces `part`, a block or a position, by the first part in it, and queues the other parts in it. Returns false
    // if no part in it is met up to the limit.
    ECODS_ALWAYS_INLINE bool look_into(BoundedPart& part) {
        return part.height() == BoundedPart::position ? look_at_box(part) : open(part);
    }

    // Replaces a position by the box there, and returns false if the box is not met up to the limit. The tree has a fat
    // box; the box of the slot is read only now, since many positions never get here.
    ECODS_ALWAYS_INLINE bool look_at_box(BoundedPart& part) {
        const SlotIndex slot = trees_[part.tree()].slot(part.index());
        part = {moving_.meets_from(boxes_[slot]), BoundedPart::box, slot, part.tree()};
        ++tests_;
        return part.lower() <= std::min(limit_, MovingBox::number_max);
    }

    ECODS_ALWAYS_INLINE bool open(BoundedPart& part) {
        const std::uint32_t height = part.height(), index = part.index(), tree = part.tree();
        const BlockTimes block(trees_[tree].block(height - BoundedPart::block, index), moving_);
        const double latest = std::min(limit_, MovingBox::number_max);
        auto found = static_cast<std::uint32_t>(any_bits(((block.from[0] <= latest) & lane_bits<KeyLanes>(0)) |
                                                         ((block.from[1] <= latest) & lane_bits<KeyLanes>(4))));
        tests_ += width;
        if (found == 0) return false;
        alignas(64) double from[width];
        store(&from[0], block.from[0]);
        store(&from[4], block.from[1]);
        const auto inner = [&](std::uint32_t lane) -> BoundedPart {
            return {from[lane], height - 1, index * width + lane, tree};
        };
        if (height == BoundedPart::block) prefetch_boxes(tree, index, found);
        part = inner(static_cast<std::uint32_t>(std::countr_zero(found)));
        for (found &= found - 1; found != 0; found &= found - 1) {
            const BoundedPart other = inner(static_cast<std::uint32_t>(std::countr_zero(found)));
            const bool is_first = other < part;
            waiting_.push(is_first ? part : other);
            part = is_first ? other : part;
        }
        return true;
    }

    ECODS_ALWAYS_INLINE void prefetch_boxes(std::uint32_t tree, std::uint32_t index, std::uint32_t lanes) const {
        for (; lanes != 0; lanes &= lanes - 1) {
            const auto lane = static_cast<std::uint32_t>(std::countr_zero(lanes));
            __builtin_prefetch(&boxes_[trees_[tree].slot(index * width + lane)]);
        }
    }

    std::span<const BoxTree> trees_;
    std::span<const Aabb> boxes_;
    const MovingBox& moving_;
    double limit_;
    const std::function<double(SlotIndex)>& visit_;
    Waiting<BoundedPart> waiting_{8 * width};
    std::uint64_t tests_ = 0;
};

}  // namespace

void meet_block(const BoxBlock& block, const MovingBox& moving, std::array<double, BoxBlock::width>& from) {
    alignas(64) double lanes[BoxBlock::width];
    dispatch<meet_all_lanes>(block, moving, &lanes[0]);
    std::ranges::copy(lanes, from.begin());
}

std::uint64_t walk_along(std::span<const BoxTree> trees, std::span<const Aabb> boxes, const MovingBox& moving,
                         double limit, const std::function<double(SlotIndex)>& visit) {
    Walk walk(trees, boxes, moving, limit, visit);
    return dispatch<&Walk::run>(walk);
}

}  // namespace ecods
