// Bodies of the examples, and how their points are printed.
#pragma once

#include <fmt/core.h>
#include <ecods/ecods.hpp>

#include <memory>
#include <string>
#include <vector>

namespace how_do_i {

using namespace ecods;

inline std::string text(const Vec3& v) {
    return fmt::format("({}, {}, {})", v.x(), v.y(), v.z());
}

// Returns the cube from (0, 0, 0) to (1, 1, 1). A convex solid is a solid, and that is a mesh's shape.
inline std::shared_ptr<const ConvexSolid> unit_cube() {
    std::vector<Vec3> corners;
    for (int i = 0; i < 8; ++i) corners.emplace_back(i & 1, i >> 1 & 1, i >> 2 & 1);
    return std::make_shared<const ConvexSolid>(corners);
}

}  // namespace how_do_i
