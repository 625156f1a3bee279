// This header computes times on a way whose legs all take equal shares of the time from 0 to 1 (motion.hpp).
#pragma once

#include <cstddef>

namespace ecods {

// Returns the time (k + s) / n on the way, for time s of leg k of n legs. The result is rounded once, and at least
// 2^-1074 unless it is 0.
double time_on_way(std::size_t leg, double time_in_leg, std::size_t leg_count);

// Returns the number of legs that begin at or before `time`, which is from 0 to 1. Leg 0 always counts.
std::size_t legs_begun(double time, std::size_t leg_count);

}  // namespace ecods
