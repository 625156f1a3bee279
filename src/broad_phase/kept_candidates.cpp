#include "broad_phase/kept_candidates.hpp"

#include <algorithm>
#include <string>

#include "broad_phase/bytes_of.hpp"
#include "ecods/error.hpp"

namespace ecods {

void KeptCandidates::build(const ProxyTable& table, BroadPhaseCounts& counts) {
    std::vector<ProxyIndex> present;
    for (ProxyIndex proxy = 0; proxy < table.end(); ++proxy) {
        if (table.is_present(proxy)) present.push_back(proxy);
    }
    ProxyPairs began, ended;  // the list of pairs has them already
    Update update{.table = table, .began = began, .ended = ended, .counts = counts};
    add(present, table);
    search_all(fatten_escaped(table), true, update);
    escaped_.clear();
    overlap_count_ = static_cast<std::int64_t>(began.size());
}

void KeptCandidates::reserve(std::size_t count) {
    lines_.reserve(count);
    fat_lines_.reserve(count);
    proxies_.reserve(count);
    flags_.reserve(count);
    marks_.reserve(count);
    slots_.reserve(count);
}

void KeptCandidates::update(const ProxyTable& table, const ProxyChanges& changes, PairList& pairs,
                            BroadPhaseCounts& counts) {
    Update update{.table = table, .began = pairs.began, .ended = pairs.ended, .counts = counts};
    const std::uint64_t filtered_before = counts.candidates_filtered;
    const std::uint64_t searched_before = counts.box_tests;

    if (!changes.removed.empty()) remove(changes.removed, update);
    // Going through all boxes in the order of memory costs less for each.
    const bool most_move = 2 * changes.moved.size() > proxies_.size();
    if (most_move) {
        move_all(table);
        filter_all(update);
    } else {
        move_some(changes.moved, table);
        filter_movers(update);
    }
    const std::uint64_t filtered = counts.candidates_filtered - filtered_before;
    counts.escaped += escaped_.size();
    add(changes.added, table);
    if (!escaped_.empty()) {
        const std::vector<TreeItem> newcomers = fatten_escaped(table);
        searched_since_sort_ += escaped_.size();
        const std::size_t count = table.size();
        const bool is_worn = searched_since_sort_ > 4 * count || 4 * forest_.newcomer_count() > count + 64 ||
                             proxies_.size() > 2 * count + 64;
        if (8 * escaped_.size() > count || is_worn) {
            search_all(newcomers, is_worn, update);
            ++counts.rebuilds;
        } else {
            search_escaped(newcomers, update);
        }
        escaped_.clear();
    }
    adapt(filtered, counts.box_tests - searched_before,
          static_cast<std::int64_t>(pairs.began.size()) - static_cast<std::int64_t>(pairs.ended.size()));
}

// Wide fat boxes make candidates that are filtered for nothing, in proportion to their width; narrow ones are escaped
// from sooner, in inverse proportion. The sum is least where both cost the same. A test in a search costs more than
// one in the filter, since it comes with sorting, linking and a new fat box.
void KeptCandidates::adapt(std::uint64_t filtered, std::uint64_t searched, std::int64_t overlaps_gained) {
    constexpr double search_cost = 4;
    constexpr double horizon_min = 2, horizon_max = 64;
    overlap_count_ += overlaps_gained;
    const double candidate_count = static_cast<double>(candidates_.size()) + 1;
    wasted_work_ += static_cast<double>(filtered) * (1 - static_cast<double>(overlap_count_) / candidate_count);
    search_work_ += search_cost * static_cast<double>(searched);
    if (wasted_work_ + search_work_ < 128 * static_cast<double>(proxies_.size())) return;
    horizon_ = std::clamp(horizon_ * (search_work_ > wasted_work_ ? 1.25 : 0.8), horizon_min, horizon_max);
    wasted_work_ = 0;
    search_work_ = 0;
}

void KeptCandidates::remove(const std::vector<ProxyIndex>& proxies, Update& update) {
    for (const ProxyIndex proxy : proxies) {
        const SlotIndex slot = slots_[proxy];
        while (!candidates_.entries(slot).empty()) {
            const std::uint32_t entry = candidates_.entries(slot).back();
            if (CandidateLists::overlaps(entry)) {
                update.ended.push_back(ordered_pair(proxy, proxies_[CandidateLists::slot_of(entry)]));
            }
            candidates_.remove(slot, static_cast<std::uint32_t>(candidates_.entries(slot).size() - 1));
        }
        forest_.remove(slot);
        lines_[slot] = {};
        fat_lines_[slot] = {};
        slots_[proxy] = no_slot;
        free_slots_.push_back(slot);
    }
}

SlotIndex KeptCandidates::take_slot() {
    if (!free_slots_.empty()) {
        const SlotIndex slot = free_slots_.back();
        free_slots_.pop_back();
        return slot;
    }
    lines_.emplace_back();
    fat_lines_.emplace_back();
    proxies_.push_back(0);
    flags_.push_back(0);
    marks_.push_back(0);
    candidates_.resize(lines_.size());
    return static_cast<SlotIndex>(lines_.size() - 1);
}

// What was added has escaped from nowhere.
void KeptCandidates::add(const std::vector<ProxyIndex>& proxies, const ProxyTable& table) {
    if (slots_.size() < table.end()) slots_.resize(table.end(), no_slot);
    for (const ProxyIndex proxy : proxies) {
        const SlotIndex slot = take_slot();
        make_box_line(table.boxes()[proxy], lines_[slot]);
        proxies_[slot] = proxy;
        slots_[proxy] = slot;
        escaped_.push_back({slot, lines_[slot]});
    }
}

std::size_t KeptCandidates::bytes() const noexcept {
    return bytes_of(lines_, fat_lines_, proxies_, flags_, marks_, slots_, free_slots_, movers_, escaped_, found_) +
           candidates_.bytes() + forest_.bytes() + bytes_of(found_pairs_) + old_candidates_.bytes();
}

void KeptCandidates::validate(const ProxyTable& table) const {
    const auto require = [](bool holds, SlotIndex slot, const char* what) {
        if (!holds) throw BrokenInvariant("kept candidates, slot " + std::to_string(slot) + ": " + what);
    };
    std::size_t used_count = 0;
    for (SlotIndex slot = 0; slot < lines_.size(); ++slot) {
        require(flags_[slot] == 0, slot, "flags of an update are left");
        if (lines_[slot].is_empty()) {
            require(fat_lines_[slot].is_empty(), slot, "it is free and has a fat box");
            require(candidates_.entries(slot).empty(), slot, "it is free and has candidates");
            require(std::count(free_slots_.begin(), free_slots_.end(), slot) == 1, slot, "it is not listed as free");
            continue;
        }
        ++used_count;
        const ProxyIndex proxy = proxies_[slot];
        require(table.is_present(proxy) && slots_[proxy] == slot, slot, "its proxy is not here");
        // Through the numbers, not the lanes.
        const KeyBox box = key_box(table.box(proxy));
        const KeyBox fat = key_box(fat_lines_[slot]);
        require(lines_[slot] == box_line(box), slot, "its box is not the proxy's");
        for (std::size_t axis = 0; axis < 3; ++axis) {
            require(fat.min[axis] <= box.min[axis] && box.max[axis] <= fat.max[axis], slot, "it is not in its fat box");
        }
        for (const std::uint32_t entry : candidates_.entries(slot)) {
            const BoxLine& other = lines_[CandidateLists::slot_of(entry)];
            require(!other.is_empty() && overlap(lines_[slot], other) == CandidateLists::overlaps(entry), slot,
                    "what is known of a candidate is wrong");
        }
    }
    if (used_count != table.size()) throw BrokenInvariant("kept candidates: the number of slots in use is wrong");
    if (free_slots_.size() + used_count != lines_.size()) throw BrokenInvariant("kept candidates: a slot is lost");
    candidates_.validate();
    forest_.validate(fat_lines_);
    // Candidates are the pairs of fat boxes that overlap: all of them, from the boxes alone.
    std::size_t expected = 0;
    for (SlotIndex a = 0; a < lines_.size(); ++a) {
        if (lines_[a].is_empty()) continue;
        for (SlotIndex b = a + 1; b < lines_.size(); ++b) {
            if (!lines_[b].is_empty() && overlap(fat_lines_[a], fat_lines_[b])) ++expected;
        }
        for (const std::uint32_t entry : candidates_.entries(a)) {
            require(overlap(fat_lines_[a], fat_lines_[CandidateLists::slot_of(entry)]), a, "a candidate is none");
        }
    }
    if (expected != candidates_.size()) throw BrokenInvariant("kept candidates: a candidate is missing");
}

}  // namespace ecods
