#include "broad_phase/candidates/kept_candidates.hpp"

#include <algorithm>
#include <cmath>

#include "base/bytes_of.hpp"

namespace ecods {
namespace {

constexpr double lookahead_min = 2, lookahead_max = 64;

}  // namespace

void KeptCandidates::build(const ProxyTable& table, BroadPhaseCounts& counts) {
    std::vector<ProxyIndex> present;
    for (ProxyIndex proxy = 0; proxy < table.end(); ++proxy) {
        if (table.is_present(proxy)) present.push_back(proxy);
    }
    ProxyPairs began, ended;  // the list of pairs has them already
    Update update{.table = table, .began = began, .ended = ended, .counts = counts};
    add(present, table);
    search_all(fatten_escaped(table), true, update);
    rule_.note_pairs(began.size());
    escaped_.clear();
    refresh_forest(table);  // which the first one to move or to come would wait for
}

void KeptCandidates::reserve(std::size_t count) {
    lines_.reserve(count);
    fat_lines_.reserve(count);
    old_fat_lines_.reserve(count);
    proxies_.reserve(count);
    flags_.reserve(count);
    motion_hints_.reserve(count);
    slots_.reserve(count);
}

void KeptCandidates::update(const FindingUpdate& finding) {
    const auto& [table, changes, keeper, events, counts] = finding;  // the pairs of its candidates it knows itself
    ++update_number_;
    const std::size_t woken = count_asleep(changes.moved);
    if (rule_.searches() || 8 * (woken + changes.added.size()) > used_count_ + 64) {
        find_everything(finding);
        return;
    }
    // Where many go at once, whoever keeps the pairs knows theirs; otherwise they are looked up.
    constexpr std::size_t pass_per_removal = 128;
    const bool many_go = pass_per_removal * changes.removed.size() > used_count_;
    if (many_go) keeper.append_removed(table, changes, events.ended);
    Update update{.table = table,
                  .began = events.began,
                  .ended = events.ended,
                  .counts = counts,
                  .are_removed_reported = many_go};
    const std::uint64_t searched_before = counts.box_tests;
    std::uint64_t looked_up = woken + changes.added.size() + (many_go ? 0 : changes.removed.size());
    bool searched_all = false;

    if (!changes.removed.empty()) remove(changes.removed, update);
    wake(changes.moved, update);
    // Going through all boxes in the order of memory costs less for each.
    if (2 * changes.moved.size() > proxies_.size()) {
        frame_.advance();
        move_all(table);
    } else {
        frame_.stay();
        move_some(changes.moved, table);
    }
    const std::size_t filtered = candidates_.size();
    filter(update);
    counts.escaped += escaped_.size();
    add(changes.added, table);
    wasted_work_ += static_cast<double>(filtered - overlapping_);
    ++updates_since_search_;
    if (wasted_work_ + search_work_ > 512 * static_cast<double>(used_count_)) adapt();
    if (!escaped_.empty()) {
        searched_all = search_where_escaped(table, update);
        if (!searched_all) looked_up += escaped_.size() - changes.added.size();
        escaped_.clear();
    }
    // A test in a search costs more than one in the filter, since it comes with sorting, linking and a new fat box.
    // Those for boxes that jumped do not count: no margin would have spared them.
    constexpr double search_cost = 2;
    search_work_ += search_cost * static_cast<double>(counts.box_tests - searched_before - jump_tests_);
    jump_tests_ = 0;
    rule_.note_kept({.boxes = table.size(),
                     .moved = changes.moved.size(),
                     .filtered = filtered,
                     .looked_up = looked_up,
                     .tree_tests = counts.box_tests - searched_before,
                     .searched_all = searched_all,
                     .candidates = candidates_.size()});
    put_to_sleep(changes.moved.size());
    sort_pairs(events.began);
    sort_pairs(events.ended);
}

// Finds the candidates of the boxes that escaped: says whether by a search for all boxes.
bool KeptCandidates::search_where_escaped(const ProxyTable& table, Update& update) {
    const std::size_t count = table.size();
    const bool is_degraded = searched_since_sort_ > 4 * count ||
                             4 * (forest_.unsorted_count() + forest_lacks_.size()) > count + 64 ||
                             proxies_.size() > 2 * count + 64;
    const bool many_escaped = 8 * escaped_.size() > count;
    if (many_escaped) {
        adapt();
        learn_turns();
    }
    const std::vector<BoxForest::Item> unsorted = fatten_escaped(table);
    if (many_escaped || is_degraded) {
        search_all(unsorted, is_degraded, update);
        ++update.counts.rebuilds;
        return true;
    }
    searched_since_sort_ += escaped_.size();
    search_escaped(unsorted, update);
    return false;
}

// Wide fat boxes make candidates that are filtered for nothing, in proportion to their width; narrow ones are escaped
// from sooner, in inverse proportion. The sum is least where both cost the same, which is off by the root of their
// ratio. Work is compared from one search of everything to the next, since most of it comes then.
void KeptCandidates::adapt() {
    constexpr std::size_t updates_min = 2;  // fewer are no motion to learn from
    if (updates_since_search_ >= updates_min) {
        lookahead_ *= std::clamp(std::sqrt((search_work_ + 1) / (wasted_work_ + 1)), 0.5, 2.0);
        lookahead_ = std::clamp(lookahead_, lookahead_min, lookahead_max);
    }
    wasted_work_ = 0;
    search_work_ = 0;
}

// Before anything is known of a motion: what is filtered for nothing grows with the pairs there are, and what a search
// costs does not, so that the best lookahead falls with the root of the pairs a box has. Measured, of boxes of like
// sizes.
void KeptCandidates::guess_lookahead(std::size_t pair_count) {
    constexpr double lookahead_for_one_pair = 50;
    const double pairs_per_box = static_cast<double>(pair_count + 1) / static_cast<double>(used_count_ + 1);
    lookahead_ = std::clamp(lookahead_for_one_pair / std::sqrt(pairs_per_box), lookahead_min, lookahead_max);
}

// Boxes at rest cost as long as they are awake. To wake one again costs a search, so they are put to sleep when they
// have cost about as much; the pass that does so is paid for by the same work.
void KeptCandidates::put_to_sleep(std::size_t moved_count) {
    constexpr std::uint64_t patience = 16;
    if (moved_count < awake_count_) updates_at_rest_ += awake_count_ - moved_count;
    if (updates_at_rest_ <= patience * awake_count_) return;
    updates_at_rest_ = 0;
    for (SlotIndex slot = 0; slot < flags_.size(); ++slot) {
        if (has_flag(slot, awake) && !has_flag(slot, moved)) {
            clear_flag(slot, awake);
            --awake_count_;
        }
        clear_flag(slot, moved);
    }
    std::erase_if(candidates_, [&](const Candidate& candidate) {
        return !has_flag(candidate[0], awake) && !has_flag(candidate[1] & ~overlap_bit, awake);
    });
}

// The pairs of a removed box with awake ones, and all if it is awake itself, are candidates, which the filter reports.
void KeptCandidates::remove(const std::vector<ProxyIndex>& proxies, Update& update) {
    BoxReach reach;
    for (const ProxyIndex proxy : proxies) {
        const SlotIndex slot = slots_[proxy];
        if (!has_flag(slot, awake) && !update.are_removed_reported) {
            refresh_forest(update.table);
            make_reach(packed_box(key_box(frame_.of(box_of(lines_[slot])))), reach);
            found_.clear();
            update.counts.box_tests += forest_.find(reach, found_);
            make_reach(lines_[slot], reach);
            for (const SlotIndex partner : found_) {
                if (partner == slot || has_flag(partner, awake) || !overlaps(lines_[partner], reach)) continue;
                update.ended.push_back(ordered_pair(proxy, proxies_[partner]));
            }
        }
        forest_.remove(slot);
        lines_[slot] = {};
        fat_lines_[slot] = {};
        slots_[proxy] = no_slot;
        --used_count_;
        if (has_flag(slot, awake)) --awake_count_;
        if (!has_flag(slot, changed)) changed_slots_.push_back(slot);
        flags_[slot] = changed;
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
    old_fat_lines_.emplace_back();
    proxies_.push_back(0);
    flags_.push_back(0);
    motion_hints_.emplace_back();
    return static_cast<SlotIndex>(lines_.size() - 1);
}

// What was added has escaped from nowhere.
void KeptCandidates::add(const std::vector<ProxyIndex>& proxies, const ProxyTable& table) {
    if (slots_.size() < table.end()) slots_.resize(table.end(), no_slot);
    for (const ProxyIndex proxy : proxies) {
        const SlotIndex slot = take_slot();
        make_packed_box(table.boxes()[proxy], lines_[slot]);
        proxies_[slot] = proxy;
        motion_hints_[slot] = {};
        slots_[proxy] = slot;
        ++used_count_;
        escaped_.push_back({slot, lines_[slot]});
    }
}

std::size_t KeptCandidates::bytes() const noexcept {
    return bytes_of(lines_, fat_lines_, old_fat_lines_, proxies_, flags_, motion_hints_) +
           bytes_of(candidates_, slots_, free_slots_, changed_slots_, escaped_, found_) + forest_.bytes() +
           bytes_of(forest_lacks_) + bytes_of(pairs_) + search_.bytes();
}

}  // namespace ecods
