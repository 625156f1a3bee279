// A line and a posed mesh, ready for questions about what the line shares with single triangles.
#pragma once

#include <cstdint>

#include "exact/measure/line_hit.hpp"
#include "exact/point/frame.hpp"
#include "geometry/line.hpp"

namespace ecods {

class TriangleHits {
  public:
    // Everything that the arguments refer to must outlive the questions.
    void bind(const Line& line, const exact::BodyRef& body) noexcept;

    // Whether the line shares a point with the triangle, and then what.
    bool find(std::uint32_t triangle, exact::LineHit& hit) const;

  private:
    const Line* line_ = nullptr;
    exact::BodyRef body_{};
    Pose line_pose_;  // of which the line's beginning and end, or its direction, are points
};

}  // namespace ecods
