// TriangleHits finds the points that a line shares with single triangles of a posed mesh.
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

// A HitEnclosure holds what doubles prove about the points that a line shares with a triangle.
struct HitEnclosure {
    enum class Verdict : std::uint8_t {
        none,  // they share no point
        face,  // they share exactly one point, inside the face
        open,  // nothing is proven
    };
    Verdict verdict = Verdict::open;
    bool is_crossing = false;     // true if the line certainly crosses the triangle's plane, at one point
    bool has_area = false;        // true if the triangle's corners are certainly not on one line
    double lower = 0, upper = 0;  // bounds of the scaled parameter of the first shared point, if there is one
};

// TriangleHits takes triangles by their vertices, in the order of Mesh::triangles().
class TriangleHits {
  public:
    // Computes the numbers that depend on the body alone. Cost: constant.
    void prepare(const exact::BodyRef& body) noexcept;

    // Sets the line and the body; prepare() must have been called for this body. Everything that the arguments refer to
    // must outlive their use.
    void bind(const Line& line, const ScaledLine& scaled, const exact::BodyRef& body) noexcept;

    HitEnclosure enclose(const Triangle& triangle) const noexcept;

    // Returns true if the line shares a point with the triangle, and then sets `hit`.
    bool find(const Triangle& triangle, exact::LineHit& hit);

    // Sets `hit` to the only point that the line and the triangle share. Call this function only if enclose() has
    // proven that the line crosses the triangle inside its face.
    void find_crossing(const Triangle& triangle, exact::LineHit& hit);
    // Sets `crossing` to the only point that the line and the triangle share, in rounded numbers, and returns true.
    // Returns false if fixed precision does not decide the roundings. Call this function only if enclose() has proven
    // that the line crosses the triangle inside its face.
    bool round_crossing(const Triangle& triangle, exact::RoundedCrossing& crossing);

  private:
    bool has_short_points();
    std::array<exact::LinePoints::Point, 3> short_points(const Triangle& triangle) const;
    template <class Use>
    auto with_limbs(const Triangle& triangle, Use&& use);

    // InDoubles holds the arguments of enclose_in(): vectors of three coordinates, padded by a zero.
    struct alignas(32) InDoubles {
        std::array<std::array<double, 4>, 3> R;  // by columns
        std::array<double, 4> offset;            // fl(t - a)
        std::array<double, 4> d, d_error;        // direction of the scaled line
        double delta;                            // error bound of each coordinate of a posed point
        double end_low, end_high;
        bool is_known;
    };
    static void enclose_in(const InDoubles& s, const std::array<const Vec3*, 3>& corners,
                           HitEnclosure& result) noexcept;

    const Line* line_ = nullptr;
    exact::BodyRef body_{};
    Pose line_pose_;           // translates to the origin of a ray; identity for a segment
    Vec3 sum_ = Vec3::Zero();  // |R| times the largest coordinates
    double factor_ = 0;        // the largest of the coordinates and the entries of |R|
    InDoubles in_doubles_{};
    exact::LinePoints points_;
    enum class Points : std::uint8_t { unknown, short_ones, long_ones };
    Points kind_ = Points::unknown;
};

}  // namespace ecods
