// Expectations are counted as they are asked, each beside the library's answer, for one source of them.
#pragma once

#include <cmath>
#include <cstddef>
#include <iostream>
#include <string>
#include <string_view>

namespace ecods::foreign {

// Counts what one source expects, and prints what differs.
class Expectations {
  public:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    // The answer to the expectation of number `changed` is taken for another one: it has to be seen as a difference.
    explicit Expectations(std::string_view source, std::size_t changed = none) : source_(source), changed_(changed) {}

    // Names the place in the source that the next expectations are from.
    void from(std::string_view place) { place_ = place; }

    // Expects the answer to be this one.
    template <class Answer>
    void is(const Answer& answer, const Answer& expected) {
        count(answer == expected, answer, expected, "");
    }
    // Expects a number as exactly as the source says it: the digits that it prints, or the error that it allows.
    void near(double answer, double expected, double within) {
        count(std::abs(answer - expected) <= within, answer, expected, " or near it");
    }

    std::size_t asked() const noexcept { return asked_; }
    std::size_t different() const noexcept { return different_; }

  private:
    static constexpr std::size_t printed_max = 10;

    template <class Answer>
    void count(bool agrees, const Answer& answer, const Answer& expected, const char* how) {
        if (asked_ == changed_) agrees = !agrees;
        if (!agrees && ++different_ <= printed_max && changed_ == none) {
            std::cout << source_ << ", " << place_ << ", expectation " << asked_ << ": " << expected << how
                      << ", but the answer is " << answer << '\n';
        }
        ++asked_;
    }

    std::string_view source_;
    std::string place_;
    std::size_t changed_;
    std::size_t asked_ = 0, different_ = 0;
};

}  // namespace ecods::foreign
