// A check that did not hold.
#pragma once

#include <stdexcept>
#include <string>

namespace ecods::fuzz {

class CheckFailed : public std::runtime_error {
  public:
    CheckFailed(std::string check_name, const std::string& detail)
        : std::runtime_error(detail), check(std::move(check_name)) {}

    std::string check;
};

inline void require(bool holds, const char* check, const std::string& detail) {
    if (!holds) throw CheckFailed(check, detail);
}

}  // namespace ecods::fuzz
