#include "broad_phase/candidates/candidate_list.hpp"

#include <algorithm>
#include <string>

#include "base/bytes_of.hpp"
#include "ecods/error.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

using Candidate = CandidateList::SlotPair;
constexpr SlotIndex overlap_bit = CandidateList::overlap_bit;

// Prefetches run this number of candidates ahead. The last candidates form a Stretch of their own, in which prefetches
// run 0 ahead.
constexpr std::size_t candidates_ahead = 24;
struct Stretch {
    std::size_t end;
    std::size_t ahead;
};

// Holds the input and output of a test of all candidates. `there` receives the pairs in `doubtful` that the list of
// candidates already has.
struct Testing {
    const SlotTable& slots;
    PairEvents& events;
    bool are_removed_reported;
    const std::vector<Candidate>& doubtful;  // sorted
    std::vector<Candidate>& there;
    std::size_t looked_closer = 0;

    // If the pair of a candidate that stays is in `doubtful`, notes that the list has this pair.
    void note_there(SlotIndex a, SlotIndex b) const {
        const Candidate pair = {std::min(a, b), std::max(a, b)};
        if (std::binary_search(doubtful.begin(), doubtful.end(), pair)) there.push_back(pair);
    }

    // Reports that a candidate began or ceased to overlap, and flips its overlap bit.
    void report(Candidate& candidate) const {
        const bool began = (candidate[1] & overlap_bit) == 0;
        candidate[1] ^= overlap_bit;
        const ProxyPair pair = slots.pair_of(candidate[0], candidate[1] & ~overlap_bit);
        (began ? events.began : events.ended).push_back(pair);
    }

    // Tests the boxes of a candidate whose coarse boxes are in doubt, or show that the pair began or ceased to overlap,
    // and reports if it did. Returns false if the pair is no candidate any more.
    [[gnu::noinline]] bool look_closer(Candidate& candidate) {
        ++looked_closer;
        const SlotIndex owner = candidate[0], partner = candidate[1] & ~overlap_bit;
        if (slots.has(owner, SlotTable::changed) || slots.has(partner, SlotTable::changed)) {
            const PackedBox &fat = slots.fat_lines()[owner], &other_fat = slots.fat_lines()[partner];
            if (fat.is_empty() || !overlap(fat, other_fat)) {
                report_removed(candidate);
                return false;
            }
            note_there(owner, partner);
        }
        const bool now = overlap(slots.lines()[owner], slots.lines()[partner]);
        if (now != (candidate[1] >= overlap_bit)) report(candidate);
        return true;
    }

    // Reports the end of a dropped candidate if it overlapped, unless the pairs of removed boxes are reported already.
    void report_removed(const Candidate& candidate) const {
        if ((candidate[1] & overlap_bit) == 0 || are_removed_reported) return;
        events.ended.push_back(slots.pair_of(candidate[0], candidate[1] & ~overlap_bit));
    }
};

// Drops the pairs whose fat boxes no longer overlap. Compacts the list without branches, since which pairs stay is
// unpredictable.
ECODS_ALWAYS_INLINE void drop_stale(const Testing& testing, std::vector<Candidate>& list) {
    const PackedBox* const fat_lines = testing.slots.fat_lines().data();
    const std::uint8_t* const flags = testing.slots.flags().data();
    const bool are_some_doubtful = !testing.doubtful.empty();
    Candidate* const candidates = list.data();
    Candidate* write = candidates;
    BoxLanes reach;
    for (std::size_t i = 0; i < list.size(); ++i) {
        const SlotIndex ahead = candidates[std::min(i + candidates_ahead, list.size() - 1)][1] & ~overlap_bit;
        __builtin_prefetch(&fat_lines[ahead]);
        __builtin_prefetch(&flags[ahead]);
        const Candidate candidate = candidates[i];
        const SlotIndex owner = candidate[0], partner = candidate[1] & ~overlap_bit;
        make_reach(fat_lines[owner], reach);
        const bool has_changed = ((flags[owner] | flags[partner]) & SlotTable::changed) != 0;
        const bool stays = !has_changed | overlaps(fat_lines[partner], reach);
        *write = candidate;
        write += stays ? 1 : 0;
        if (!stays & (candidate[1] >= overlap_bit)) [[unlikely]]
            testing.report_removed(candidate);
        if (are_some_doubtful && has_changed && stays) [[unlikely]]
            testing.note_there(owner, partner);
    }
    list.resize(static_cast<std::size_t>(write - candidates));
}

