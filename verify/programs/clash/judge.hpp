// All clashes of some parts.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "programs/clash/inputs.hpp"
#include "programs/clash/report.hpp"
#include "programs/clash/rules.hpp"

namespace ecods::clash {

struct JudgeOptions {
    Rules rules = {};
    std::optional<double> clearance = {};  // finite, not negative
    bool has_touching = false;             // whether touching parts are clashes
    bool has_narrow_depths = false;        // whether depth_bounds() says how deep solids with dents are
    std::size_t line_limit = 0;            // 0: points and lines are not found
    std::size_t jobs = 1;
};

// The report, without its options. It does not depend on the number of jobs.
ClashReport judge(Inputs inputs, const JudgeOptions& options);

}  // namespace ecods::clash
