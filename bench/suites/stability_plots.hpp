// Pictures for the page on numerical stability: charts and maps of signs, drawn by gnuplot.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/page.hpp"

namespace ecods::bench {

// Percent of wrong answers of each engine, one curve each.
struct WrongCurves {
    std::string x_label;
    bool x_is_logarithmic = false;
    std::vector<double> x;
    std::vector<std::vector<double>> percent;  // [engine][x]
};

// Panels side by side with one key. Curves differ in marks and dashes, not in colour alone.
Picture plot_wrong_curves(std::span<const WrongCurves> panels, std::span<const std::string> engines,
                          const std::filesystem::path& folder, const std::string& name, const std::string& caption);

// Bars in groups, one group for each label; percent[engine][group].
Picture plot_wrong_bars(std::span<const std::string> groups, std::span<const std::string> engines,
                        std::span<const std::vector<double>> percent, const std::filesystem::path& folder,
                        const std::string& name, const std::string& caption);

// A square grid of signs, -1, 0 or 1; rows from the bottom.
struct SignMap {
    std::string title;
    std::size_t size = 0;
    std::vector<int> signs;
};

// Beside each other, in three grey levels: negative dark, zero white, positive grey.
Picture plot_sign_maps(std::span<const SignMap> maps, const std::filesystem::path& folder, const std::string& name,
                       const std::string& caption);

}  // namespace ecods::bench
