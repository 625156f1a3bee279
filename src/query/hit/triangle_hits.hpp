// A line and a posed mesh, ready for questions about what the line shares with single triangles.
#pragma once

#include <array>
#include <cstdint>

#include "exact/measure/line/line_hit.hpp"
#include "exact/measure/line/round_crossing.hpp"
#include "exact/point/frame.hpp"
#include "exact/point/line_points.hpp"
#include "geometry/line.hpp"
#include "geometry/scaled_line.hpp"

namespace ecods {

// What doubles prove of a line and a triangle.
struct HitEnclosure {
    enum class Verdict : std::uint8_t {
        none,  // they share no point
        face,  // exactly one point, inside the face
        open,  // nothing is proven
    };
    Verdict verdict = Verdict::open;
    bool is_crossing = false;     // whether the line certainly crosses the triangle's plane, at one point
    bool has_area = false;        // whether the triangle's corners are certainly not on one line
    double lower = 0, upper = 0;  // contain the scaled parameter of that point, where there is one
};

// A triangle is what Mesh::triangles() has of it: its vertices.
class TriangleHits {
  public:
    // What depends on the body alone. Cost: constant.
    void prepare(const exact::BodyRef& body) noexcept;

    // Everything that the arguments refer to must outlive the questions. The body must have been prepared.
    void bind(const Line& line, const ScaledLine& scaled, const exact::BodyRef& body) noexcept;

    HitEnclosure enclose(const Triangle& triangle) const noexcept;

    // Whether the line shares a point with the triangle, and then what.
    bool find(const Triangle& triangle, exact::LineHit& hit);

    // Sets the one shared point of a triangle that the line is proven to cross inside the face.
    void find_crossing(const Triangle& triangle, exact::LineHit& hit);
    // Sets the same, rounded, and returns true; or returns false where that is not known so cheaply.
    bool round_crossing(const Triangle& triangle, exact::RoundedCrossing& crossing);

  private:
    bool has_short_points();
    std::array<exact::LinePoints::Point, 3> short_points(const Triangle& triangle) const;
    template <class Use>
    auto with_limbs(const Triangle& triangle, Use&& use);

    // What doubles are asked of: vectors of three, and a zero.
    struct alignas(32) InDoubles {
        std::array<std::array<double, 4>, 3> R;  // by columns
        std::array<double, 4> offset;            // fl(t - a)
        std::array<double, 4> d, d_error;        // of the scaled line
        double delta;                            // the error of a coordinate of a rounded point
        double end_low, end_high;
        bool is_known;
    };
    static void enclose_in(const InDoubles& s, const std::array<const Vec3*, 3>& corners,
                           HitEnclosure& result) noexcept;

    const Line* line_ = nullptr;
    exact::BodyRef body_{};
    Pose line_pose_;           // of which the line's beginning and end, or its direction, are points
    Vec3 sum_ = Vec3::Zero();  // |R| times the largest coordinates
    double factor_ = 0;        // the largest coordinate and entry of |R|
    InDoubles in_doubles_{};
    exact::LinePoints points_;
    enum class Points : std::uint8_t { unknown, short_ones, long_ones };
    Points kind_ = Points::unknown;
};

}  // namespace ecods
