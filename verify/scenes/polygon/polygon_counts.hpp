// How the polygons of a file were cut.
#pragma once

#include <cstddef>
#include <string>

namespace ecods::scenes {

// Polygons have four corners and more. See cut_polygon.hpp.
struct PolygonCounts {
    std::size_t polygons = 0;
    std::size_t ears = 0;         // no fan around the first corner covers them: cut by ears
    std::size_t crossing = 0;     // nothing covers them: the outline crosses itself
    std::size_t in_no_plane = 0;  // corners in no plane, exactly: their surface depends on the cut
    std::string first_crossing;   // its place in the file
};

}  // namespace ecods::scenes
