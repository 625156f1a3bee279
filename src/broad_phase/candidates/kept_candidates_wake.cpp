// Finds the candidates of boxes that wake up.
#include <algorithm>
#include <cstddef>

#include "broad_phase/candidates/kept_candidates.hpp"

namespace ecods {
namespace {

// Prefetches run this number of boxes ahead.
constexpr std::size_t woken_ahead = 6;

}  // namespace

// Wakes the boxes that begin to move, and adds their candidates. Call before boxes are moved.
void KeptCandidates::wake(const FindingUpdate& finding) {
    const auto& moved = finding.changes.moved;
    if (slots_.awake_count() == slots_.used_count() && moved.size() == slots_.used_count()) return;
    looked_up_.clear();
    for (const ProxyIndex proxy : moved) {
        const SlotIndex slot = slots_.slot_of(proxy);
        if (!slots_.has(slot, SlotTable::awake)) looked_up_.push_back(slot);
        slots_.note_moved(slot);
    }
    if (looked_up_.empty()) return;
    forest_.refresh(slots_.fat_lines());
    if (!std::is_sorted(looked_up_.begin(), looked_up_.end())) std::sort(looked_up_.begin(), looked_up_.end());
    widen_woken(finding.table);
    for (std::size_t begin = 0; begin < looked_up_.size(); begin += LookUps::part) {
        link_woken(begin, std::min(begin + LookUps::part, looked_up_.size()), finding.counts);
    }
    slots_.settle_woken(looked_up_);
}

// Wakes the boxes in looked_up_, and widens the fat boxes that they are about to leave. A box at rest usually has no
// margin: without a wider fat box, it would escape at once, and be looked up twice. The wider fat box still contains
// the box as it was. A box that jumps keeps its fat box: a fat box from the old place to the new one would stretch the
// bounds around it.
void KeptCandidates::widen_woken(const ProxyTable& table) {
    const auto lines = slots_.lines(), fat_lines = slots_.fat_lines();
    const bool are_in_space = margins_.frame().is_at_origin() && !margins_.frame().is_moving();
    old_fats_.clear();
    for (std::size_t i = 0; i < looked_up_.size(); ++i) {
        if (i + 2 * woken_ahead < looked_up_.size()) slots_.prefetch(looked_up_[i + 2 * woken_ahead]);
        if (i + woken_ahead < looked_up_.size()) {
            const SlotIndex ahead = looked_up_[i + woken_ahead];
            __builtin_prefetch(&table.boxes()[slots_.proxies()[ahead]]);
            forest_.prefetch(ahead);
        }
        const SlotIndex slot = looked_up_[i];
        const PackedBox line = lines[slot], old_fat = fat_lines[slot];
        old_fats_.push_back(old_fat);
        slots_.wake(slot);
        slots_.note_woken(slot);
        const Aabb& box = table.boxes()[slots_.proxies()[slot]];
        PackedBox now;
        make_packed_box(box, now);
        if (!are_in_space || contains(old_fat, now) || !overlap(line, now)) continue;
        PackedBox fat = margins_.fat_box({slot, line}, box, now, old_fat);
        enlarge(fat, line);
        slots_.widen(slot, fat);
        forest_.set(slot, fat);
    }
}

// Adds the new candidates of the slots looked_up_[begin] to looked_up_[end - 1], which wake up, with all boxes as they
// are before they move. A pair with a box that was awake already is in the list, unless the fat box of the woken box
// has grown towards that box.
void KeptCandidates::link_woken(std::size_t begin, std::size_t end, BroadPhaseCounts& counts) {
    const std::span woken = std::span<const SlotIndex>(looked_up_).subspan(begin, end - begin);
    const std::span old_fats = std::span<const PackedBox>(old_fats_).subspan(begin, end - begin);
    constexpr LookUps::Known known{.looked_up = SlotTable::woken, .has = SlotTable::awake};
    counts.box_tests += look_ups_.find(woken, old_fats, known, slots_, forest_.trees());
    for (const auto& [query, partner, overlaps] : look_ups_.found()) {
        // If the partner moved away in the last update, the list may still have the pair: only the next test drops it.
        // The box that wakes up has not moved away, since it was asleep.
        const bool moved_away = slots_.has(partner, SlotTable::awake) && slots_.has(partner, SlotTable::changed);
        if (moved_away && !slots_.has(partner, SlotTable::woken)) {
            candidates_.add_if_new(woken[query], partner);
        } else {
            candidates_.add(woken[query], partner, overlaps);
        }
    }
}

}  // namespace ecods
