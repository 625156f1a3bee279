#include "broad_phase/choose_finder.hpp"

namespace ecods {

BroadPhaseKind ChooseFinder::choose(const Work& last) noexcept {
    // Far enough apart that a scene that grows and shrinks does not switch each time.
    constexpr std::size_t size_min = 64, size_max = 256;
    if (kind_ == BroadPhaseKind::kept_candidates) {
        if (last.size < size_min) kind_ = BroadPhaseKind::sweep_and_prune;
        return kind_;
    }
    constexpr std::uint64_t period = 16, swaps_per_move_max = 8;
    ++updates_;
    moved_ += last.moved;
    swaps_ += last.swaps;
    const bool is_dynamic = moved_ > last.size;  // in a period, or in less
    const bool is_crowded = swaps_ > swaps_per_move_max * moved_ && moved_ > last.size / 16;
    if (last.size > size_max && (is_dynamic || is_crowded)) kind_ = BroadPhaseKind::kept_candidates;
    if (updates_ == period || kind_ == BroadPhaseKind::kept_candidates) updates_ = moved_ = swaps_ = 0;
    return kind_;
}

}  // namespace ecods
