// Sieve stores the pairs of triangles that may still have the least number of a search. The sieve decides which pairs
// may be dropped, and when exact arithmetic is needed.
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

// SearchGoal defines which numbers a search must find, and when the search may stop.
struct SearchGoal {
    double at_most = std::numeric_limits<double>::infinity();  // numbers above this need not be found
    double stop_at = -1;  // the search stops when some number is proven to be at most this
    // `relative` and `absolute` define how exact the result must be. Let m be the least upper bound found so far. Pairs
    // with numbers above max(m - absolute, m / (1 + relative)) may be dropped; see Sieve::floor.
    double relative = 0;
    double absolute = 0;
};

// Returns true if a real number between `lower` and `upper` is at most d. Calls exact() if the two bounds leave this
// undecided.
template <class Exact>
bool is_within(double lower, double upper, double d, Exact&& exact) {
    if (key_of(lower) > key_of(d)) return false;
    return key_of(upper) <= key_of(d) || exact();
}

// A Sieve compares numbers by their keys, so the rounding mode does not matter (base/double_key.hpp). Rounding is
// monotone: a number with a lower bound greater than a double rounds to more than that double.
template <class Interval, class Value>
class Sieve {
  public:
    struct Open {
        Interval interval;
        TrianglePair triangles;
        std::optional<Value> value = {};  // rounded once; both ends of `interval` are then its number
    };

    void start(const SearchGoal& goal) noexcept {
        goal_ = goal;
        open_.clear();
        upper_ = std::numeric_limits<double>::infinity();
        nearest_ = {};
        is_zero_ = false;
        set_bounds();
    }

    // Returns true if a pair whose number is at least `lower` may still have the least number.
    bool counts(double lower) const noexcept { return key_of(lower) <= most_; }
    // Returns true if the goal is reached, so that the search may stop.
    bool is_decided() const noexcept { return is_zero_ || key_of(upper_) <= key_of(goal_.stop_at); }

    // Stores a pair of triangles that shares a point, so that its number is 0. The search is then decided, and open()
    // is not used.
    void take_zero(const TrianglePair& triangles) noexcept {
        is_zero_ = true;
        nearest_ = {triangles.a, triangles.b};
    }
    void take_zero() noexcept { is_zero_ = true; }
    // Lowers the upper bound of the least number to `upper`: the number of the pair `triangles` is at most `upper`, or
    // rounds to `upper`. Returns true if the bound was greater, so that more pairs may be dropped.
    bool take_upper(double upper, const TrianglePair& triangles) noexcept {
        if (nearest_.a == PairWitness::none) nearest_ = {triangles.a, triangles.b};  // also if `upper` is infinite
        if (!(key_of(upper) < key_of(upper_))) return false;
        upper_ = upper;
        nearest_ = {triangles.a, triangles.b};
        set_bounds();
        return true;
    }
    void add(const Open& open) { open_.push_back(open); }
    void forget_open() noexcept { open_.clear(); }

    bool is_zero() const noexcept { return is_zero_; }
    // Returns an upper bound of the least number: the upper bound of nearest(), if there is such a pair.
    double upper() const noexcept { return upper_; }
    const PairWitness& nearest() const noexcept { return nearest_; }
    // Returns a lower bound of the numbers of all pairs that were dropped because of the goal's relative or absolute
    // width.
    double floor() const noexcept { return floor_; }
    // Returns the number above which pairs may be dropped. A node may be dropped if the numbers of all its pairs are
    // above it.
    double bound() const noexcept { return lesser(goal_.at_most, floor_); }

    std::vector<Open>& open() noexcept { return open_; }
    // Removes the open pairs that cannot have the least number any more.
    void drop() {
        std::erase_if(open_, [&](const Open& open) { return !counts(open.interval.lower); });
    }

    // Returns the least Value of the open pairs, and makes the pair of this Value nearest(); nullopt if no pair has a
    // value. If the least number exceeds the goal's at_most, dropped pairs may have lesser ones.
    //
    // round(open, least) must return the value of a pair, or nullopt if it is not less than `least`, the least value so
    // far. Values are ordered by number(value), then by rank(value).
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

    // Returns true if the unrounded number of some open pair is at most d, and then makes this pair nearest(). Calls
    // exact(triangles) for a pair that the pair's interval does not decide.
    template <class Exact>
    bool is_least_within(double d, Exact&& exact) {
        for (const Open& open : group()) {
            // If the value is known, `upper` is a rounded number, which the real number may exceed.
            const double upper = open.value ? infinity : open.interval.upper;
            if (!is_within(open.interval.lower, upper, d, [&] { return exact(open.triangles); })) continue;
            nearest_ = {open.triangles.a, open.triangles.b};
            return true;
        }
        return false;
    }

    // Reduces open() to the pairs with the least unrounded number. Of several pairs that certainly have the same
    // features, only the least pair of triangles is left. compare(x, y) must return the sign of (number of x) - (number
    // of y).
    template <class Compare>
    std::vector<Open>& keep_least(Compare&& compare) {
        group();
        // Moves pairs that may be the least to the front. They overwrite only pairs that have already been compared.
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

    // Reduces each group of pairs that certainly have the same features, and so the same number, to its least pair of
    // triangles. (Such groups occur around a vertex and at both sides of an edge.) Sorts the pairs that are left by
    // their upper bounds; at equal bounds, pairs with a known value come first.
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
    std::int64_t most_ = 0;  // key of the greatest number that may still be the answer
    PairWitness nearest_;
    bool is_zero_ = false;
};

}  // namespace ecods
