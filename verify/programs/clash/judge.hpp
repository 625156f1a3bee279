// All clashes of some parts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "programs/clash/inputs.hpp"
#include "programs/clash/report.hpp"
#include "programs/clash/rules.hpp"

namespace ecods::clash {

inline constexpr std::size_t narrow_depth_limit = 256;

struct JudgeOptions {
    Rules rules = {};
    std::optional<double> clearance = {};  // finite, not negative
    bool has_touching = false;             // whether touching parts are clashes

    // Whether depth_bounds() says how deep solids are in each other that are not both convex, however many there are:
    // it does where these are at most narrow_depth_limit, and otherwise quick bounds are given.
    bool has_narrow_depths = false;

    std::size_t line_limit = 0;  // 0: points and lines are not found
    std::size_t jobs = 1;
};

// The report, without its options. It does not depend on the number of jobs.
ClashReport judge(Inputs inputs, const JudgeOptions& options);

}  // namespace ecods::clash
