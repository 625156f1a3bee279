// Keeps the least number so far and the candidate that has it, for questions such as "which body is nearest".
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/double_key.hpp"

namespace ecods {

// Least keeps the candidate with the least number: a distance or a time. Distances may be signed; other numbers are >=
// 0. For each candidate, the caller can compute the number rounded to a double, and can decide whether the unrounded
// number is at most a given double >= 0. `Name` is the id of a candidate (a body or a pair); among equal rounded
// numbers the least name wins. Numbers are stored as integer keys, because a processor that flushes subnormal numbers
// would compare them as equal to zero.
template <class Name>
class Least {
  public:
    explicit Least(double limit) noexcept : limit_(key_of(limit)) {}

    // Returns an upper bound of the unrounded number that a candidate with this name must have to win; nullopt if only
    // a negative number can win.
    //
    // Let m be the least rounded number so far. A candidate with rounded number r wins if r < m, or if r = m and its
    // name is less. In the first case its unrounded number is at most m. In the second case it is at most the double
    // above m, and 0 if m is 0: a number above a double rounds to that double or more, and a positive number to at
    // least 2^-1074. In both cases it is at most the limit.
    std::optional<double> reach(const Name& name) const noexcept {
        if (!has_name_) return double_of(limit_);
        const bool wins_ties = name < name_;
        if (number_ < 0 || (number_ == 0 && !wins_ties)) return std::nullopt;
        return double_of(wins_ties && number_ > 0 ? std::min(limit_, number_ + 1) : number_);
    }

    // Returns true if a candidate with this name, whose unrounded number is at least `lower`, may win. The rounded
    // number is at least `lower`, too.
    bool may_win(const Name& name, double lower) const noexcept {
        const std::int64_t key = key_of(lower);
        if (!has_name_) return key <= limit_;
        return key < number_ || (key == number_ && name < name_);
    }

    // Takes a candidate whose unrounded number is at most reach(name), and its rounded number. Returns true if the
    // candidate becomes the least so far.
    bool take(const Name& name, double rounded) noexcept {
        const std::int64_t key = key_of(rounded);
        if (has_name_ && (key > number_ || (key == number_ && !(name < name_)))) return false;
        has_name_ = true;
        name_ = name;
        number_ = key;
        return true;
    }

    // Returns an upper bound of the unrounded numbers with which later candidates may win.
    double bound() const noexcept { return double_of(has_name_ ? number_ : limit_); }
    bool has_name() const noexcept { return has_name_; }
    const Name& name() const noexcept { return name_; }
    double number() const noexcept { return double_of(number_); }

  private:
    std::int64_t limit_;
    bool has_name_ = false;
    Name name_{};
    std::int64_t number_ = 0;
};

}  // namespace ecods
