// An IntegerFrame counts the points of any number of posed meshes in units of one power of two.
//
// Integers of 128 bits are the points R v + t - t0 themselves if the digits of all bodies fit, as they usually do; t0
// is the first body's translation. Otherwise points are rounded down to 120 digits, and with_integers makes exact ones
// of a few vertices, in as many limbs as they need. Neither a rounding mode nor flush-to-zero changes a point, and no
// number is near enough to zero or infinity to underflow or overflow.
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

    // Replaces all bodies. There must be at least one, and everything that they refer to must outlive the questions.
    // Cost: some instructions a body. Memory: 64 KiB a body, kept for the bodies of later calls.
    void bind(std::span<const BodyRef> bodies);
    // Finds the digits of all bodies and the unit; points may be taken only afterwards. `others` are the digits of
    // numbers that will be counted in the same unit, which divides them if they and the points fit. Cost: constant for
    // each body.
    void measure(const BitRange& others = {}) noexcept;

    void bind_pair(const BodyRef& a, const BodyRef& b, const BitRange& others = {}) {
        bind(std::array{a, b});
        measure(others);
    }

    std::size_t body_count() const noexcept { return body_count_; }
    const BodyRef& body(std::size_t i) const noexcept { return bodies_[i].ref; }
    const PoseTerms& terms(std::size_t i) const noexcept { return bodies_[i].terms; }

    // digits() holds the digits of all terms of coordinates: products R_ij v_j, and differences of translations.
    const BitRange& digits() const noexcept { return digits_; }
    int unit() const noexcept { return unit_; }
    bool is_exact() const noexcept { return is_exact_; }

    // Returns the point of a vertex in units of 2^unit(), valid until the next call for the same body. The difference
    // of any two coordinates is below 2^difference_bits.
    ECODS_ALWAYS_INLINE const Point& at(std::size_t body, std::uint32_t vertex) noexcept {
        Body& of = bodies_[body];
        return of.points.get(vertex, [&](Point& p) { pose(of, vertex, p); });
    }
    static constexpr int difference_bits = TwoLimbKernel::coordinate_bits;

    // Bounds the error of points that are not exact. A coordinate is a sum of three products and a difference of
    // translations, which may be two terms, each rounded down by less than one unit: it is less than 5 units too low.
    // The difference of two coordinates is off by less than 5 units.
    static constexpr int error_units = 5;
    int error() const noexcept { return is_exact_ ? 0 : error_units; }

    // Returns references to the exact points of some vertices.
    template <std::size_t N>
    PosedPoints<N> posed(const std::array<VertexRef, N>& vertices) const noexcept {
        PosedPoints<N> points;
        for (std::size_t i = 0; i < N; ++i) {
            const BodyRef& of = body(vertices[i].body);
            points[i] = {of.pose, &of.mesh->vertices()[vertices[i].vertex]};
        }
        return points;
    }

    // Calls `use` with the exact points of some vertices as IntegerPoints<Kernel, N> of the narrowest kernel that holds
    // them, relative to the first of them, and returns its result. `use` must take every kernel.
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
        ShortProducts products;  // bound at the first exact point
        Point offset{};          // t - t0
        VertexCache<Point> points;
    };

    std::span<Body> bodies() noexcept { return {bodies_.data(), body_count_}; }
    // Not inline: a question has such a call for each of its points, and hardly ever takes it.
    void pose(Body& of, std::uint32_t vertex, Point& p) const noexcept;

    std::vector<Body> bodies_;  // the first body_count_ are bound; the others keep their memory
    std::size_t body_count_ = 0;
    BitRange digits_;
    int unit_ = 0;
    bool is_exact_ = false;
};

}  // namespace ecods::exact
