#include "broad_phase/candidates/slot_table.hpp"

#include <algorithm>
#include <string>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"
#include "ecods/error.hpp"

namespace ecods {

void SlotTable::reserve(std::size_t count) {
    lines_.reserve(count);
    fat_lines_.reserve(count);
    proxies_.reserve(count);
    flags_.reserve(count);
    slots_.reserve(count);
}

// Makes or drops the coarse boxes. Making the coarse boxes takes a pass over all boxes. The pass is amortized, since
// coarse boxes are dropped only after a pass that puts boxes to sleep, and that pass is amortized over many updates.
void SlotTable::choose_coarse_boxes() {
    constexpr std::size_t few = 64, some = 32;  // one box in this many is awake
    if (keeps_coarse_boxes() && few * awake_count_ < used_count_) release(coarse_boxes_);
    if (keeps_coarse_boxes() || some * awake_count_ < used_count_) return;
    coarse_boxes_.reserve(lines_.capacity());
    coarse_boxes_.resize(lines_.size());
    for (SlotIndex slot = 0; slot < size(); ++slot) make_coarse_box(lines_[slot], coarse_boxes_[slot]);
}

void SlotTable::prefetch(SlotIndex slot) const noexcept {
    __builtin_prefetch(&proxies_[slot]);
    __builtin_prefetch(&lines_[slot]);
    __builtin_prefetch(&fat_lines_[slot], 1);
}

SlotIndex SlotTable::add(ProxyIndex proxy, const Aabb& box) {
    if (slots_.size() <= proxy) {
        make_room(slots_, std::size_t{proxy} + 1 - slots_.size());
        slots_.resize(std::size_t{proxy} + 1, no_slot);
    }
    if (free_slots_.empty()) {
        const std::size_t count = lines_.size() + 1;
        grow_to(lines_, count);
        if (keeps_coarse_boxes()) grow_to(coarse_boxes_, count);
        grow_to(fat_lines_, count);
        grow_to(proxies_, count);
        grow_to(flags_, count);
        free_slots_.push_back(static_cast<SlotIndex>(count - 1));
    }
    const SlotIndex slot = free_slots_.back();
    free_slots_.pop_back();
    make_packed_box(box, lines_[slot]);
    if (keeps_coarse_boxes()) make_coarse_box(lines_[slot], coarse_boxes_[slot]);
    proxies_[slot] = proxy;
    slots_[proxy] = slot;
    ++used_count_;
    return slot;
}

void SlotTable::remove(SlotIndex slot) {
    lines_[slot] = {};
    if (keeps_coarse_boxes()) coarse_boxes_[slot] = {};
    fat_lines_[slot] = {};
    slots_[proxies_[slot]] = no_slot;
    --used_count_;
    if (has(slot, awake)) --awake_count_;
    note_changed(slot);
    flags_[slot] = changed;
}

std::size_t SlotTable::count_asleep(std::span<const ProxyIndex> proxies) const noexcept {
    if (awake_count_ == used_count_) return 0;
    return static_cast<std::size_t>(
        std::count_if(proxies.begin(), proxies.end(), [&](ProxyIndex proxy) { return !has(slots_[proxy], awake); }));
}

void SlotTable::wake(SlotIndex slot) noexcept {
    if (!has(slot, awake)) ++awake_count_;
    flags_[slot] |= awake | moved;
}

void SlotTable::settle_woken(std::span<const SlotIndex> slots) noexcept {
    for (const SlotIndex slot : slots) clear(slot, woken);
}

void SlotTable::widen(SlotIndex slot, const PackedBox& fat) {
    note_changed(slot);
    fat_lines_[slot] = fat;
}

void SlotTable::put_all_to_sleep() noexcept {
    if (awake_count_ > 0) std::fill(flags_.begin(), flags_.end(), std::uint8_t{0});
    awake_count_ = 0;
}

// Puts to sleep the awake boxes at rest, once these boxes have cost as much work as the pass that puts boxes to sleep.
bool SlotTable::put_resting_to_sleep(std::size_t moved_count) noexcept {
    constexpr std::uint64_t patience = 16;
    if (moved_count < awake_count_) updates_at_rest_ += awake_count_ - moved_count;
    if (updates_at_rest_ <= patience * awake_count_) return false;
    updates_at_rest_ = 0;
    for (SlotIndex slot = 0; slot < flags_.size(); ++slot) {
        if (has(slot, awake) && !has(slot, moved)) {
            clear(slot, awake);
            --awake_count_;
        }
        clear(slot, moved);
    }
    return true;
}

void SlotTable::settle_escaped(std::span<const EscapedBox> escaped_boxes) {
    for (const EscapedBox& box : escaped_boxes) {
        clear(box.slot, escaped);
        note_changed(box.slot);
    }
}

void SlotTable::note_changed(SlotIndex slot) {
    if (has(slot, changed)) return;
    changed_slots_.push_back(slot);
    flags_[slot] |= changed;
}

void SlotTable::settle_all_escaped() noexcept {
    for (std::uint8_t& flags : flags_) flags &= static_cast<std::uint8_t>(~escaped);
}

void SlotTable::mark_changed() noexcept {
    for (const SlotIndex slot : changed_slots_) coarse_boxes_[slot].mark();
}

void SlotTable::forget_changes() {
    for (const SlotIndex slot : changed_slots_) {
        if (keeps_coarse_boxes()) coarse_boxes_[slot].unmark();
        clear(slot, changed);
        if (is_free(slot)) free_slots_.push_back(slot);
    }
    changed_slots_.clear();
}

void SlotTable::reorder(std::span<const SlotIndex> order) {
    reorder_values(lines_, order);
    if (keeps_coarse_boxes()) reorder_values(coarse_boxes_, order);
    reorder_values(fat_lines_, order);
    reorder_values(proxies_, order);
    reorder_values(flags_, order);
    for (SlotIndex slot = 0; slot < order.size(); ++slot) slots_[proxies_[slot]] = slot;
    free_slots_.clear();
}

std::size_t SlotTable::bytes() const noexcept {
    return bytes_of(lines_, fat_lines_) + bytes_of(coarse_boxes_) +
           bytes_of(proxies_, slots_, free_slots_, changed_slots_) + bytes_of(flags_);
}

void SlotTable::validate(const ProxyTable& table, const MovingFrame& frame, bool has_margins) const {
    const auto require = [](bool holds, SlotIndex slot, const char* what) {
        if (!holds) throw BrokenInvariant("kept candidates, slot " + std::to_string(slot) + ": " + what);
    };
    std::size_t used_count = 0, awake_count = 0;
    for (SlotIndex slot = 0; slot < lines_.size(); ++slot) {
        require(!has(slot, escaped | woken), slot, "flags of an update are left");
        require(has(slot, changed) == (std::count(changed_slots_.begin(), changed_slots_.end(), slot) == 1), slot,
                "the changed slots are not those with the flag");
        if (is_free(slot)) {
            require(!keeps_coarse_boxes() || coarse_boxes_[slot] == CoarseBox{}, slot,
                    "it is free and has a coarse box");
            require((!has_margins || fat_lines_[slot].is_empty()) && !has(slot, awake), slot, "it is free and in use");
            require(std::count(free_slots_.begin(), free_slots_.end(), slot) == 1, slot, "it is not listed as free");
            continue;
        }
        ++used_count;
        awake_count += has(slot, awake) ? 1 : 0;
        const ProxyIndex proxy = proxies_[slot];
        require(table.is_present(proxy) && slots_[proxy] == slot, slot, "its proxy is not here");
        require(lines_[slot] == packed_box(key_box(table.box(proxy))), slot, "its box is not the proxy's");
        CoarseBox coarse;
        for (std::size_t end = 0; end < 6; ++end) {
            coarse.ends[end < 3 ? end : end + 1] = static_cast<std::int32_t>(lines_[slot].ends[end] >> 32);
        }
        require(!keeps_coarse_boxes() || coarse_boxes_[slot] == coarse, slot,
                "its coarse box is another one's, or marked");
        if (!has_margins) continue;
        // Compares keys of doubles, not lanes of registers, so that the check finds errors in the computation of lanes.
        const KeyBox in_frame = key_box(frame.of(table.box(proxy))), fat = key_box(fat_lines_[slot]);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            require(fat.min[axis] <= in_frame.min[axis] && in_frame.max[axis] <= fat.max[axis], slot,
                    "it is not in its fat box");
        }
    }
    if (used_count != table.size() || used_count != used_count_)
        throw BrokenInvariant("kept candidates: the number of slots in use is wrong");
    if (awake_count != awake_count_) throw BrokenInvariant("kept candidates: the number of slots awake is wrong");
    if (free_slots_.size() + used_count != lines_.size()) throw BrokenInvariant("kept candidates: a slot is lost");
}

}  // namespace ecods
