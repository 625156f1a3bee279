// Finds the shortest script that still fails.
#pragma once

#include <functional>

#include "fuzz/script/script.hpp"

namespace ecods::fuzz {

struct ShrinkOptions {
    // True if a script still fails, and in the same way.
    std::function<bool(const Script&)> fails;
    double seconds_max = 60;
};

// Drops bodies, calls, poses set with others, triangles; lets bodies share meshes; moves poses and other fields to the
// calls that create the bodies; makes fields simpler and numbers rounder; until no such step leaves a script that
// fails, or time is up. The script given must fail. Source of the halving: Zeller and Hildebrandt, Simplifying and
// Isolating Failure-Inducing Input, 2002.
Script shrink(const Script& script, const ShrinkOptions& options);

}  // namespace ecods::fuzz
