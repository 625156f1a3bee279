// A chart as HTML: a key, the panels side by side as far as there is room, and those that are folded.
#pragma once

#include <filesystem>
#include <string>

#include "report/chart.hpp"

namespace ecods::bench {

// Draws into the folder. The page must contain `marks` once, before its first chart.
std::string to_html(const Chart& chart, const std::filesystem::path& folder, const std::string& origin,
                    std::string& marks);

}  // namespace ecods::bench
