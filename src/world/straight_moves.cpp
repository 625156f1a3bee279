#include "world/straight_moves.hpp"

#include "base/double_key.hpp"
#include "ecods/error.hpp"
#include "query/body/rounded_moves.hpp"
#include "world/rounded_test.hpp"

namespace ecods {

void StraightMoves::add(const Posed<Shape>& body, const Pose* end) {
    const auto at_start = core_and_radius(body);
    if (!at_start) return;
    const bool is_turning = end != nullptr && !translation_of(at_start->core, *end);
    has_turning_ = has_turning_ || is_turning;
    ++counts_[{body.what->kind(), key_of(at_start->radius) != 0, is_turning}];
}

void StraightMoves::require_casts(const TwoBodyTests& tests) const {
    for (auto a = counts_.begin(); a != counts_.end(); ++a) {
        for (auto b = a; b != counts_.end(); ++b) {
            const Group &x = a->first, &y = b->first;
            const bool are_two = a != b || a->second > 1;
            const bool is_refused = (x.has_radius || y.has_radius) && (x.is_turning || y.is_turning);
            if (!are_two || !is_refused || !tests.find(x.kind, y.kind).has_signs) continue;
            throw NotSupported(Question::cast_moving, x.kind, y.kind);
        }
    }
}

}  // namespace ecods
