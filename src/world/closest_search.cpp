#include "world/closest_search.hpp"

#include "geometry/box_distance.hpp"
#include "world/pair_question.hpp"

namespace ecods {

// Tests the pair only if it can win. If `reach` is empty, a pair with a distance >= 0 cannot win: then the pair is
// tested only if it has a signed distance and a bound from the boxes allows its depth to win. A signed distance is
// computed with its points, which cost little more. All other points are computed at the end, only for the pair that
// has won.
double ClosestSearch::offer(ProxyPair pair) {
    if (least_.has_name() && least_.name() == pair) return bound();
    const PairQuestion asked(bodies_, tests_, pair);
    const std::optional<double> reach = least_.reach(pair);
    if (!reach &&
        (!least_.may_win(pair, signed_distance_below(boxes_.box(pair.a), boxes_.box(pair.b))) || !asked.is_signed())) {
        return bound();
    }
    PairHint& hint = hint_of(pair);
    const Ask ask(memory_, hint.witness);
    if (!asked.is_within(reach.value_or(0), ask, hint.axis)) return bound();
    std::optional<ClosestPair> found;
    if (asked.is_signed()) found = asked.find(ask);
    if (least_.take(pair, found ? found->distance : asked.distance(ask))) known_ = found;
    return bound();
}

std::optional<ClosestPair> ClosestSearch::answer() {
    if (!least_.has_name()) return std::nullopt;
    if (!known_) {
        known_ = PairQuestion(bodies_, tests_, least_.name()).find({memory_, hint_of(least_.name()).witness});
    }
    return known_;
}

}  // namespace ecods
