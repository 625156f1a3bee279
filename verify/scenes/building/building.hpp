// A building of which every relation is known from how it was made: walls with doors and windows, slabs, columns, pipes
// through, in and beside walls, duplicates, flush overlaps of 50 mm, gaps of 0.1 mm, and parts that bound no solid.
//
// It is made in whole tenths of a millimeter. A coordinate k becomes the double nearest to k / 10000 meters, so equal
// numbers stay equal, and the order of numbers stays what it is: what holds for the integers holds for the doubles.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <memory>
#include <string>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::scenes {

// Tenths of a millimeter.
using Length = std::int64_t;

// In meters: rounded once.
inline double meters(Length length) noexcept {
    return static_cast<double>(length) / 10000.0;
}

// A closed box; flat where min is max.
struct Block {
    std::array<Length, 3> min{};
    std::array<Length, 3> max{};
};

// What keeps an element from being a solid.
enum class Defect : std::uint8_t {
    none,
    open,     // the end at `hi` is left out
    doubled,  // each triangle is there twice
};

// A figure of the plane of the axes (axis + 1) mod 3 and (axis + 2) mod 3, drawn out along the axis from lo to hi.
struct Element {
    std::string name;
    int axis = 2;
    Length lo = 0;
    Length hi = 0;

    // The figure of a grid: the cells between us[i], us[i + 1] and vs[j], vs[j + 1] for which filled[j * (us.size() -
    // 1) + i] is not 0. Filled cells that meet in a corner have a filled neighbor in common. Empty of a pipe.
    std::vector<Length> us, vs;
    std::vector<char> filled;

    // The figure of a pipe: a convex 24-gon around (u, v), as wide as its radius along both axes.
    Length u = 0, v = 0, radius = 0;

    Defect defect = Defect::none;
    bool is_cut_otherwise = false;  // faces of a grid are cut along their other diagonals

    bool is_pipe() const noexcept { return us.empty(); }
};

// 25 elements a bay and storey. Bays are 6 m by 5 m, storeys 3 m high.
std::vector<Element> make_building(int bays_x, int bays_y, int storeys);

// The building of 10,000 elements.
inline std::vector<Element> make_large_building() {
    return make_building(10, 8, 5);
}

std::shared_ptr<const Mesh> mesh_of(const Element& element);

// An object for each element, named after it.
void write_obj(std::ostream& out, const std::vector<Element>& elements);

// The corners of a pipe's figure, counterclockwise.
std::array<std::array<Length, 2>, 24> pipe_corners(const Element& pipe);

}  // namespace ecods::scenes
