// Keeps the least number so far and its owner, for questions that look for the nearest or the first of bodies or pairs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/double_key.hpp"

namespace ecods {

// Keeps the least of distances or times, which are real numbers >= 0. A candidate can give its number rounded, and can
// decide whether the real number is at most a given double. `Name` names a body or a pair, and decides ties. Numbers
// are stored as keys, so that subnormal ones are not taken for zero.
template <class Name>
class Least {
  public:
    explicit Least(double limit) noexcept : limit_(key_of(limit)) {}

    // Returns the upper bound that the real number of a candidate must keep if it is to win; nothing if it cannot win.
    //
    // Let m be the least rounded number so far. A candidate with rounded number r wins if r < m, or if r = m and its
    // name is less. In the first case its real number is at most m; in the second case it is at most the double above
    // m, and 0 if m is 0: a number above a double rounds to that double or more, and a positive one to at least
    // 2^-1074. In both cases it is at most the limit.
    std::optional<double> reach(const Name& name) const noexcept {
        if (!has_name_) return double_of(limit_);
        const bool wins_ties = name < name_;
        if (number_ == 0 && !wins_ties) return std::nullopt;
        return double_of(wins_ties && number_ > 0 ? std::min(limit_, number_ + 1) : number_);
    }

    // Takes a candidate with this rounded number; its real number must be within reach(). Returns true if it is the
    // least.
    bool take(const Name& name, double rounded) noexcept {
        const std::int64_t key = key_of(rounded);
        if (has_name_ && (key > number_ || (key == number_ && !(name < name_)))) return false;
        has_name_ = true;
        name_ = name;
        number_ = key;
        return true;
    }

    // Returns the upper bound for later candidates.
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
