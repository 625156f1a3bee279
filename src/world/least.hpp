// The least number so far, and whose it is: for questions that look for the nearest or the first of bodies or pairs.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>

#include "base/double_key.hpp"

namespace ecods {

// Of distances, or times: real numbers that are not negative, of which candidates give the rounded ones, and decide
// whether theirs is at most a double. `Name` is that of a body or a pair, and decides ties. Numbers are keys: subnormal
// ones are not to be taken for zero.
template <class Name>
class Least {
  public:
    explicit Least(double limit) noexcept : limit_(key_of(limit)) {}

    // What the real number of a candidate must not be above if it is to win; nothing where it cannot win.
    //
    // With a rounded number r it wins if r is less than the least one, or equal and its name is less. Then the real
    // number is at most the least one in the first case, and the double above that in the second, as what is greater
    // rounds to no less; and in both at most the limit.
    std::optional<double> reach(const Name& name) const noexcept {
        if (!has_name_) return double_of(limit_);
        const bool wins_ties = name < name_;
        if (number_ == 0 && !wins_ties) return std::nullopt;
        return double_of(wins_ties && number_ > 0 ? std::min(limit_, number_ + 1) : number_);
    }

    // Takes a candidate with this rounded number, whose real one is within reach(). Returns whether it is the least.
    bool take(const Name& name, double rounded) noexcept {
        const std::int64_t key = key_of(rounded);
        if (has_name_ && (key > number_ || (key == number_ && !(name < name_)))) return false;
        has_name_ = true;
        name_ = name;
        number_ = key;
        return true;
    }

    // The limit for what comes.
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
