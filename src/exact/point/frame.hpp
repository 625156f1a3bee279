// A Frame computes the points of any number of posed meshes in one common coordinate system.
//
// All points are relative to the translation t0 of the first body: a point is R v + (t - t0). So error bounds grow with
// the distance of the bodies from each other, not from the origin.
//
// Vertices are posed on demand, rounded or as integers (IntegerFrame), and cached in small caches of fixed size. So a
// query costs nothing for vertices that the query does not read. The width of the exact coordinates is measured once
// for all bodies, when a query first needs exact signs. The width determines which arithmetic is exact.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "ecods/pose.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/integer_frame.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/point.hpp"
#include "exact/point/posed_points.hpp"
#include "exact/point/vertex_cache.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

// Arithmetic lists the kinds of arithmetic that compute exact signs for all points of a frame, from the most to the
// least expensive.
enum class Arithmetic : std::uint8_t {
    unknown,      // not measured yet
    many_limbs,   // integers of more than two limbs
    two_limbs,    // integers of two limbs
    one_limb,     // integers of one limb
    differences,  // points and their differences are exact in doubles
    plain,        // every determinant is exact in doubles
};

class Frame {
  public:
    // Replaces all bodies of the frame by `bodies`, of which there must be at least one. The frame refers to the
    // bodies, so they must outlive all later calls. Cost: constant for each body. Memory: 96 KiB for each body, kept
    // for the bodies of later calls.
    void bind(std::span<const BodyRef> bodies);

    const BodyRef& body(std::size_t i) const noexcept { return integers_.body(i); }

    // delta() and extent() are bounds for rounded points, and hold until find_arithmetic() is called. delta() is an
    // upper bound of the error of any coordinate, of all bodies or of one body. extent() is an upper bound of the
    // difference of two points, by axis.
    double delta() const noexcept { return delta_; }
    double delta(std::size_t body) const noexcept { return bodies_[body].delta; }
    const Vec3& extent() const noexcept { return extent_; }

    // Chooses the arithmetic, if it has not been chosen yet. Afterwards rounded points may be in other units, so points
    // from before and after the call must not be mixed. Cost: constant for each body.
    void find_arithmetic() noexcept {
        if (arithmetic_ == Arithmetic::unknown) [[unlikely]]
            measure_digits();
    }
    Arithmetic arithmetic() const noexcept { return arithmetic_; }

    // Returns the rounded point of a vertex. The reference is valid until the next call for the same body.
    const Point& rounded(std::size_t body, std::uint32_t vertex);
    template <std::size_t N>
    Points<N> rounded(const std::array<VertexRef, N>& vertices) {
        Points<N> points;
        for (std::size_t i = 0; i < N; ++i) points[i] = rounded(vertices[i].body, vertices[i].vertex);
        return points;
    }

    // Returns references to the exact points of the vertices. Any arithmetic may be in use.
    template <std::size_t N>
    PosedPoints<N> posed(const std::array<VertexRef, N>& vertices) const noexcept {
        return integers_.posed(vertices);
    }

    // Returns a power of two such that rounded points times this power are integers below 2^52. Call this function only
    // if arithmetic() is differences.
    double to_integers() const noexcept {
        ECODS_ASSERT(arithmetic_ == Arithmetic::differences);
        return to_integers_;
    }

    // Calls use(points) and returns the result of use(); `points` has the exact points of the vertices as
    // IntegerPoints<Kernel, N>, for a kernel that is wide enough. Call this function only if arithmetic() is one_limb,
    // two_limbs or many_limbs.
    template <std::size_t N, class Use>
    auto with_integers(const std::array<VertexRef, N>& vertices, Use&& use);

  private:
    struct Body {
        Vec3 offset = Vec3::Zero();  // fl(t - t0)
        double delta = 0;
        VertexCache<Point> rounded;
    };

    std::size_t body_count() const noexcept { return integers_.body_count(); }
    void forget_points() noexcept;
    // Poses a vertex that is not in the cache. It is not inlined: otherwise every query would contain this code, which
    // hardly ever runs, once for each of its points. The call is cheap, since the arguments are in registers already.
    void pose(std::size_t body, std::uint32_t vertex, Point& p) const noexcept;
    void find_bounds() noexcept;
    void measure_digits() noexcept;
    bool points_are_doubles(const BitRange& digits) const noexcept;
    bool are_short(const Vec3& unit) const noexcept;
    Vec3 common_unit() const noexcept;
    void count_in(const Vec3& unit) noexcept;

    IntegerFrame integers_;     // measured if arithmetic_ is known
    std::vector<Body> bodies_;  // may have more than body_count() entries, to keep their memory
    Vec3 extent_ = Vec3::Zero();
    double delta_ = 0;
    Arithmetic arithmetic_ = Arithmetic::unknown;
    bool is_counted_ = false;  // true if rounded points are divided by unit_
    Vec3 unit_ = Vec3::Ones();
    double to_integers_ = 1;
};

ECODS_ALWAYS_INLINE const Point& Frame::rounded(std::size_t body, std::uint32_t vertex) {
    ECODS_ASSERT(body < body_count());
    return bodies_[body].rounded.get(vertex, [&](Point& p) { pose(body, vertex, p); });
}

template <std::size_t N, class Use>
auto Frame::with_integers(const std::array<VertexRef, N>& vertices, Use&& use) {
    ECODS_ASSERT(arithmetic_ == Arithmetic::one_limb || arithmetic_ == Arithmetic::two_limbs ||
                 arithmetic_ == Arithmetic::many_limbs);
    if (arithmetic_ != Arithmetic::one_limb) return integers_.with_integers(vertices, use);
    IntegerPoints<OneLimbKernel, N> points;
    points.unit = integers_.unit();
    for (std::size_t i = 0; i < N; ++i) {
        const IntegerFrame::Point& p = integers_.at(vertices[i].body, vertices[i].vertex);
        for (std::size_t k = 0; k < 3; ++k) points.at[i][k] = static_cast<std::int64_t>(p[k]);
    }
    return use(points);
}

}  // namespace ecods::exact