// Tests all candidates by their coarse boxes, and drops the stale pairs if `have_some_gone`. Returns how many
// candidates overlapped before.
template <bool have_some_gone>
ECODS_ALWAYS_INLINE std::uint64_t test_all(Testing& testing, std::vector<Candidate>& list) {
    const CoarseBox* const boxes = testing.slots.coarse_boxes().data();
    Candidate* const candidates = list.data();
    Candidate* write = candidates;
    const std::size_t count = list.size();
    std::uint64_t overlapping = 0;
    const Stretch parts[] = {{count - std::min(count, candidates_ahead), candidates_ahead}, {count, 0}};
    std::size_t i = 0;
    for (const Stretch& part : parts) {
        for (; i < part.end; ++i) {
            __builtin_prefetch(&boxes[candidates[i + part.ahead][1] & ~overlap_bit]);
            const Candidate candidate = candidates[i];
            const auto [owner, entry] = candidate;
            const bool overlapped = entry >= overlap_bit;
            const auto [are_apart, are_in_doubt] = coarse_overlap(boxes[owner], boxes[entry & ~overlap_bit]);
            Candidate& kept = have_some_gone ? *write : candidates[i];
            if constexpr (have_some_gone) kept = candidate;
            if (are_in_doubt | (are_apart == overlapped)) [[unlikely]] {
                if (!testing.look_closer(kept)) continue;
            }
            overlapping += overlapped ? 1 : 0;
            if constexpr (have_some_gone) ++write;
        }
    }
    if constexpr (have_some_gone) list.resize(static_cast<std::size_t>(write - candidates));
    return overlapping;
}

// Tests all candidates by the boxes themselves; drop_stale() must have dropped the stale pairs. Returns how many
// candidates overlapped before.
ECODS_ALWAYS_INLINE std::uint64_t test_all_by_boxes(Testing& testing, std::vector<Candidate>& list) {
    const PackedBox* const lines = testing.slots.lines().data();
    std::uint64_t overlapping = 0;
    BoxLanes reach;
    for (std::size_t i = 0; i < list.size(); ++i) {
        __builtin_prefetch(&lines[list[std::min(i + candidates_ahead, list.size() - 1)][1] & ~overlap_bit]);
        const auto [owner, entry] = list[i];
        const bool overlapped = entry >= overlap_bit;
        make_reach(lines[owner], reach);
        overlapping += overlapped ? 1 : 0;
        if (overlaps(lines[entry & ~overlap_bit], reach) != overlapped) [[unlikely]]
            testing.look_closer(list[i]);
    }
    return overlapping;
}

ECODS_ALWAYS_INLINE void settle_all(const SlotTable& slots, std::vector<Candidate>& list) {
    const PackedBox* const lines = slots.lines().data();
    BoxLanes reach;
    for (auto& [a, b] : list) {
        make_reach(lines[a], reach);
        b |= static_cast<SlotIndex>(overlaps(lines[b], reach)) * overlap_bit;
    }
}

}  // namespace

