// What a search asks of a question about the pairs of triangles of two bodies.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "bvh/walks/walk_nearest.hpp"
#include "ecods/ids.hpp"

namespace ecods {

// A question gives each pair of triangles a number that is not negative, a distance or a time, and wants the least
// ones. Pairs that share a point have the number 0, and no others do.
//
// `limit_above(number)`: a float that no lower bound of nodes with a pair of that number, or a lesser one, is above.
// `find_near(x, y, limit, bounds)`: the pairs of lanes that may have a bound of at most `limit`, as bits, and their
// lower bounds, finite and not negative, as near_mask has them.
// `may_share(bound)`: whether nodes with that lower bound may share a point.
// `enclose(pair, at_most)`: an Interval, of doubles with proven bounds: `lower` and `upper` contain the number if it is
// at most `at_most`; `lower` is 0 where it is not proven to be more, and may be infinity where it is more than that.
// Where `is_certain` is set, all pairs with the same features `a` and `b` have the same number. `complete(pair,
// interval, value)`: where leaving `upper` infinite would leave out nothing because of this pair, sets its Value,
// rounded once, and both ends to its number; returns false if it has none.
template <class Question>
concept PairQuestion = requires(Question& question, const BvhNode& node, const TreeLeaf& leaf, double number,
                                float bound, LaneBounds& bounds, const TrianglePair& pair,
                                typename Question::Interval& interval, std::optional<typename Question::Value>& value) {
    { question.limit_above(number) } -> std::same_as<float>;
    { question.find_near(node, node, bound, bounds) } -> std::same_as<std::uint64_t>;
    { question.find_near(node, leaf, bound, bounds) } -> std::same_as<std::uint64_t>;
    { question.find_near(leaf, node, bound, bounds) } -> std::same_as<std::uint64_t>;
    { question.find_near(leaf, leaf, bound, bounds) } -> std::same_as<std::uint64_t>;
    { question.may_share(bound) } -> std::same_as<bool>;
    { question.enclose(pair, number) } -> std::same_as<typename Question::Interval>;
    { question.complete(pair, interval, value) } -> std::same_as<bool>;
};

// A question that can exclude pairs exactly by one that is known.
//
// `refer_to(pair)` remembers a pair that shares no point, and returns true if it did not remember that before; it may
// remember none.
// `is_not_less(pair)`: whether the number of a pair is certainly not less than that of the one remembered.
template <class Question>
concept ExcludingQuestion = PairQuestion<Question> && requires(Question& question, const TrianglePair& pair) {
    { question.refer_to(pair) } -> std::same_as<bool>;
    { question.is_not_less(pair) } -> std::same_as<bool>;
};

}  // namespace ecods
