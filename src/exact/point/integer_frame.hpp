// An IntegerFrame computes the points of any number of posed meshes as integers, in units of one power of two.
//
// A point is R v + t - t0, where t0 is the first body's translation. If the digits of all bodies fit into 128 bits, as
// they usually do, the integers are exact. Otherwise points are rounded down to 120 digits, and with_integers()
// computes exact points of a few vertices, in as many limbs as they need. Neither the rounding mode nor flush-to-zero
// changes a point, and no number is near enough to zero or infinity to underflow or overflow.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/pose_terms.hpp"
#include "exact/point/posed_points.hpp"
#include "exact/point/short_matrix.hpp"
#include "exact/point/vertex_cache.hpp"
#include "simd/inline.hpp"

namespace ecods::exact {

class IntegerFrame {
  public:
    using Point = TwoLimbKernel::Point;

    // Replaces all bodies of the frame by `bodies`, of which there must be at least one. The frame refers to the
    // bodies, so they must outlive all later calls. Cost: some instructions for each body. Memory: 64 KiB for each
    // body, kept for the bodies of later calls.
    void bind(std::span<const BodyRef> bodies);
    // Computes the digits of all bodies and the unit. Call this function before points are read. `others` are the
    // digits of numbers that the caller will convert to the same unit; the unit divides these numbers if they and the
    // points fit. Cost: constant for each body.
    void measure(const BitRange& others = {}) noexcept;

    void bind_pair(const BodyRef& a, const BodyRef& b, const BitRange& others = {}) {
        bind(std::array{a, b});
        measure(others);
    }

    std::size_t body_count() const noexcept { return body_count_; }
    const BodyRef& body(std::size_t i) const noexcept { return bodies_[i].ref; }
    const PoseTerms& terms(std::size_t i) const noexcept { return bodies_[i].terms; }

    // digits() returns the range of digits of all terms of coordinates: products R_ij v_j, and differences of
    // translations.
    const BitRange& digits() const noexcept { return digits_; }
    int unit() const noexcept { return unit_; }
    bool is_exact() const noexcept { return is_exact_; }

    // Returns the point of a vertex in units of 2^unit(). The reference is valid until the next call for the same body.
    // The difference of any two coordinates is below 2^difference_bits in magnitude.
    ECODS_ALWAYS_INLINE const Point& at(std::size_t body, std::uint32_t vertex) noexcept {
        Body& of = bodies_[body];
        return of.points.get(vertex, [&](Point& p) { pose(of, vertex, p); });
    }
    static constexpr int difference_bits = TwoLimbKernel::coordinate_bits;

    // error_units is the error bound, in units, of points that are not exact. A coordinate is a sum of three products
    // and a difference of translations, which may be two terms. Each term is rounded down by less than one unit, so a
    // coordinate is less than 5 units too low, and the difference of two coordinates is off by less than 5 units.
    static constexpr int error_units = 5;
    int error() const noexcept { return is_exact_ ? 0 : error_units; }

    // Returns references to the exact points of the vertices.
    template <std::size_t N>
    PosedPoints<N> posed(const std::array<VertexRef, N>& vertices) const noexcept {
        PosedPoints<N> points;
        for (std::size_t i = 0; i < N; ++i) {
            const BodyRef& of = body(vertices[i].body);
            points[i] = {of.pose, &of.mesh->vertices()[vertices[i].vertex]};
        }
        return points;
    }

    // Calls use(points) and returns its result; `points` has the exact points of the vertices, relative to the first
    // one, as IntegerPoints<Kernel, N>, for the narrowest kernel that is wide enough. `use` must accept every kernel.
    template <std::size_t N, class Use>
    auto with_integers(const std::array<VertexRef, N>& vertices, Use&& use) {
        if (!is_exact_) return exact::with_integers(posed(vertices), use);
        IntegerPoints<TwoLimbKernel, N> points;
        points.unit = unit_;
        for (std::size_t i = 0; i < N; ++i) points.at[i] = at(vertices[i].body, vertices[i].vertex);
        return use_narrowest(points, use);
    }

  private:
    struct Body {
        BodyRef ref{};
        PoseTerms terms;
        ShortProducts products;  // bound when the first exact point is computed
        Point offset{};          // t - t0
        VertexCache<Point> points;
    };

    std::span<Body> bodies() noexcept { return {bodies_.data(), body_count_}; }
    // Poses a vertex that is not in the cache. It is not inlined, because each question contains this call, which is
    // hardly ever made, once for each of its points.
    void pose(Body& of, std::uint32_t vertex, Point& p) const noexcept;

    std::vector<Body> bodies_;  // the first body_count_ are in use; the others keep their memory
    std::size_t body_count_ = 0;
    BitRange digits_;
    int unit_ = 0;
    bool is_exact_ = false;
};

}  // namespace ecods::exact
