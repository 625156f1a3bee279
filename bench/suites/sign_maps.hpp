// Maps of signs: which side of a line, or of a plane, are points beside it that differ by units in the last place?
// Plain double beside ECoDS.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "report/page.hpp"

namespace ecods::bench {

// A square grid of signs, -1, 0 or 1; rows from the bottom.
struct SignMap {
    std::string title;
    std::size_t size = 0;
    std::vector<int> signs;
};

struct SignMaps {
    SignMap plain, exact;
    std::size_t plain_wrong = 0, exact_wrong = 0;
};

constexpr std::size_t sign_map_size = 256;  // points along a side

// Kettner, Mehlhorn, Pion, Schirra, Yap, Classroom Examples of Robustness Problems in Geometric Computations, 2008: the
// side of the line through (12, 12) and (24, 24) on which points near (0.5, 0.5) are.
SignMaps map_orient2d();

// The same under a pose: the side of the plane x = y, rotated and moved, on which the posed points are.
SignMaps map_posed_orient3d();

// NAME.png in the folder, and what it is made from: both beside each other, negative blue, zero white, positive amber.
Picture draw_orient2d(const SignMaps& maps, const std::filesystem::path& folder, const std::string& name);
Picture draw_posed_orient3d(const SignMaps& maps, const std::filesystem::path& folder, const std::string& name);

}  // namespace ecods::bench
