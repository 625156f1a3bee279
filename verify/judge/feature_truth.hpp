// What close_features() and intersections() answer, beside what the oracle does.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "judge/distance_truth.hpp"

namespace ecods::judge {

// As the library writes it.
std::vector<CloseFeatures> to_close_features(const std::vector<oracle::ExactCloseFeatures>& exact);
std::vector<TriangleIntersection> to_intersections(const std::vector<oracle::ExactIntersection>& exact);

// In hexadecimal floats.
std::string text(const CloseFeatures& close);
std::string text(const TriangleIntersection& intersection);

// The first place where the lists are not the same, bit for bit.
std::optional<Wrong> require(const std::string& question, const std::vector<CloseFeatures>& expected,
                             const std::vector<CloseFeatures>& got);
std::optional<Wrong> require(const std::string& question, const std::vector<TriangleIntersection>& expected,
                             const std::vector<TriangleIntersection>& got);

}  // namespace ecods::judge
