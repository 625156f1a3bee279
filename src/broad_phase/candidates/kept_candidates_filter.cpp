// Boxes that moved, and what that means for the candidates there are.
#include "broad_phase/candidates/kept_candidates.hpp"
#include "broad_phase/candidates/kept_candidates_loops.hpp"
#include "simd/dispatch.hpp"

namespace ecods {

void KeptCandidates::move_all(const ProxyTable& table) {
    dispatch<Loops::move_all>(*this, table);
}

void KeptCandidates::move_some(std::span<const ProxyIndex> proxies, const ProxyTable& table) {
    dispatch<Loops::move_some>(*this, proxies, table);
}

// A candidate began or ceased to overlap.
void KeptCandidates::report(Candidate& candidate, Update& update) {
    const bool began = (candidate[1] & overlap_bit) == 0;
    candidate[1] ^= overlap_bit;
    const ProxyPair pair = ordered_pair(proxies_[candidate[0]], proxies_[candidate[1] & ~overlap_bit]);
    (began ? update.began : update.ended).push_back(pair);
}

// A candidate goes.
void KeptCandidates::report_removed(const Candidate& candidate, Update& update) {
    if ((candidate[1] & overlap_bit) == 0 || update.are_removed_reported) return;
    update.ended.push_back(ordered_pair(proxies_[candidate[0]], proxies_[candidate[1] & ~overlap_bit]));
}

void KeptCandidates::filter(Update& update) {
    update.counts.candidates_filtered += candidates_.size();
    if (changed_slots_.empty()) {
        dispatch<Loops::filter<false>>(*this, update);
        return;
    }
    dispatch<Loops::filter<true>>(*this, update);
    for (const SlotIndex slot : changed_slots_) {
        clear_flag(slot, changed);
        if (lines_[slot].is_empty()) free_slots_.push_back(slot);
    }
    changed_slots_.clear();
}

}  // namespace ecods
