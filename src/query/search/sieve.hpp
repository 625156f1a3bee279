// The pairs of triangles that are still in question: which may be left out, and when exact arithmetic is asked.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "ecods/ids.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Which numbers a search is about, and when it may stop.
struct SearchGoal {
    double at_most = std::numeric_limits<double>::infinity();  // of greater numbers no more is said than that
    double stop_at = -1;                                       // as soon as some number is proven to be at most that
    // Pairs whose number is less than that below the least one found may be left out; see Sieve::floor.
    double relative = 0;
    double absolute = 0;
};

// Returns whether a number from `lower` to `upper` is at most d, for the real numbers; exact() is asked where these do
// not say.
template <class Exact>
bool is_within(double lower, double upper, double d, Exact&& exact) {
    if (key_of(lower) > key_of(d)) return false;
    return key_of(upper) <= key_of(d) || exact();
}

// Numbers are compared by their keys, in any rounding mode (base/double_key.hpp). Rounding is monotone: a number whose
// lower bound is above a double does not round to it, nor to less.
template <class Interval, class Value>
class Sieve {
  public:
    struct Open {
        Interval interval;
        TrianglePair triangles;
        std::optional<Value> value = {};  // rounded once, where it is known; the ends of the interval are its number
    };

    void start(const SearchGoal& goal) noexcept {
        goal_ = goal;
        open_.clear();
        upper_ = std::numeric_limits<double>::infinity();
        nearest_ = {};
        is_zero_ = false;
        set_bounds();
    }

    // Returns whether a pair is in question whose number is at least `lower`.
    bool counts(double lower) const noexcept { return key_of(lower) <= most_; }
    // Returns whether nothing more need be asked to reach the goal.
    bool is_decided() const noexcept { return is_zero_ || key_of(upper_) <= key_of(goal_.stop_at); }

    // Takes note that a pair shares a point. Then nothing more is known.
    void take_zero(const TrianglePair& triangles) noexcept {
        is_zero_ = true;
        nearest_ = {triangles.a, triangles.b};
    }
    void take_zero() noexcept { is_zero_ = true; }
    // Takes note that some pair's number is at most `upper`, or rounds to it. Returns whether that leaves out more.
    bool take_upper(double upper, const TrianglePair& triangles) noexcept {
        if (nearest_.a == PairWitness::none) nearest_ = {triangles.a, triangles.b};  // even if it is infinitely far
        if (!(key_of(upper) < key_of(upper_))) return false;
        upper_ = upper;
        nearest_ = {triangles.a, triangles.b};
        set_bounds();
        return true;
    }
    void add(const Open& open) { open_.push_back(open); }
    void forget_open() noexcept { open_.clear(); }

    bool is_zero() const noexcept { return is_zero_; }
    // No number above it is in question; nearest() has at most that, or is none.
    double upper() const noexcept { return upper_; }
    const PairWitness& nearest() const noexcept { return nearest_; }
    // No pair that was left out because of the goal's relative or absolute width has a lesser number.
    double floor() const noexcept { return floor_; }
    // Nodes without a number up to that may be left out.
    double bound() const noexcept { return lesser(goal_.at_most, floor_); }

    std::vector<Open>& open() noexcept { return open_; }
    // Leaves out the pairs that are not in question any more.
    void drop() {
        std::erase_if(open_, [&](const Open& open) { return !counts(open.interval.lower); });
    }

    // The least of the open pairs' numbers, as a value, which nearest() has; nothing if none has one. It may be above
    // the goal's at_most, and not be the least of all then. round(open, least) gives the value of a pair, or nothing if
    // it is not less than the least one so far; number(value) is what is to be least, and of equal ones rank(value).
    template <class Round, class Number, class Rank>
    std::optional<Value> least(Round&& round, Number&& number, Rank&& rank) {
        std::optional<Value> least;
        for (const Open& open : group()) {
            if (!counts(open.interval.lower)) continue;
            const std::optional<Value> value = open.value ? open.value : round(open, least);
            if (!value) continue;
            const auto order = [&](const Value& v) { return std::pair(key_of(number(v)), rank(v)); };
            if (least && !(order(*value) < order(*least))) continue;
            least = value;
            upper_ = lesser(upper_, number(*value));
            set_bounds();
            nearest_ = {open.triangles.a, open.triangles.b};
        }
        return least;
    }

    // Returns whether some open pair's number is at most d, for the real numbers; nearest() is one then.
    template <class Exact>
    bool is_least_within(double d, Exact&& exact) {
        for (const Open& open : group()) {
            // A value is rounded: its number may be above it.
            const double upper = open.value ? infinity : open.interval.upper;
            if (!is_within(open.interval.lower, upper, d, [&] { return exact(open.triangles); })) continue;
            nearest_ = {open.triangles.a, open.triangles.b};
            return true;
        }
        return false;
    }

    // Keeps all open pairs that have the least number, for the real numbers; of those with the same features the least
    // pair of triangles. compare(x, y) is the sign of the number of x less that of y.
    template <class Compare>
    std::vector<Open>& keep_least(Compare&& compare) {
        group();
        // Those that may be the least are moved to the front, over those that have been judged.
        std::size_t count = std::min<std::size_t>(open_.size(), 1);
        for (std::size_t at = 1; at < open_.size(); ++at) {
            const Open pair = open_[at];
            if (key_of(pair.interval.lower) > key_of(open_[0].interval.upper)) continue;
            const int sign = key_of(pair.interval.upper) < key_of(open_[0].interval.lower)
                                 ? -1
                                 : compare(pair.triangles, open_[0].triangles);
            if (sign < 0) count = 0;
            if (sign <= 0) open_[count++] = pair;
        }
        open_.resize(count);
        return open_;
    }

  private:
    static constexpr double infinity = std::numeric_limits<double>::infinity();

    static double lesser(double x, double y) noexcept { return key_of(y) < key_of(x) ? y : x; }

    void set_bounds() noexcept {
        most_ = std::min(key_of(goal_.at_most), key_of(upper_));
        floor_ = upper_;
        if (goal_.absolute > 0 || goal_.relative > 0) {
            floor_ = std::max({upper_ - goal_.absolute, upper_ / (1 + goal_.relative), 0.0});
        }
    }

    // Keeps, of pairs that certainly have the same features and so the same number, the least pair of triangles, around
    // a vertex and on both sides of an edge. The pairs that are left are in the order of their upper bounds; a value
    // that is known comes before a bound that is equal.
    std::vector<Open>& group() {
        if (open_.size() < 2) return open_;
        const auto order = [](const Open& x) {
            const bool is_open = !x.interval.is_certain;
            return std::tuple(is_open, is_open ? decltype(x.interval.a){} : x.interval.a,
                              is_open ? decltype(x.interval.b){} : x.interval.b, x.triangles, !x.value);
        };
        std::ranges::sort(open_, {}, order);
        const auto have_same_number = [](const Open& x, const Open& y) {
            const Interval &i = x.interval, &j = y.interval;
            return x.triangles == y.triangles || (i.is_certain && j.is_certain && i.a == j.a && i.b == j.b);
        };
        open_.erase(std::unique(open_.begin(), open_.end(), have_same_number), open_.end());
        std::ranges::sort(open_, {}, [](const Open& x) { return std::pair(key_of(x.interval.upper), !x.value); });
        return open_;
    }

    SearchGoal goal_;
    std::vector<Open> open_;
    double upper_ = infinity;
    double floor_ = infinity;
    std::int64_t most_ = 0;  // the key of the greatest number that is in question
    PairWitness nearest_;
    bool is_zero_ = false;
};

}  // namespace ecods
