#include "query/body/small_pair.hpp"

#include "base/double_key.hpp"
#include "query/body/segment_filter.hpp"

namespace ecods {

SmallPair::SmallPair(const RoundedPair& pair) noexcept : pair_(pair) {
    const auto& [a, b] = pair;
    if (key_of(a.radius) == 0 && key_of(b.radius) == 0) return;
    are_segments_ = is_segment(*a.core.what) && is_segment(*b.core.what);
    if (are_segments_) return;
    hulls_.emplace(a.core, b.core);
    if (!hulls_->are_small()) hulls_.reset();
}

std::optional<int> SmallPair::compare(double max_distance) noexcept {
    const auto& [a, b] = pair_;
    if (are_segments_) return compare_segments(a.core, b.core, a.radius, b.radius, max_distance);
    return hulls_ ? hulls_->compare((a.radius + b.radius) + max_distance) : std::nullopt;
}

std::optional<RoundedSegments> SmallPair::find_closest() {
    if (are_segments_) return RoundedSegments::find(pair_.a, pair_.b);
    return hulls_ ? RoundedSegments::find_of_hulls(pair_.a, pair_.b, *hulls_) : std::nullopt;
}

}  // namespace ecods
