// The names of features: the library's beside the oracle's.
#pragma once

#include "exact/measure/distance/feature_pair.hpp"
#include "oracle/distance.hpp"

namespace ecods::guesses {

// Whether what the oracle found is on these features of two meshes of one triangle.
template <class Found>
bool are_features(const exact::FeaturePair& f, const Found& found) {
    const auto named = [&](std::size_t side, std::uint32_t corner) {
        return oracle::NamedFeature{static_cast<int>(f.corner_count(side)) - 1, 0, corner};
    };
    return found.a == named(0, f.a) && found.b == named(1, f.b);
}

}  // namespace ecods::guesses
