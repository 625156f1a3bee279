// Boxes that moved, and what that means for the candidates there are.
#include <algorithm>

#include "broad_phase/candidates/kept_candidates.hpp"
#include "simd/dispatch.hpp"

namespace ecods {
namespace {

// How many boxes ahead memory is asked for.
constexpr std::size_t prefetch_distance = 12;

// How many candidates ahead, of a number of them.
constexpr std::size_t prefetch_candidates = 24;
struct Part {
    std::size_t end;
    std::size_t ahead;
};

}  // namespace

ECODS_ALWAYS_INLINE void KeptCandidates::move_all_wide(const ProxyTable& table) {
    const Aabb* const boxes = table.boxes().data();
    const std::size_t count = proxies_.size();
    for (std::size_t slot = 0; slot < count; ++slot) {
        const auto* ahead = reinterpret_cast<const char*>(
            &boxes[proxies_[slot + prefetch_distance < count ? slot + prefetch_distance : count - 1]]);
        __builtin_prefetch(ahead);
        __builtin_prefetch(ahead + sizeof(Aabb) - 1);
        PackedBox line;
        make_packed_box(boxes[proxies_[slot]], line);
        if (!contains(fat_lines_[slot], line)) [[unlikely]] {
            if (fat_lines_[slot].is_empty()) continue;  // a free slot
            escaped_.push_back({static_cast<SlotIndex>(slot), lines_[slot]});
        }
        lines_[slot] = line;
    }
}

ECODS_ALWAYS_INLINE void KeptCandidates::move_some_wide(std::span<const ProxyIndex> proxies, const ProxyTable& table) {
    for (std::size_t i = 0; i < proxies.size(); ++i) {
        if (i + prefetch_distance < proxies.size()) {
            const SlotIndex ahead = slots_[proxies[i + prefetch_distance]];
            __builtin_prefetch(&lines_[ahead]);
            __builtin_prefetch(&fat_lines_[ahead]);
        }
        const SlotIndex slot = slots_[proxies[i]];
        PackedBox line;
        make_packed_box(table.boxes()[proxies[i]], line);
        if (!contains(fat_lines_[slot], line)) [[unlikely]] {
            escaped_.push_back({slot, lines_[slot]});
        }
        lines_[slot] = line;
    }
}

void KeptCandidates::move_all(const ProxyTable& table) {
    dispatch<&KeptCandidates::move_all_wide>(*this, table);
}

void KeptCandidates::move_some(std::span<const ProxyIndex> proxies, const ProxyTable& table) {
    dispatch<&KeptCandidates::move_some_wide>(*this, proxies, table);
}

// A candidate began or ceased to overlap.
void KeptCandidates::report(Candidate& candidate, Update& update) {
    const bool began = (candidate[1] & overlap_bit) == 0;
    candidate[1] ^= overlap_bit;
    const ProxyPair pair = ordered_pair(proxies_[candidate[0]], proxies_[candidate[1] & ~overlap_bit]);
    (began ? update.began : update.ended).push_back(pair);
}

// Where fat boxes changed, candidates that are none any more go. They do not overlap; those of a box that went may have
// done so, which has been reported.
template <bool have_some_gone>
ECODS_ALWAYS_INLINE void KeptCandidates::filter_wide(Update& update) {
    const PackedBox* const lines = lines_.data();
    const std::uint8_t* const flags = flags_.data();
    Candidate* const candidates = candidates_.data();
    Candidate* write = candidates;
    const std::size_t count = candidates_.size();
    std::uint64_t overlapping = 0;
    BoxReach reach;
    const Part parts[] = {{count - std::min(count, prefetch_candidates), prefetch_candidates}, {count, 0}};
    std::size_t i = 0;
    for (const Part& part : parts) {
        for (; i < part.end; ++i) {
            __builtin_prefetch(&lines[candidates[i + part.ahead][1] & ~overlap_bit]);
            const Candidate candidate = candidates[i];
            const auto [owner, entry] = candidate;
            const SlotIndex partner = entry & ~overlap_bit;
            if constexpr (have_some_gone) {
                if (((flags[owner] | flags[partner]) & changed) != 0) [[unlikely]] {
                    make_reach(fat_lines_[owner], reach);
                    if (!overlaps(fat_lines_[partner], reach) || fat_lines_[owner].is_empty()) continue;
                }
                *write = candidate;
            }
            make_reach(lines[owner], reach);
            const bool now = overlaps(lines[partner], reach);
            overlapping += entry / overlap_bit;
            if (now != (entry >= overlap_bit)) [[unlikely]] {
                report(have_some_gone ? *write : candidates[i], update);
            }
            if constexpr (have_some_gone) ++write;
        }
    }
    if constexpr (have_some_gone) candidates_.resize(static_cast<std::size_t>(write - candidates));
    overlapping_ = overlapping;
}

void KeptCandidates::filter(Update& update) {
    update.counts.candidates_filtered += candidates_.size();
    if (changed_slots_.empty()) {
        dispatch<&KeptCandidates::filter_wide<false>>(*this, update);
        return;
    }
    dispatch<&KeptCandidates::filter_wide<true>>(*this, update);
    for (const SlotIndex slot : changed_slots_) {
        clear_flag(slot, changed);
        if (lines_[slot].is_empty()) free_slots_.push_back(slot);
    }
    changed_slots_.clear();
}

}  // namespace ecods
