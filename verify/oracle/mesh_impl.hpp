// What an OracleMesh keeps.
#pragma once

#include <memory>
#include <vector>

#include "oracle/oracle.hpp"
#include "oracle/simplex.hpp"

namespace ecods::oracle {

struct OracleMesh::Impl {
    std::shared_ptr<const Mesh> mesh;
    Pose pose;
    std::vector<IntervalKernel::Point_3> intervals;  // around the exact posed vertices
    Aabb outer_box;

    Simplex simplex(std::size_t triangle) const;    // needs a FloatEnvironment
    Aabb triangle_box(std::size_t triangle) const;  // contains the exact triangle
};

}  // namespace ecods::oracle
