// Finds the candidates of boxes that were added, or left their fat boxes.
#include <algorithm>
#include <utility>

#include "broad_phase/candidates/kept_candidates.hpp"

namespace ecods {
namespace {

// Prefetches run this number of boxes ahead.
constexpr std::size_t escaped_ahead = 6;

bool has_lower_slot(const EscapedBox& a, const EscapedBox& b) noexcept {
    return a.slot < b.slot;
}

}  // namespace

// Gives escaped_[index] a new fat box, and returns the old fat box. Appends the slot to fattened_.far if the box is new
// or far from where it was: it then gets a new position in the forest, since at the old position it would stretch the
// bounds around it.
PackedBox KeptCandidates::fatten(std::size_t index, const ProxyTable& table) {
    if (index + 2 * escaped_ahead < escaped_.size()) slots_.prefetch(escaped_[index + 2 * escaped_ahead].slot);
    if (index + escaped_ahead < escaped_.size()) {
        __builtin_prefetch(&table.boxes()[slots_.proxies()[escaped_[index + escaped_ahead].slot]]);
    }
    const EscapedBox& escaped = escaped_[index];
    const SlotIndex slot = escaped.slot;
    const PackedBox old_fat = slots_.fat_lines()[slot];
    const PackedBox fat =
        margins_.fat_box(escaped, table.boxes()[slots_.proxies()[slot]], slots_.lines()[slot], old_fat);
    slots_.set_fat(slot, fat);
    if (old_fat.is_empty() || !overlap(old_fat, fat)) fattened_.far.push_back(slot);
    return old_fat;
}

void KeptCandidates::search_escaped(Update& update) {
    if (escaped_.empty()) return;
    rebuild_.note_looked_up(escaped_.size());
    if (!std::is_sorted(escaped_.begin(), escaped_.end(), has_lower_slot)) {
        std::sort(escaped_.begin(), escaped_.end(), has_lower_slot);
    }
    old_fats_.clear();
    looked_up_.clear();
    for (std::size_t i = 0; i < escaped_.size(); ++i) {
        old_fats_.push_back(fatten(i, update.finding.table));
        looked_up_.push_back(escaped_[i].slot);
    }
    const auto fat_lines = slots_.fat_lines();
    forest_.add(std::exchange(fattened_, {}).far, fat_lines);
    if (forest_.is_behind()) {
        forest_.refresh(fat_lines);
    } else {
        for (std::size_t i = 0; i < escaped_.size(); ++i) {
            if (i + escaped_ahead < escaped_.size()) forest_.prefetch(escaped_[i + escaped_ahead].slot);
            forest_.set(escaped_[i].slot, fat_lines[escaped_[i].slot]);
        }
    }
    for (std::size_t begin = 0; begin < escaped_.size(); begin += LookUps::part) {
        link(begin, std::min(begin + LookUps::part, escaped_.size()), update);
    }
    slots_.settle_escaped(escaped_);
    escaped_.clear();
}

// Returns the fat box that a slot had before boxes escaped. `escaped_` must be sorted by slot.
const PackedBox& KeptCandidates::fat_line_before(SlotIndex slot) const noexcept {
    if (!slots_.has(slot, SlotTable::escaped)) return slots_.fat_lines()[slot];
    const auto place =
        std::lower_bound(escaped_.begin(), escaped_.end(), slot,
                         [](const EscapedBox& escaped, SlotIndex wanted) { return escaped.slot < wanted; });
    return old_fats_[static_cast<std::size_t>(place - escaped_.begin())];
}

// Adds the new candidates of the slots looked_up_[begin] to looked_up_[end - 1], which have new fat boxes.
void KeptCandidates::link(std::size_t begin, std::size_t end, Update& update) {
    const std::span wanted = std::span<const SlotIndex>(looked_up_).subspan(begin, end - begin);
    const std::span old_fats = std::span<const PackedBox>(old_fats_).subspan(begin, end - begin);
    // `has` is 0, so partners that are asleep count as known, too: if both boxes are asleep, the pair was no candidate
    // and need not become one.
    constexpr LookUps::Known known{.looked_up = SlotTable::escaped, .has = 0};
    const std::uint64_t tests = look_ups_.find(wanted, old_fats, known, slots_, forest_.trees());
    std::size_t jumped = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        jumped += overlap(old_fats[i], slots_.fat_lines()[wanted[i]]) ? 0 : 1;
    }
    update.finding.counts.box_tests += tests;
    update.jump_tests += tests * jumped / wanted.size();
    for (const auto& found : look_ups_.found()) link(wanted[found.query], old_fats[found.query], found, update);
}

// Adds a pair found by a look-up to the candidates if one of its boxes is awake, and reports it if its boxes overlap.
// Skips the pair if its fat boxes overlapped before: then the list and the reported pairs need no change. If the fat
// boxes did not overlap before, the boxes did not overlap either, so boxes that overlap now have just begun to.
void KeptCandidates::link(SlotIndex slot, const PackedBox& old_fat, const LookUps::NewPartner& found,
                          const Update& update) {
    const auto [query, partner, overlaps] = found;
    if (slots_.has(partner, SlotTable::escaped) && overlap(fat_line_before(partner), old_fat)) return;
    if (overlaps) update.finding.events.began.push_back(slots_.pair_of(slot, partner));
    if (slots_.has(slot, SlotTable::awake) || slots_.has(partner, SlotTable::awake)) {
        candidates_.add(slot, partner, overlaps);
    }
}

}  // namespace ecods
