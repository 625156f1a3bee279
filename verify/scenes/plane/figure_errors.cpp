#include <fmt/core.h>

#include <ostream>

#include "scenes/plane/plane_figure.hpp"

namespace ecods::scenes {

namespace {

std::string outline_text(std::size_t outline) {
    return outline == 0 ? "the outline" : fmt::format("hole {}", outline - 1);
}

std::string side_text(const FigurePlace& side) {
    return fmt::format("side {} of {}", side.index, outline_text(side.outline));
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const FigurePlace& place) {
    return out << side_text(place);
}

CornerNotFinite::CornerNotFinite(const FigurePlace& corner_, int axis_, double value_)
    : FigureError(fmt::format("corner {} of {}: {} is {}", corner_.index, outline_text(corner_.outline),
                              axis_ == 0 ? "x" : "y", value_)),
      corner(corner_),
      axis(axis_),
      value(value_) {}

TooFewCorners::TooFewCorners(std::size_t outline_, std::size_t corner_count_)
    : FigureError(fmt::format("{} has {} corners: a polygon has three or more", outline_text(outline_), corner_count_)),
      outline(outline_),
      corner_count(corner_count_) {}

SideWithoutLength::SideWithoutLength(const FigurePlace& side_)
    : FigureError(fmt::format("{} has no length: both of its ends are the same point", side_text(side_))),
      side(side_) {}

SidesMeet::SidesMeet(const FigurePlace& a_, const FigurePlace& b_)
    : FigureError(fmt::format("{} and {} share a point that is not merely the corner between them", side_text(a_),
                              side_text(b_))),
      a(a_),
      b(b_) {}

HoleMisplaced::HoleMisplaced(std::size_t hole_, std::optional<std::size_t> inside_)
    : FigureError(inside_ ? fmt::format("hole {} is inside hole {}", hole_, *inside_)
                          : fmt::format("hole {} is outside the outline", hole_)),
      hole(hole_),
      inside(inside_) {}

InvalidHeight::InvalidHeight(double value_)
    : FigureError(fmt::format("the height of a prism must be positive and finite, not {}", value_)), value(value_) {}

}  // namespace ecods::scenes
