// Sieve holds the pairs of triangles that are still in question. It decides which may be left out, and when exact
// arithmetic is needed.
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

// SearchGoal says which numbers a search is about, and when it may stop.
struct SearchGoal {
    double at_most = std::numeric_limits<double>::infinity();  // a greater number is only known to be greater
    double stop_at = -1;                                       // stops when some number is proven to be at most this
    // A pair may be left out if its number is less than the least one found by at most these widths; see Sieve::floor.
    double relative = 0;
    double absolute = 0;
};

// True if a real number between `lower` and `upper` is at most d. Calls exact() if the two bounds do not decide.
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
        std::optional<Value> value = {};  // rounded once, if known: the interval's ends are then its number
    };

    void start(const SearchGoal& goal) noexcept {
        goal_ = goal;
        open_.clear();
        upper_ = std::numeric_limits<double>::infinity();
        nearest_ = {};
        is_zero_ = false;
        set_bounds();
    }

    // True if a pair whose number has this lower bound is in question.
    bool counts(double lower) const noexcept { return key_of(lower) <= most_; }
    // True if nothing more need be asked to reach the goal.
    bool is_decided() const noexcept { return is_zero_ || key_of(upper_) <= key_of(goal_.stop_at); }

    // Records that a pair shares a point. The search is then decided, and the open pairs have no meaning.
    void take_zero(const TrianglePair& triangles) noexcept {
        is_zero_ = true;
        nearest_ = {triangles.a, triangles.b};
    }
    void take_zero() noexcept { is_zero_ = true; }
    // Records that the number of some pair is at most `upper`, or rounds to it. Returns true if that may leave out more
    // pairs.
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
    // Returns an upper bound of the numbers in question, and of the number of nearest() if there is such a pair.
    double upper() const noexcept { return upper_; }
    const PairWitness& nearest() const noexcept { return nearest_; }
    // Returns a lower bound of the numbers of pairs that were left out because of the goal's relative or absolute
    // width.
    double floor() const noexcept { return floor_; }
    // Returns the number beyond which nodes may be left out: nodes whose pairs all have greater numbers.
    double bound() const noexcept { return lesser(goal_.at_most, floor_); }

    std::vector<Open>& open() noexcept { return open_; }
    // Removes the open pairs that are not in question any more.
    void drop() {
        std::erase_if(open_, [&](const Open& open) { return !counts(open.interval.lower); });
    }

    // Returns the least number of the open pairs as a value, and makes its pair nearest(); nothing if no pair has a
    // value. If the value exceeds the goal's at_most, it may not be the least of all pairs.
    // round(open, least) returns the value of a pair, or nothing if it is not less than `least`, the least so far.
    // Values are ordered by number(value), then by rank(value).
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

    // True if the real number of some open pair is at most d; nearest() is then such a pair. exact(triangles) decides
    // if the interval does not.
    template <class Exact>
    bool is_least_within(double d, Exact&& exact) {
        for (const Open& open : group()) {
            // The interval of a known value is rounded, and its real number may be greater.
            const double upper = open.value ? infinity : open.interval.upper;
            if (!is_within(open.interval.lower, upper, d, [&] { return exact(open.triangles); })) continue;
            nearest_ = {open.triangles.a, open.triangles.b};
            return true;
        }
        return false;
    }

    // Keeps all open pairs that have the least real number; of pairs with certainly the same features, keeps the least
    // pair of triangles. compare(x, y) returns the sign of (number of x) - (number of y).
    template <class Compare>
    std::vector<Open>& keep_least(Compare&& compare) {
        group();
        // Pairs that may be the least are moved to the front, over pairs that were already judged.
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

    // Removes pairs that certainly have the same features and so the same number, as around a vertex and on both sides
    // of an edge: keeps the least pair of triangles of each group. Sorts the pairs that are left by their upper bounds;
    // a known value comes before an equal bound.
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
    std::int64_t most_ = 0;  // key of the greatest number in question
    PairWitness nearest_;
    bool is_zero_ = false;
};

}  // namespace ecods
