#include "broad_phase/choose_finder.hpp"

namespace ecods {

BroadPhaseKind ChooseFinder::choose(std::size_t size) noexcept {
    // Far enough apart that a scene that grows and shrinks does not switch each time.
    constexpr std::size_t size_min = 64, size_max = 256;
    if (size < size_min) kind_ = BroadPhaseKind::sweep_and_prune;
    if (size > size_max) kind_ = BroadPhaseKind::kept_candidates;
    return kind_;
}

}  // namespace ecods
