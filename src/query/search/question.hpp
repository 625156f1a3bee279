// PairQuestion lists the functions of a question that a search calls about pairs of triangles of two bodies.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "bvh/walks/walk_nearest.hpp"
#include "ecods/ids.hpp"

namespace ecods {

// A question gives each pair of triangles a number, a distance or a time, and wants the least ones. No number is
// negative, and a number is 0 exactly if the pair shares a point.
//
// `limit_above(number)` returns a float: an upper bound of the lower bounds of all nodes that hold a pair with at most
// this number.
// `find_near(x, y, limit, bounds)` returns, as bits, the pairs of lanes whose lower bounds may be at most `limit`, and
// sets these bounds, finite and not negative, as near_mask does.
// `may_share(bound)` returns true if the search is to test whether nodes with this lower bound share a point.
// `enclose(pair, at_most)` returns an Interval of doubles with proven bounds. It contains the number if that is at most
// `at_most`; otherwise `lower` may be infinity. `lower` is 0 unless the number is proven to be greater. All pairs whose
// intervals have `is_certain` set and the same features `a` and `b` have the same number.
// `complete(pair, interval, value)` may decide a pair exactly if `upper` is infinite and so excludes no other pair: it
// then sets the Value, rounded once, and both ends of the interval to its number. Returns false if the pair has no
// number.
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

// An ExcludingQuestion can also exclude pairs exactly, by comparing them with one that it remembers.
//
// `refer_to(pair)` remembers a pair that shares no point, and returns true if it is another one than before. A question
// may choose to remember none and return false.
// `is_not_less(pair)` returns true if the number of the pair is certainly at least that of the remembered pair.
template <class Question>
concept ExcludingQuestion = PairQuestion<Question> && requires(Question& question, const TrianglePair& pair) {
    { question.refer_to(pair) } -> std::same_as<bool>;
    { question.is_not_less(pair) } -> std::same_as<bool>;
};

}  // namespace ecods
