#include "report/engine_style.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <map>

namespace ecods::bench {

namespace {

// The colour-blind can distinguish them, and each has a contrast of at least 3 to its paper.
constexpr std::array palette = {Colour{"ecods", "#0b62b8", "#5eb0ff"},  Colour{"fcl", "#c1272d", "#ff7b72"},
                                Colour{"bullet", "#b85f00", "#f0a83c"}, Colour{"ode", "#2a8a4a", "#5fd08a"},
                                Colour{"cgal", "#8a3fb0", "#d29bf0"},   Colour{"embree", "#00838f", "#4fd0dd"},
                                Colour{"ccd", "#8d5a2b", "#d8a878"},    Colour{"float", "#87870f", "#d6d65c"},
                                Colour{"plain", "#6f6f6f", "#b0b0b0"},  Colour{"ink", "#1b1b1b", "#e4e4e4"},
                                Colour{"grid", "#dcdcdc", "#3a3d42"},   Colour{"paper", "#ffffff", "#17191c"}};
constexpr std::size_t plain = 8;

struct Library {
    const char* prefix;  // of the names of its engines
    std::size_t colour;
    int mark;  // filled; the one before is the same open
};
constexpr std::array libraries = {Library{"ECoDS", 0, 7},      Library{"calls: ECoDS", 0, 7}, Library{"FCL", 1, 5},
                                  Library{"calls: FCL", 1, 5}, Library{"Bullet", 2, 9},       Library{"ODE", 3, 11},
                                  Library{"CGAL", 4, 13},      Library{"Epick", 4, 13},       Library{"Epeck", 4, 13},
                                  Library{"Embree", 5, 15},    Library{"libccd", 6, 3},       Library{"float", 7, 9},
                                  Library{"double", 8, 11},    Library{"plain double", 8, 11}};

}  // namespace

std::span<const Colour> colours() {
    return palette;
}

std::string colour_variables(bool is_dark) {
    std::string text;
    for (const Colour& colour : palette)
        text += std::string("--") + colour.name + ":" + (is_dark ? colour.dark : colour.light) + ";";
    return text;
}

std::vector<EngineStyle> engine_styles(std::span<const std::string> names) {
    std::map<const Colour*, int> seen;
    std::vector<EngineStyle> styles;
    for (const std::string& name : names) {
        const auto* const library = std::ranges::find_if(
            libraries, [&](const Library& candidate) { return name.starts_with(candidate.prefix); });
        EngineStyle& style = styles.emplace_back();
        style.colour = &palette[library == libraries.end() ? plain : library->colour];
        style.variant = seen[style.colour]++;
        const int mark = library == libraries.end() ? 3 : library->mark;
        // Filled, open, then crosses, which lie on both.
        constexpr std::array<int, 3> crosses = {2, 1, 3};
        style.mark =
            style.variant < 2 ? mark - style.variant : crosses[static_cast<std::size_t>(style.variant - 2) % 3];
        style.dash = style.variant % 5 + 1;
    }
    return styles;
}

}  // namespace ecods::bench
