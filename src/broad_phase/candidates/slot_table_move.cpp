// Copies from the proxy table the boxes that moved, and lists the boxes that left their fat boxes.
#include "base/make_room.hpp"
#include "broad_phase/candidates/slot_table.hpp"
#include "simd/dispatch.hpp"

namespace ecods {

// Passes the arrays of a table to the loops below.
struct SlotView {
    PackedBox* lines;
    CoarseBox* coarse_boxes;  // null unless they are kept
    const PackedBox* fat_lines;
    const ProxyIndex* proxies;
    std::size_t size;
};

SlotView SlotTable::view() noexcept {
    return {lines_.data(), keeps_coarse_boxes() ? coarse_boxes_.data() : nullptr, fat_lines_.data(), proxies_.data(),
            size()};
}

namespace {

// Prefetches run this number of boxes ahead.
constexpr std::size_t boxes_ahead = 12;

// Prefetches a box that comes some slots later in a walk over all slots. The box may lie on two cache lines.
ECODS_ALWAYS_INLINE void prefetch_box_ahead(const SlotView& slots, const Aabb* boxes, std::size_t slot) noexcept {
    const auto* ahead = reinterpret_cast<const char*>(
        &boxes[slots.proxies[slot + boxes_ahead < slots.size ? slot + boxes_ahead : slots.size - 1]]);
    __builtin_prefetch(ahead);
    __builtin_prefetch(ahead + sizeof(Aabb) - 1);
}

// Returns true if `box` is inside its fat box. `lanes` is `box`, packed; the fat box is in the frame.
ECODS_ALWAYS_INLINE bool is_in_fat_box(const MovingFrame& frame, const PackedBox& fat_line, const Aabb& box,
                                       const BoxLanes& lanes) noexcept {
    if (frame.is_at_origin()) return contains(fat_line, lanes);
    BoxLanes in_frame;
    make_lanes(frame.of(box), in_frame);
    return contains(fat_line, in_frame);
}

// Gives a slot its new box, and appends the old one to `escaped` if the new one is not in the fat box. A free slot
// stays as it is.
ECODS_ALWAYS_INLINE void move_slot(const SlotView& slots, SlotIndex slot, const Aabb& box, const MovingFrame& frame,
                                   std::vector<EscapedBox>& escaped) {
    BoxLanes lanes;
    make_lanes(box, lanes);
    if (!is_in_fat_box(frame, slots.fat_lines[slot], box, lanes)) [[unlikely]] {
        if (slots.fat_lines[slot].is_empty()) return;
        escaped.push_back({slot, slots.lines[slot]});
    }
    store_lanes(lanes, slots.lines[slot]);
    if (slots.coarse_boxes != nullptr) make_coarse_box(lanes, slots.coarse_boxes[slot]);
}

ECODS_ALWAYS_INLINE void move_slots(const SlotView& slots, std::size_t begin, std::size_t end, const Aabb* boxes,
                                    const MovingFrame& moving_frame, std::vector<EscapedBox>& escaped) {
    const MovingFrame frame = moving_frame;
    for (std::size_t slot = begin; slot < end; ++slot) {
        prefetch_box_ahead(slots, boxes, slot);
        move_slot(slots, static_cast<SlotIndex>(slot), boxes[slots.proxies[slot]], frame, escaped);
    }
}

ECODS_ALWAYS_INLINE void move_slots_of(const SlotView& slots, const SlotIndex* slots_by_proxy,
                                       std::span<const ProxyIndex> proxies, const Aabb* boxes,
                                       const MovingFrame& moving_frame, std::vector<EscapedBox>& escaped) {
    const MovingFrame frame = moving_frame;
    for (std::size_t i = 0; i < proxies.size(); ++i) {
        if (i + boxes_ahead < proxies.size()) {
            const SlotIndex ahead = slots_by_proxy[proxies[i + boxes_ahead]];
            __builtin_prefetch(&slots.lines[ahead]);
            if (slots.coarse_boxes != nullptr) __builtin_prefetch(&slots.coarse_boxes[ahead]);
            __builtin_prefetch(&slots.fat_lines[ahead]);
        }
        move_slot(slots, slots_by_proxy[proxies[i]], boxes[proxies[i]], frame, escaped);
    }
}

ECODS_ALWAYS_INLINE void take_all_slots(const SlotView& slots, const Aabb* boxes) {
    for (std::size_t slot = 0; slot < slots.size; ++slot) {
        prefetch_box_ahead(slots, boxes, slot);
        if (slots.lines[slot].is_empty()) continue;  // a free slot
        make_packed_box(boxes[slots.proxies[slot]], slots.lines[slot]);
    }
}

}  // namespace

void SlotTable::move_range(std::size_t begin, std::size_t end, const ProxyTable& table, const MovingFrame& frame,
                           std::vector<EscapedBox>& escaped_boxes) {
    dispatch<move_slots>(view(), begin, end, table.boxes().data(), frame, escaped_boxes);
}

void SlotTable::move(std::span<const ProxyIndex> proxies, const ProxyTable& table, const MovingFrame& frame,
                     std::vector<EscapedBox>& escaped_boxes) {
    dispatch<move_slots_of>(view(), slots_.data(), proxies, table.boxes().data(), frame, escaped_boxes);
}

void SlotTable::take(std::span<const ProxyIndex> proxies, const ProxyTable& table) {
    release(coarse_boxes_);
    // If most boxes moved, a pass over all boxes in the order of memory costs less.
    if (2 * proxies.size() > size()) {
        dispatch<take_all_slots>(view(), table.boxes().data());
        return;
    }
    for (const ProxyIndex proxy : proxies) make_packed_box(table.boxes()[proxy], lines_[slots_[proxy]]);
}

}  // namespace ecods
