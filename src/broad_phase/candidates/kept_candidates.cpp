#include "broad_phase/candidates/kept_candidates.hpp"

#include <algorithm>

#include "base/bytes_of.hpp"
#include "base/make_room.hpp"

namespace ecods {

void KeptCandidates::build(const ProxyTable& table, BroadPhaseCounts& counts) {
    table.for_each([&](ProxyIndex proxy, const Aabb&) { add(proxy, table); });
    search_everything(table, true, counts);
    release_working_memory();             // also pairs_: the keeper of the pairs has them already
    forest_.refresh(slots_.fat_lines());  // otherwise, the first box to move or to come would wait for it
}

void KeptCandidates::reserve(std::size_t count) {
    slots_.reserve(count);
    margins_.reserve(count);
}

void KeptCandidates::update(const FindingUpdate& finding) {
    const auto& [table, changes, keeper, events, counts] = finding;
    margins_.begin_update();
    const std::size_t woken = slots_.count_asleep(changes.moved);
    const bool replaces = keeping_.searches() || 8 * (woken + changes.added.size()) > slots_.used_count() + 64;
    if (replaces) replace_everything(finding);
    const bool has_searched = replaces || look_up_changes(finding, woken);
    if (has_searched) {
        keeper.compare(table, changes, pairs_, events);
    } else {
        sort_pairs(events.began);
        sort_pairs(events.ended);
    }
    if (!replaces) put_to_sleep(changes.moved.size());
    // Frees scratch memory after many boxes were added, since the added boxes may be at rest from now on.
    if (RebuildRule::are_many(changes.added.size(), table.size())) release_working_memory();
}

// Looks up the boxes that were added, woke up or escaped, and returns false. If too many boxes escaped, makes a full
// search instead, and returns true.
bool KeptCandidates::look_up_changes(const FindingUpdate& finding, std::size_t woken) {
    const auto& [table, changes, keeper, events, counts] = finding;
    // If many boxes are removed at once, the keeper of the pairs finds their pairs; otherwise each removed box is
    // looked up.
    constexpr std::size_t pass_per_removal = 128;
    const bool many_go = pass_per_removal * changes.removed.size() > slots_.used_count();
    if (many_go) keeper.append_removed(table, changes, events.ended);
    Update update{.finding = finding, .are_removed_reported = many_go};
    const std::uint64_t tests_before = counts.box_tests;
    std::size_t looked_up = woken + changes.added.size() + (many_go ? 0 : changes.removed.size());

    remove(update);
    wake(finding);
    margins_.lookahead().note_update();
    do_most_move(changes) ? margins_.frame().advance() : margins_.frame().stay();
    const bool many_escaped = move(finding, false);
    const std::size_t escaped = fattened_.count + escaped_.size() + changes.added.size();
    const bool is_degraded = escaped > 0 && rebuild_.is_degraded(forest_.unsorted_count(), slots_.size(), table.size());
    const bool searches_all =
        many_escaped || is_degraded || (escaped > 0 && rebuild_.is_due(slots_.awake_count(), table.size()));
    const std::size_t filtered = searches_all ? 0 : candidates_.size();
    if (!searches_all) test_candidates(update);
    if (searches_all) drop_candidates();
    for (const ProxyIndex proxy : changes.added) add(proxy, table);
    if (!many_escaped && margins_.lookahead().is_due(table.size())) margins_.lookahead().adapt();
    if (searches_all) {
        search_everything(table, is_degraded, counts);
        ++counts.rebuilds;
    } else {
        looked_up += escaped - changes.added.size();
        search_escaped(update);
    }
    const std::uint64_t tests = counts.box_tests - tests_before;
    if (!searches_all) margins_.lookahead().note(0, tests - update.jump_tests);
    keeping_.note_kept({.boxes = table.size(),
                        .moved = changes.moved.size(),
                        .filtered = filtered,
                        .events = events.began.size() + events.ended.size(),
                        .looked_up = looked_up,
                        .tree_tests = tests,
                        .searched_all = searches_all,
                        .candidates = candidates_.size()});
    return searches_all;
}

// Removes boxes. Looks up the pairs of a removed box in which both boxes are asleep, and reports their ends unless all
// pairs of removed boxes are reported already. All other pairs of a removed box are candidates; test_candidates()
// reports their ends.
void KeptCandidates::remove(Update& update) {
    const auto& [table, changes, keeper, events, counts] = update.finding;
    constexpr std::size_t ahead = 6;  // prefetch distance, in boxes
    BoxReach reach;
    for (std::size_t i = 0; i < changes.removed.size(); ++i) {
        forest_.prefetch(slots_.slot_of(changes.removed[std::min(i + ahead, changes.removed.size() - 1)]));
        const SlotIndex slot = slots_.slot_of(changes.removed[i]);
        if (!slots_.has(slot, SlotTable::awake) && !update.are_removed_reported) {
            const PackedBox& line = slots_.lines()[slot];
            forest_.refresh(slots_.fat_lines());
            make_reach(packed_box(key_box(margins_.frame().of(box_of(line)))), reach);
            found_.clear();
            counts.box_tests += forest_.trees().find(reach, found_);
            make_reach(line, reach);
            for (const SlotIndex partner : found_) {
                if (partner == slot || slots_.has(partner, SlotTable::awake)) continue;
                if (overlaps(slots_.lines()[partner], reach)) events.ended.push_back(slots_.pair_of(slot, partner));
            }
        }
        forest_.remove(slot);
        slots_.remove(slot);
    }
}

// Moves boxes in parts, lists the boxes that escaped, and returns false. If `fattens` is true, or if many boxes escape,
// instead gives the escaped boxes new fat boxes after each part, and returns true: a list of all escaped boxes would be
// written to memory and read again.
bool KeptCandidates::move(const FindingUpdate& finding, bool fattens) {
    constexpr std::size_t part = 1024;
    const auto& [table, changes, keeper, events, counts] = finding;
    const auto fatten_many = [&, &table = table, &added = changes.added] {
        if (!fattens && RebuildRule::are_many(escaped_.size() + added.size(), table.size())) {
            fattens = true;
            adapt_margins(table);
        }
        if (fattens) fatten_escaped(table);
    };
    const bool do_most = do_most_move(changes);
    const std::size_t count = do_most ? slots_.size() : changes.moved.size();
    for (std::size_t begin = 0; begin < count; begin += part) {
        const std::size_t size = std::min(part, count - begin), before = escaped_.size();
        if (do_most) {
            slots_.move_range(begin, begin + size, table, margins_.frame(), escaped_);
        } else {
            slots_.move(changes.moved.subspan(begin, size), table, margins_.frame(), escaped_);
        }
        counts.escaped += escaped_.size() - before;
        fatten_many();
    }
    fatten_many();
    return fattens;
}

// Adapts the lookahead, and learns where boxes turn, before many escaped boxes get new margins.
void KeptCandidates::adapt_margins(const ProxyTable& table) {
    Lookahead& lookahead = margins_.lookahead();
    if (RebuildRule::are_many(escaped_.size(), table.size())) lookahead.limit(lifetime_of_escaped(table));
    lookahead.adapt();
    margins_.learn_turns(slots_.awake_count());
}

// Returns true if more than half of the slots move: then a pass over all boxes in the order of memory costs less.
bool KeptCandidates::do_most_move(const ProxyChanges& changes) const noexcept {
    return 2 * changes.moved.size() > slots_.size();
}

void KeptCandidates::test_candidates(const Update& update) {
    const std::size_t count = candidates_.size();
    update.finding.counts.candidates_filtered += count;
    slots_.choose_coarse_boxes();
    candidates_.test(slots_, update.are_removed_reported, update.finding.events);
    margins_.lookahead().note(count - candidates_.overlapping_count(), 0);
    slots_.forget_changes();
}

// Adds a box to the slots and to the escaped boxes, since it has no fat box yet.
void KeptCandidates::add(ProxyIndex proxy, const ProxyTable& table) {
    const SlotIndex slot = slots_.add(proxy, table.boxes()[proxy]);
    margins_.add(slot);
    escaped_.push_back({slot, slots_.lines()[slot]});
}

void KeptCandidates::put_to_sleep(std::size_t moved_count) {
    if (!slots_.put_resting_to_sleep(moved_count)) return;
    candidates_.drop_asleep(slots_);
    if (8 * slots_.awake_count() < slots_.used_count()) release_working_memory();
}

void KeptCandidates::release_working_memory() {
    search_ = {};
    look_ups_ = {};
    listing_ = {};
    release(escaped_, looked_up_, old_fats_, found_, pairs_);
    candidates_.release_spare();
}

std::size_t KeptCandidates::bytes() const noexcept {
    return slots_.bytes() + margins_.bytes() + candidates_.bytes() + forest_.bytes() + search_.bytes() +
           look_ups_.bytes() + bytes_of(escaped_, looked_up_, found_, pairs_) + bytes_of(old_fats_) +
           bytes_of(listing_.next, listing_.by_second);
}

void KeptCandidates::validate(const ProxyTable& table) const {
    slots_.validate(table, margins_.frame(), has_margins_);
    if (!has_margins_) return;
    forest_.validate(slots_.fat_lines());
    candidates_.validate(slots_);
}

}  // namespace ecods
