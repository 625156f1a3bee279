#include "report/place_names.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>

namespace ecods::bench {

namespace {

// In pixels, at a font of 13: of the letters of DejaVu Sans, of the unit of gnuplot's offsets across and up, of a mark,
// and of axes and titles around the plot.
constexpr double letter_width = 7.3, line_height = 14, unit_across = 9.2, unit_up = 19.6, mark_radius = 7,
                 margin_across = 115, margin_up = 120;

constexpr std::array places = {NamePlace{1.2, 0, "left"},
                               NamePlace{-1.2, 0, "right"},
                               NamePlace{0, 0.9},
                               NamePlace{0, -0.9},
                               NamePlace{0.8, 0.8, "left"},
                               NamePlace{0.8, -0.8, "left"},
                               NamePlace{-0.8, 0.8, "right"},
                               NamePlace{-0.8, -0.8, "right"},
                               NamePlace{0, 1.7},
                               NamePlace{0, -1.7},
                               NamePlace{0, 2.5},
                               NamePlace{0, -2.5}};

struct Box {
    double left, right, bottom, top;

    bool overlaps(const Box& other) const {
        return left < other.right && other.left < right && bottom < other.top && other.bottom < top;
    }
};

// From 0 to 1 along an axis.
double fraction(const Axis& axis, double value) {
    if (!axis.is_logarithmic) return (value - axis.low) / (axis.high - axis.low);
    return std::log(value / axis.low) / std::log(axis.high / axis.low);
}

Box box_of(double x, double y, const NamePlace& place, std::size_t letter_count) {
    const double width = letter_width * static_cast<double>(letter_count);
    const std::string_view alignment = place.alignment;
    const double left = x + unit_across * place.across -
                        (alignment == "left"    ? 0
                         : alignment == "right" ? width
                                                : width / 2);
    const double middle = y + unit_up * place.up;
    return {left, left + width, middle - line_height / 2, middle + line_height / 2};
}

}  // namespace

std::vector<NamePlace> place_names(const Panel& panel, double width, double height) {
    width -= margin_across;
    height -= margin_up;
    struct Mark {
        double x, y;
    };
    std::vector<std::optional<Mark>> marks;
    std::vector<Box> taken;
    for (const Curve& curve : panel.curves) {
        marks.emplace_back();
        if (curve.points.empty()) continue;
        const ChartPoint& point = curve.points.front();
        const Mark at{width * fraction(panel.x, point.x), height * fraction(panel.y, point.y)};
        taken.push_back({at.x - mark_radius, at.x + mark_radius, at.y - mark_radius, at.y + mark_radius});
        marks.back() = at;
    }
    const Box inside{0, width, 0, height};
    std::vector<NamePlace> names;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        names.push_back({0, 0.9});
        if (!marks[i]) continue;
        const auto box = [&](const NamePlace& place) {
            return box_of(marks[i]->x, marks[i]->y, place, panel.curves[i].name.size());
        };
        const auto is_free = [&](const NamePlace& place) {
            const Box at = box(place);
            return at.left >= inside.left && at.right <= inside.right && at.bottom >= inside.bottom &&
                   at.top <= inside.top &&
                   std::ranges::none_of(taken, [&](const Box& other) { return at.overlaps(other); });
        };
        if (const auto* const free = std::ranges::find_if(places, is_free); free != places.end()) names.back() = *free;
        taken.push_back(box(names.back()));
    }
    return names;
}

}  // namespace ecods::bench
