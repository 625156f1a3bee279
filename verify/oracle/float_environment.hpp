// The floating-point environment that interval arithmetic needs.
#pragma once

#include <cfenv>

namespace ecods::oracle {

// While it lives: rounding upwards, no flush-to-zero, no traps, whatever the caller had set. Afterwards: as it was.
class FloatEnvironment {
  public:
    FloatEnvironment();
    ~FloatEnvironment();
    FloatEnvironment(const FloatEnvironment&) = delete;
    FloatEnvironment& operator=(const FloatEnvironment&) = delete;

  private:
    std::fenv_t saved_;
};

}  // namespace ecods::oracle
