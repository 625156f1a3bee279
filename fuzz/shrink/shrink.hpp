// The shortest script that still fails.
#pragma once

#include <functional>

#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

struct ShrinkOptions {
    // Whether a script still fails in the way that is looked for.
    std::function<bool(const Script&)> fails;
    double seconds_max = 60;
};

// Drops bodies, calls, poses set with others, triangles; lets bodies share meshes; moves poses and shapes to where
// bodies are created; makes numbers rounder; until none of it leaves a script that fails, or time is up. The script
// given must fail. Source of the halving: Zeller and Hildebrandt, Simplifying and Isolating Failure-Inducing Input,
// 2002.
Script shrink(const Script& script, const ShrinkOptions& options);

}  // namespace ecods::fuzz
