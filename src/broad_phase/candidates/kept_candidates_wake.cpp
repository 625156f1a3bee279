// The candidates of boxes that awake.
#include <algorithm>
#include <cstddef>

#include "broad_phase/candidates/kept_candidates.hpp"

namespace ecods {
namespace {

// How many boxes ahead memory is asked for.
constexpr std::size_t woken_ahead = 6, found_ahead = 8;

}  // namespace

// Before boxes move: the candidates of those that do, and did not until now.
void KeptCandidates::wake(const FindingUpdate& finding) {
    const auto& moved = finding.changes.moved;
    if (slots_.awake_count() == slots_.used_count() && moved.size() == slots_.used_count()) return;
    woken_.clear();
    for (const ProxyIndex proxy : moved) {
        const SlotIndex slot = slots_.slot_of(proxy);
        if (!slots_.has(slot, SlotTable::awake)) woken_.push_back(slot);
        slots_.note_moved(slot);
    }
    if (woken_.empty()) return;
    forest_.refresh(slots_.fat_lines());
    if (!std::is_sorted(woken_.begin(), woken_.end())) std::sort(woken_.begin(), woken_.end());
    widen_woken(finding.table);
    const std::span<const SlotIndex> woken = woken_;
    const std::span<const PackedBox> old_fats = old_fats_;
    for (std::size_t begin = 0; begin < woken.size(); begin += LookUps::part) {
        const std::size_t count = std::min(LookUps::part, woken.size() - begin);
        link_woken(woken.subspan(begin, count), old_fats.subspan(begin, count), finding.counts);
    }
    slots_.settle_woken(woken_);
}

// What lay at rest has no margin, as a rule, and would escape at once, and be looked up twice. So those that are about
// to leave their fat boxes get others first, that contain what they were, too. Those that jump get none: a box from
// here to there would stretch the bounds around it.
void KeptCandidates::widen_woken(const ProxyTable& table) {
    const auto lines = slots_.lines(), fat_lines = slots_.fat_lines();
    const bool are_in_space = margins_.frame().is_at_origin() && !margins_.frame().is_moving();
    old_fats_.clear();
    for (std::size_t i = 0; i < woken_.size(); ++i) {
        if (i + 2 * woken_ahead < woken_.size()) slots_.prefetch(woken_[i + 2 * woken_ahead]);
        if (i + woken_ahead < woken_.size()) {
            const SlotIndex ahead = woken_[i + woken_ahead];
            __builtin_prefetch(&table.boxes()[slots_.proxies()[ahead]]);
            forest_.prefetch(ahead);
        }
        const SlotIndex slot = woken_[i];
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

// Adds the candidates of boxes that awake, as they are before boxes move. Those of boxes that were awake already are
// there, unless the fat box has grown towards them; of two that awake, the first does it.
void KeptCandidates::link_woken(std::span<const SlotIndex> woken, std::span<const PackedBox> old_fats,
                                BroadPhaseCounts& counts) {
    const auto lines = slots_.lines(), fat_lines = slots_.fat_lines();
    auto& [reaches, visits, found] = look_ups_;
    reaches.resize(woken.size());
    for (std::size_t i = 0; i < woken.size(); ++i) make_reach(fat_lines[woken[i]], reaches[i]);
    found.clear();
    counts.box_tests += forest_.find_each(reaches, visits, found);
    BoxReach reach;
    for (std::size_t i = 0; i < found.size(); ++i) {
        slots_.prefetch(found[std::min(i + found_ahead, found.size() - 1)].slot);
        const auto [query, partner] = found[i];
        const SlotIndex slot = woken[query];
        if (slots_.has(partner, SlotTable::woken) && partner <= slot) continue;
        if (slots_.has(partner, SlotTable::awake) && !slots_.has(partner, SlotTable::woken)) {
            make_reach(old_fats[query], reach);
            if (overlaps(fat_lines[partner], reach)) continue;
        }
        make_reach(lines[slot], reach);
        candidates_.add(slot, partner, overlaps(lines[partner], reach));
    }
}

}  // namespace ecods
