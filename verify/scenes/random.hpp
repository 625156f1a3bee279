// Random numbers for scenes: the same for the same seed on every machine and compiler. No function here calls the
// mathematical library beyond the square root, which IEEE 754 rounds correctly.
#pragma once

#include <Eigen/Geometry>

#include <cstdint>
#include <memory>

#include "ecods/pose.hpp"

namespace ecods::scenes {

// GSL's Mersenne Twister. Not safe from two threads at once; copying is not offered, because two copies that give the
// same numbers are mostly a mistake.
class Random {
  public:
    explicit Random(std::uint32_t seed);
    ~Random();

    double uniform(double min, double max);    // min <= x <= max, in steps of (max - min) / 2^32
    std::uint32_t below(std::uint32_t count);  // 0 <= n < count; count must be positive
    Vec3 direction();                          // of length 1 up to rounding, evenly over the sphere
    Eigen::Quaterniond rotation();             // of norm 1 up to rounding, evenly over all rotations
    Pose turned() { return {rotation().toRotationMatrix(), Vec3::Zero()}; }

  private:
    struct Generator;
    std::unique_ptr<Generator> generator_;
};

}  // namespace ecods::scenes