void CandidateList::test(SlotTable& slots, bool are_removed_reported, PairEvents& events) {
    std::sort(doubtful_.begin(), doubtful_.end());
    Testing testing{slots, events, are_removed_reported, doubtful_, there_};
    // Chooses how to find stale candidates. If few slots changed, marks the coarse boxes of these slots, so that
    // look_closer() tests each of their candidates. Otherwise a separate pass over all candidates costs less.
    constexpr std::size_t pairs_of_one = 32;
    const std::size_t changed = slots.changed_slots().size();
    const bool by_boxes = !slots.keeps_coarse_boxes() || tests_by_boxes_ > 0;
    const bool are_some = !by_boxes && changed > 0 && pairs_of_one * changed <= pairs_.size();
    if (changed > 0 && !are_some) dispatch<drop_stale>(testing, pairs_);
    if (by_boxes) {
        tests_by_boxes_ -= std::min(tests_by_boxes_, 1u);
        overlapping_count_ = dispatch<test_all_by_boxes>(testing, pairs_);
    } else {
        if (are_some) slots.mark_changed();
        overlapping_count_ =
            are_some ? dispatch<test_all<true>>(testing, pairs_) : dispatch<test_all<false>>(testing, pairs_);
        // Uses the boxes themselves for some updates if coarse boxes left many candidates in doubt: far from the
        // origin, or if boxes lie on a lattice, many coarse ends are equal.
        constexpr std::size_t share_in_doubt = 4;
        constexpr std::uint32_t until_next_trial = 64;
        if (share_in_doubt * testing.looked_closer > pairs_.size()) tests_by_boxes_ = until_next_trial;
    }
    if (!doubtful_.empty()) add_doubtful(slots, events);
}

void CandidateList::add_doubtful(const SlotTable& slots, PairEvents& events) {
    std::sort(there_.begin(), there_.end());
    for (const auto& [a, b] : doubtful_) {
        if (std::binary_search(there_.begin(), there_.end(), Candidate{a, b})) continue;
        const bool now = overlap(slots.lines()[a], slots.lines()[b]);
        if (now) events.began.push_back(slots.pair_of(a, b));
        add(a, b, now);
    }
    doubtful_.clear();
    there_.clear();
}

void CandidateList::drop_asleep(const SlotTable& slots) {
    if (slots.awake_count() == slots.used_count()) return;
    std::erase_if(pairs_, [&](const Candidate& candidate) {
        return !slots.has(candidate[0], SlotTable::awake) && !slots.has(candidate[1] & ~overlap_bit, SlotTable::awake);
    });
}

void CandidateList::settle(const SlotTable& slots) {
    dispatch<settle_all>(slots, pairs_);
}

std::size_t CandidateList::bytes() const noexcept {
    return bytes_of(pairs_, doubtful_, there_);
}

void CandidateList::validate(const SlotTable& slots) const {
    const auto require = [](bool holds, SlotIndex slot, const char* what) {
        if (!holds) throw BrokenInvariant("kept candidates, slot " + std::to_string(slot) + ": " + what);
    };
    const auto lines = slots.lines(), fat_lines = slots.fat_lines();
    std::vector<Candidate> kept;
    for (const Candidate& candidate : pairs_) {
        const SlotIndex a = candidate[0], b = candidate[1] & ~overlap_bit;
        require(a < lines.size() && b < lines.size() && a != b, a, "a candidate is none");
        require(overlap(lines[a], lines[b]) == ((candidate[1] & overlap_bit) != 0), a,
                "what is known of a candidate is wrong");
        if (overlap(fat_lines[a], fat_lines[b])) {
            kept.push_back({std::min(a, b), std::max(a, b)});
        } else {
            require(slots.has(a, SlotTable::changed) || slots.has(b, SlotTable::changed), a,
                    "a candidate has gone and will stay");
        }
    }
    std::sort(kept.begin(), kept.end());
    std::size_t next = 0;
    for (SlotIndex a = 0; a < lines.size(); ++a) {
        if (slots.is_free(a)) continue;
        for (SlotIndex b = a + 1; b < lines.size(); ++b) {
            if (slots.is_free(b) || !overlap(fat_lines[a], fat_lines[b])) continue;
            if (!slots.has(a, SlotTable::awake) && !slots.has(b, SlotTable::awake)) continue;
            require(next < kept.size() && kept[next] == Candidate{a, b}, a, "a candidate is missing or there twice");
            ++next;
        }
    }
    if (next != kept.size()) throw BrokenInvariant("kept candidates: there is one too many");
}

}  // namespace ecods
