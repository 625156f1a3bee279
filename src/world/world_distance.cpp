#include <algorithm>
#include <utility>

#include "base/limits.hpp"
#include "geometry/feature_key.hpp"
#include "query/intersection/asking.hpp"
#include "world/world_impl.hpp"

namespace ecods {

double World::distance(const Asked& a, const Asked& b, const Ask& ask) const {
    Asking asking(ask);
    return impl().pair_of(a, b).ask(&TwoBodyTest::distance, Ask(asking.memory(), asking.witness()));
}

bool World::within(const Asked& a, const Asked& b, double max_distance, const Ask& ask) const {
    const SubjectPair pair = impl().pair_of(a, b);
    require_distance(max_distance);
    Asking asking(ask);
    return pair.ask(&TwoBodyTest::within, max_distance, Ask(asking.memory(), asking.witness()));
}

ClosestPoints World::closest(const Asked& a, const Asked& b, const Ask& ask) const {
    const SubjectPair pair = impl().pair_of(a, b, Impl::PairOrder::lesser_id_first);
    const ClosestPoints points = pair.ask(&TwoBodyTest::closest, Ask(Asking(ask).memory()));
    return pair.test.swapped != pair.is_turned ? turned(points) : points;
}

std::vector<CloseFeatures> World::close_features(const Asked& a, const Asked& b, double max_distance,
                                                 const Ask& ask) const {
    const SubjectPair pair = impl().pair_of(a, b);
    require_finite_distance(max_distance);
    auto found = pair.ask(&TwoBodyTest::close_features, max_distance, Ask(Asking(ask).memory()));
    if (pair.test.swapped) {
        for (CloseFeatures& each : found) {
            each.closest = turned(each.closest);
            if (each.direction) *each.direction = -*each.direction;
        }
        std::ranges::stable_sort(found, {}, [](const CloseFeatures& each) { return rank(each.closest); });
    }
    return found;
}

}  // namespace ecods
