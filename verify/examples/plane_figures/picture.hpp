// A picture of plane figures, as SVG.
#pragma once

#include <iosfwd>
#include <span>
#include <string>
#include <vector>

#include "examples/plane_figures/placed_figure.hpp"

namespace ecods::examples {

// Fields beside each other, two in a row. y goes up, one unit is as long everywhere.
class Picture {
  public:
    // The middle of the field, in the plane, and words above and below it.
    void begin_field(const std::string& title, const Vec2& middle);
    void add_line(const std::string& text);

    void add_figure(const PlacedFigure& figure, const char* color);
    void add_ghost(const PlacedFigure& figure, const Vec2& moved_by, const char* color);  // its border alone
    void add_region(std::span<const Vec2> corners);
    void add_arrow(const Vec2& from, const Vec2& to);
    void add_segment(const Vec2& from, const Vec2& to);
    void add_point(const Vec2& at);

    void write(std::ostream& out) const;

  private:
    struct Field {
        std::string title;
        Vec2 middle;
        std::string shapes;
        std::vector<std::string> lines;
    };
    std::string to_text(const Vec2& point) const;
    std::string path_of(const PlacedFigure& figure, const Vec2& moved_by) const;
    void add(const std::string& shape) { fields_.back().shapes += shape + "\n"; }

    std::vector<Field> fields_;
};

}  // namespace ecods::examples
