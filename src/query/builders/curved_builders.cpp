// Builds polytopes around curved bodies. A polytope of vertices on the unit circle or sphere is scaled until it
// contains the circle or sphere; its vertices are multiplied by the radii and rounded; and exact signs decide whether
// the hull of these points contains the body. If the hull does not contain the body, because coordinates were rounded
// inwards, the scale grows.
#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "base/make_error.hpp"
#include "ecods/builders.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/long_vector.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/find_invalid.hpp"
#include "query/builders/check_sizes.hpp"
#include "query/builders/curved_body.hpp"
#include "query/builders/fixed_point.hpp"
#include "query/builders/unit_circle.hpp"
#include "query/builders/unit_sphere.hpp"

namespace ecods {
namespace {

using namespace builders;
using exact::Int128;
using exact::Integer;
using exact::LongVector;

// Returns radius * scale * x, rounded once to nearest; `scale` and `x` are in fixed point. Throws InvalidArgument,
// which names `part`, if the product overflows.
double scaled(const std::string& part, double radius, Int128 scale, std::int64_t x) {
    const exact::Dyadic r = exact::decode(radius);
    const Int128 product = r.m * multiply_fixed(scale, x);
    const double result = exact::round_integer(exact::widened(product), r.e - fixed_bits);
    if (!is_finite(result)) throw size_too_large(part, radius);
    return result;
}

// Returns the least number of binary digits that doubles have at a radius of the body: 53, or fewer if a radius is
// subnormal.
int digit_count(const CurvedPart& part) noexcept {
    int count = exact::mantissa_bits;
    for (const double radius : part.radii) {
        const exact::Dyadic r = exact::decode(radius);
        if (r.m != 0) count = std::min(count, r.e + exact::bit_width(exact::Uint128{exact::magnitude(r.m)}) + 1074);
    }
    return count;
}

// Returns the first polytope that contains the body, for growing scales. points_at(scale) must return its vertices. At
// the first scale, the unit polytope must contain the unit circle or sphere, except for a few units.
//
// Some scale suffices. Rounding moves a coordinate by at most half of a unit in the last place, and so by at most half
// of the radius. So relative to the radii, the hull's extent along any axis is less than that of the unit polytope by
// at most sqrt(3) / 2. The last scale is 5 times the first one.
// Claim: verify/proofs/outer_polytopes.md
template <class PointsAt>
Circumscribed grow(Int128 scale, const CurvedBody& body, const PointsAt& points_at) {
    const int digits = digit_count(body.back());
    for (int step = 0; step <= digits + 3; ++step) {
        const Int128 growth = step == 0 ? 0 : scale >> digits << (step - 1);
        const std::vector<Vec3> points = points_at(scale + growth);
        const std::shared_ptr<const Mesh> hull = convex_hull(points);
        if (contains(*hull, body)) return {std::make_shared<const ConvexSolid>(hull), deviation(*hull, body)};
    }
    ECODS_ASSERT(false);
    return {};
}

// Builds the hull of a polygon around the disc in the plane z = -height / 2, and of the top at z = height / 2: a point
// on the axis for a cone, otherwise the same polygon.
Circumscribed around_disc(double radius, double height, std::uint32_t sides, bool is_cone) {
    require_size("radius", radius);
    const double half = require_half("height", height);
    require_count("sides", sides, 3, max_sides);
    const CurvedPart disc{{radius, radius, 0}, -half}, apex{{0, 0, 0}, half}, other{{radius, radius, 0}, half};
    // The sides of a polygon with vertices on the circle are at a distance of cos(pi / sides) from the center. The
    // quotient of 2^120 is the inverse in fixed point.
    const std::int64_t inner = on_circle(1, 2 * sides)[0];
    const Int128 scale = (Int128{1} << 2 * fixed_bits) / inner + 1;
    return grow(scale, {is_cone ? apex : other, disc}, [&](Int128 at) {
        std::vector<Vec3> points;
        for (std::uint32_t k = 0; k < sides; ++k) {
            const auto [c, s] = on_circle(k, sides);
            const double x = scaled("radius", radius, at, c), y = scaled("radius", radius, at, s);
            points.emplace_back(x, y, -half);
            if (!is_cone) points.emplace_back(x, y, half);
        }
        if (is_cone) points.emplace_back(0, 0, half);
        return points;
    });
}

// Returns the least scale, in fixed point, at which the faces of the sphere's mesh are at least 1 from the center. A
// face with normal n, at a height of d = n . p along it, is at a distance of d / |n|. So the scale s suffices if s^2
// d^2 >= n . n; both sides are scaled by 2^480.
Int128 scale_of(const UnitSphere& sphere) {
    Int128 scale = fixed_one;
    for (const auto& [a, b, c] : sphere.triangles) {
        const auto vector = [&](std::uint32_t i) {
            return LongVector{sphere.points[i][0], sphere.points[i][1], sphere.points[i][2]};
        };
        const LongVector p = vector(a), n = cross(minus(vector(b), p), minus(vector(c), p));
        const Integer d = dot(n, p), limit = dot(n, n) << 4 * fixed_bits;
        const auto is_enough = [&](Int128 s) { return compare(exact::square(Integer(s) * d), limit) >= 0; };
        if (is_enough(scale)) continue;
        Int128 high = 2 * Int128{fixed_one};  // an icosahedron needs 1.26
        while (scale < high) {
            const Int128 middle = (scale + high) / 2;
            if (is_enough(middle)) {
                high = middle;
            } else {
                scale = middle + 1;
            }
        }
    }
    return scale;
}

}  // namespace

Circumscribed cylinder(double radius, double height, std::uint32_t sides) {
    return around_disc(radius, height, sides, false);
}

Circumscribed cone(double radius, double height, std::uint32_t sides) {
    return around_disc(radius, height, sides, true);
}

Circumscribed ellipsoid(const Vec3& radii, std::uint32_t subdivisions) {
    const std::array<std::string, 3> names{"radii(0)", "radii(1)", "radii(2)"};
    for (int axis = 0; axis < 3; ++axis) require_size(names[static_cast<std::size_t>(axis)], radii[axis]);
    require_count("subdivisions", subdivisions, 0, max_subdivisions);
    const UnitSphere sphere = subdivide_icosahedron(subdivisions);
    return grow(scale_of(sphere), {{{radii[0], radii[1], radii[2]}, 0}}, [&](Int128 at) {
        std::vector<Vec3> points;
        for (const auto& p : sphere.points) {
            Vec3& v = points.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                const auto axis = static_cast<Eigen::Index>(k);
                v[axis] = scaled(names[k], radii[axis], at, p[k]);
            }
        }
        return points;
    });
}

}  // namespace ecods
