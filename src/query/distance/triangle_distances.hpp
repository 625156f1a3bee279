// Two posed meshes, ready for questions about the distances of pairs of their triangles.
#pragma once

#include <cstdint>

#include "ecods/distance.hpp"
#include "exact/point/frame.hpp"

namespace ecods {

// Contains a distance.
struct DistanceInterval {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();
};

class TriangleDistances {
  public:
    // Cost: constant. Everything that the arguments refer to must outlive the questions.
    void bind(const exact::BodyRef& a, const exact::BodyRef& b);

    // Contains the distance of triangle `i` of the first mesh and `j` of the second, by doubles with proven bounds. `lower`
    // is 0 where it is not proven to be more.
    DistanceInterval enclose(std::uint32_t i, std::uint32_t j);

    // The distance, rounded once; 0 exactly if the triangles share a point.
    double distance(std::uint32_t i, std::uint32_t j);

    // The sign of the real distance of a pair of triangles less the double d >= 0.
    int compare(std::uint32_t i, std::uint32_t j, double d);

    // The sign of the real distance of the first pair of triangles less that of the second.
    int compare(const TrianglePair& first, const TrianglePair& second);

    // The closest points of a pair of triangles, by the rule of ClosestPoints.
    ClosestPoints closest(std::uint32_t i, std::uint32_t j);
};

}  // namespace ecods
