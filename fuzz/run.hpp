// One run of the fuzzer: a scene from a seed, in motion.
#pragma once

#include <cstdint>
#include <string>

#include "fuzz/check_frame.hpp"
#include "fuzz/counters.hpp"

namespace ecods::fuzz {

struct Failure {
    std::uint32_t seed = 0;
    int frame = 0;
    std::string check = {};
    std::string detail = {};
};

inline constexpr int frames_per_run = 40;

// Throws Failure. The same seed is the same run, on every machine.
void run(std::uint32_t seed, const CheckOptions& options, Counters& counters);

}  // namespace ecods::fuzz
