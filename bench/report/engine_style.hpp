// How engines look: one colour a library, on every chart; several uses of one library differ in marks and dashes.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace ecods::bench {

struct Colour {
    const char* name;   // of the page's variable that holds it: --NAME
    const char* light;  // on white, #rrggbb
    const char* dark;   // on black
};

// The libraries' colours, then those of text ("ink"), grid lines ("grid") and paper ("paper").
std::span<const Colour> colours();

// The definitions of the variables, on white or on black: "--NAME:#rrggbb;" each.
std::string colour_variables(bool is_dark);

struct EngineStyle {
    const Colour* colour = nullptr;
    int mark = 0;     // gnuplot's point type
    int dash = 0;     // gnuplot's dash type
    int variant = 0;  // the how manieth use of its library among the names
};

// In the order of the names, which are those of one chart.
std::vector<EngineStyle> engine_styles(std::span<const std::string> names);

}  // namespace ecods::bench
