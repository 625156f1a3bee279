// Computes times on a way of which all legs take equal shares of the time from 0 to 1 (motion.hpp).
#pragma once

#include <cstddef>

namespace ecods {

// Returns the time (k + s) / n of the time s of leg k, of n legs: rounded once, and at least 2^-1074 unless it is 0.
double time_on_way(std::size_t leg, double time_in_leg, std::size_t leg_count);

// Returns the number of legs whose beginning is at most a time from 0 to 1. Leg 0 always counts.
std::size_t legs_begun(double time, std::size_t leg_count);

}  // namespace ecods
