// A check that did not hold.
#pragma once

#include <stdexcept>
#include <string>
#include <utility>

namespace ecods::fuzz {

class CheckFailed : public std::runtime_error {
  public:
    CheckFailed(std::string check_name, std::string expected_text, std::string got_text)
        : std::runtime_error(check_name + ": expected " + expected_text + ", got " + got_text),
          check(std::move(check_name)),
          expected(std::move(expected_text)),
          got(std::move(got_text)) {}

    std::string check;  // its name, which says nothing of the input: a shrunk failure has the same
    std::string expected;
    std::string got;
};

}  // namespace ecods::fuzz
