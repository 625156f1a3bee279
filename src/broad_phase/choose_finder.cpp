#include "broad_phase/choose_finder.hpp"

namespace ecods {

BroadPhaseKind ChooseFinder::choose(std::size_t size, const BroadPhaseCounts& before,
                                    const BroadPhaseCounts& after) noexcept {
    // Far enough apart that a scene that grows and shrinks does not switch each time.
    constexpr std::size_t size_min = 64, size_max = 256;
    constexpr std::uint64_t steps_per_move = 8;
    if (kind_ == BroadPhaseKind::kept_candidates) {
        if (size < size_min) kind_ = BroadPhaseKind::sweep_and_prune;
        return kind_;
    }
    moved_ += after.moved - before.moved;
    steps_ += after.swaps - before.swaps;
    if (size > size_max && steps_ > steps_per_move * moved_ && moved_ > size) {
        kind_ = BroadPhaseKind::kept_candidates;
    }
    if (moved_ > 4 * size || kind_ == BroadPhaseKind::kept_candidates) moved_ = steps_ = 0;
    return kind_;
}

}  // namespace ecods
