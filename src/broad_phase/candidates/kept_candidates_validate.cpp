#include <algorithm>
#include <string>

#include "broad_phase/candidates/kept_candidates.hpp"
#include "ecods/error.hpp"

namespace ecods {

void KeptCandidates::validate(const ProxyTable& table) const {
    const std::vector<PackedBox>& fat_lines = has_margins_ ? fat_lines_ : lines_;
    const auto require = [](bool holds, SlotIndex slot, const char* what) {
        if (!holds) throw BrokenInvariant("kept candidates, slot " + std::to_string(slot) + ": " + what);
    };
    std::size_t used_count = 0, awake_count = 0;
    for (SlotIndex slot = 0; slot < lines_.size(); ++slot) {
        require(!has_flag(slot, searching), slot, "flags of an update are left");
        require(has_flag(slot, changed) == (std::count(changed_slots_.begin(), changed_slots_.end(), slot) == 1), slot,
                "the changed slots are not those with the flag");
        if (lines_[slot].is_empty()) {
            require(fat_lines[slot].is_empty() && !has_flag(slot, awake), slot, "it is free and in use");
            require(std::count(free_slots_.begin(), free_slots_.end(), slot) == 1, slot, "it is not listed as free");
            continue;
        }
        ++used_count;
        awake_count += has_flag(slot, awake) ? 1 : 0;
        const ProxyIndex proxy = proxies_[slot];
        require(table.is_present(proxy) && slots_[proxy] == slot, slot, "its proxy is not here");
        // Through the numbers, not the lanes.
        const KeyBox in_frame = key_box(frame_.of(table.box(proxy))), fat = key_box(fat_lines[slot]);
        require(lines_[slot] == packed_box(key_box(table.box(proxy))), slot, "its box is not the proxy's");
        for (std::size_t axis = 0; axis < 3; ++axis) {
            require(fat.min[axis] <= in_frame.min[axis] && in_frame.max[axis] <= fat.max[axis], slot,
                    "it is not in its fat box");
        }
    }
    if (used_count != table.size() || used_count != used_count_)
        throw BrokenInvariant("kept candidates: the number of slots in use is wrong");
    if (awake_count != awake_count_) throw BrokenInvariant("kept candidates: the number of slots awake is wrong");
    if (free_slots_.size() + used_count != lines_.size()) throw BrokenInvariant("kept candidates: a slot is lost");
    if (!is_forest_behind_) forest_.validate(fat_lines);

    // Candidates are the pairs of fat boxes that overlap, one of them awake: all of them, from the boxes alone; and
    // until the next update, some that were before fat boxes changed.
    std::vector<Candidate> kept;
    for (const Candidate& candidate : candidates_) {
        const SlotIndex a = candidate[0], b = candidate[1] & ~overlap_bit;
        require(a < lines_.size() && b < lines_.size() && a != b, a, "a candidate is none");
        require(overlap(lines_[a], lines_[b]) == ((candidate[1] & overlap_bit) != 0), a,
                "what is known of a candidate is wrong");
        if (overlap(fat_lines[a], fat_lines[b])) {
            kept.push_back({std::min(a, b), std::max(a, b)});
        } else {
            require(has_flag(a, changed) || has_flag(b, changed), a, "a candidate has gone and will stay");
        }
    }
    std::sort(kept.begin(), kept.end());
    std::size_t next = 0;
    for (SlotIndex a = 0; a < lines_.size(); ++a) {
        if (lines_[a].is_empty()) continue;
        for (SlotIndex b = a + 1; b < lines_.size(); ++b) {
            if (lines_[b].is_empty() || !overlap(fat_lines[a], fat_lines[b])) continue;
            if (!has_flag(a, awake) && !has_flag(b, awake)) continue;
            require(next < kept.size() && kept[next] == Candidate{a, b}, a, "a candidate is missing or there twice");
            ++next;
        }
    }
    if (next != kept.size()) throw BrokenInvariant("kept candidates: there is one too many");
}

}  // namespace ecods
