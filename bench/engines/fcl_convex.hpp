// A convex mesh as FCL has it.
#pragma once

#include <fcl/geometry/shape/convex.h>

#include <memory>
#include <vector>

#include "ecods/mesh.hpp"

namespace ecods::bench {

inline std::shared_ptr<fcl::Convexd> to_fcl_convex(const Mesh& mesh) {
    const auto vertices =
        std::make_shared<const std::vector<fcl::Vector3d>>(mesh.vertices().begin(), mesh.vertices().end());
    const auto faces = std::make_shared<std::vector<int>>();
    for (const Triangle& t : mesh.triangles()) {
        faces->push_back(3);
        for (const std::uint32_t index : t) faces->push_back(static_cast<int>(index));
    }
    auto convex = std::make_shared<fcl::Convexd>(vertices, static_cast<int>(mesh.triangles().size()), faces);
    convex->computeLocalAABB();
    return convex;
}

}  // namespace ecods::bench
