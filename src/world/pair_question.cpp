#include "world/pair_question.hpp"

#include <utility>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "query/convex/solid_pair.hpp"
#include "query/intersection/asking.hpp"
#include "query/intersection/query_memory.hpp"
#include "world/signed_distance_of.hpp"

namespace ecods {

bool PairQuestion::is_signed() const {
    return test_.has_signs && have_signed_distance(a_, b_);
}

bool PairQuestion::is_within(double max_distance, const Ask& ask) const {
    return key_of(max_distance) == infinity_key || test_.ask(a_, b_, &TwoBodyTest::within, max_distance, ask);
}

bool PairQuestion::is_within(double max_distance, const Ask& ask, Vec3& axis) const {
    if (!test_.has_signs || key_of(max_distance) == infinity_key) {
        return is_within(max_distance, ask);
    }
    const auto convex = as_convex_solids(a_, b_);
    if (!convex) return is_within(max_distance, ask);
    Asking asking(ask);
    return as_one_query(asking.memory(), [&] {
        return convex::within(convex->a, convex->b, max_distance, asking.memory(), asking.witness(), axis);
    });
}

double PairQuestion::distance(const Ask& ask) const {
    if (test_.has_signs) {
        if (const auto found = signed_distance_of(a_, b_, ask)) return found->distance;
    }
    return test_.ask(a_, b_, &TwoBodyTest::distance, ask);
}

// Tries the closest points of convex solids first. For solids that are apart, this saves rounding a direction, which
// costs as much as rounding a point and which the answer does not contain.
std::optional<ClosestPair> PairQuestion::find_signed(const Ask& ask) const {
    if (const auto convex = as_convex_solids(a_, b_)) {
        Asking asking(ask);
        const auto points = convex::closest(convex->a, convex->b, asking.memory(), asking.witness());
        if (points) return ClosestPair{ids_, points->distance, *points};
    }
    const auto found = signed_distance_of(a_, b_, ask);
    if (!found) return std::nullopt;
    const ClosestPoints points{found->distance, found->kind, found->a, found->b, found->point_a, found->point_b};
    ClosestPair pair{ids_, found->distance, points};
    if (key_of(found->distance) <= 0) pair.direction = found->direction;
    return pair;
}

ClosestPair PairQuestion::find(const Ask& ask) const {
    if (test_.has_signs) {
        if (const auto found = find_signed(ask)) return *found;
    }
    if (!test_.test->answers(Question::closest)) return {ids_, test_.ask(a_, b_, &TwoBodyTest::distance, ask)};
    ClosestPoints points = test_.ask(a_, b_, &TwoBodyTest::closest, ask);
    if (test_.swapped) points = turned(points);
    return {ids_, points.distance, points};
}

}  // namespace ecods
