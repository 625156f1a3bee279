// PairQuestion lists the functions of a question about two bodies that Search calls.
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>

#include "bvh/walks/walk_nearest.hpp"
#include "ecods/ids.hpp"

namespace ecods {

// A PairQuestion assigns a number (a distance or a time) to each pair of triangles; the result of a search is the least
// number. No number is negative, and a number is 0 exactly if the pair shares a point. A PairQuestion has these
// functions.
//
// `limit_above(number)` returns a float that bounds nodes: a node that holds a pair with at most this number has a
// lower bound of at most this float. `find_near(x, y, limit, bounds)` returns the set of pairs of lanes, as bits, whose
// lower bounds may be at most `limit`. It sets the `bounds` of these pairs, which are finite and not negative, as
// near_mask does. `may_share(bound)` returns true if the search must test whether nodes with this lower bound share a
// point.
//
// `enclose(pair, at_most)` returns an Interval: two doubles that are proven bounds of the pair's number. If the number
// exceeds `at_most`, `lower` may be infinity. `lower` is 0 unless a greater bound is proven. All pairs whose intervals
// have `is_certain` set and equal features `a` and `b` have the same number. `complete(pair, interval, value)` is
// called before the pair is stored. If `upper` is infinite (such a pair excludes no other), it may decide the pair
// exactly: it then sets `value` to the Value, rounded once, and both ends of `interval` to its number. It returns false
// if the pair has no number.
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

// An ExcludingQuestion can also exclude a pair by proving that its number is at least that of a remembered pair.
//
// `refer_to(pair)` stores `pair`, whose triangles must not share a point, as the remembered pair, and returns true if
// `pair` replaces another pair. A question may decline: it then remembers no pair and returns false.
// `is_not_less(pair)` returns true if the pair's number is certainly at least that of the remembered pair.
template <class Question>
concept ExcludingQuestion = PairQuestion<Question> && requires(Question& question, const TrianglePair& pair) {
    { question.refer_to(pair) } -> std::same_as<bool>;
    { question.is_not_less(pair) } -> std::same_as<bool>;
};

}  // namespace ecods
