// The points of two posed meshes as integers of 128 bits, all counted in one power of two.
//
// No floating-point instruction takes part, so neither a rounding mode nor flush-to-zero shows in a point. Where the
// digits of both bodies fit, which they do for most, the integers are the points R v + t - t0 themselves. Otherwise
// they are rounded down at the last of 120 digits: nothing is near enough to zero or infinity to underflow or overflow.
#pragma once

#include <array>
#include <cstdint>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/kernel.hpp"
#include "exact/point/frame.hpp"
#include "exact/point/vertex_cache.hpp"

namespace ecods::exact {

class FixedPoints {
  public:
    using Point = TwoLimbKernel::Point;

    // Cost: constant. Everything that the arguments refer to must outlive the questions. Memory: 128 KiB. `others` are
    // digits of numbers that will be counted in the same unit: it divides them if they and the points fit.
    void bind(const BodyRef& a, const BodyRef& b, const BitRange& others = {}) noexcept;

    const BodyRef& body(std::size_t i) const noexcept { return bodies_[i].ref; }

    // The point of a vertex of body 0 or 1, in units of 2^unit(). Valid until the next call for the same body.
    // The difference of any two is below 2^difference_bits.
    const Point& at(std::size_t body, std::uint32_t vertex) noexcept {
        Body& of = bodies_[body];
        return of.points.get(vertex, [&](Point& p) { pose(of, vertex, p); });
    }
    static constexpr int difference_bits = TwoLimbKernel::coordinate_bits;

    int unit() const noexcept { return unit_; }
    bool is_exact() const noexcept { return is_exact_; }

    // Where points are not exact: three products and a translation, each rounded down by less than one unit, less
    // another translation, leave a coordinate by less than 4 units too low or 1 too high. The difference of two
    // coordinates is off by less than 5 units.
    static constexpr int error_units = 5;

  private:
    // m 2^e, m of up to 53 bits.
    struct Factor {
        std::int64_t m;
        int e;
    };
    struct Body {
        BodyRef ref{};
        std::array<std::array<Factor, 3>, 3> columns{};  // of R
        Point offset{};                                  // t - t0
        VertexCache<Point> points;
    };

    static Factor factor(double x) noexcept;
    static Int128 shifted(Int128 m, int shift) noexcept;
    void find_unit(const BitRange& others) noexcept;
    void pose(const Body& of, std::uint32_t vertex, Point& p) const noexcept;

    std::array<Body, 2> bodies_;
    int unit_ = 0;
    bool is_exact_ = true;
};

}  // namespace ecods::exact
