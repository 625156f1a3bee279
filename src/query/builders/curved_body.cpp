#include "query/builders/curved_body.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "base/double_key.hpp"
#include "base/outward.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/long_vector.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::builders {
namespace {

using exact::BitRange;
using exact::Dyadic;
using exact::Int128;
using exact::Integer;
using exact::LongVector;

// IntegerBody holds the vertices of a mesh and the radii of a body as integers. Each axis has a unit of its own:
// scaling an axis changes neither which points are inside, nor the factor by which a vertex is outside.
class IntegerBody {
  public:
    IntegerBody(const Mesh& mesh, const CurvedBody& body) {
        for (int axis = 0; axis < 3; ++axis) units_[static_cast<std::size_t>(axis)] = unit_of(mesh, body, axis);
        for (const Vec3& v : mesh.vertices()) vertices_.push_back(vector({v[0], v[1], v[2]}));
        for (const CurvedPart& part : body) parts_.push_back({vector(part.radii), vector({0, 0, part.z})[2]});
    }

    // Returns true if all parts are on the inner side of the triangle's plane.
    bool is_inside(const Triangle& triangle) const {
        const LongVector& a = vertices_[triangle[0]];
        const LongVector n = cross(minus(vertices_[triangle[1]], a), minus(vertices_[triangle[2]], a));
        const Integer d = dot(n, a);
        return std::ranges::all_of(parts_, [&](const Part& part) {
            const Integer height = d - n[2] * part.z;
            Integer extent;
            for (std::size_t k = 0; k < 3; ++k) extent = extent + square(part.radii[k] * n[k]);
            return height.sign() >= 0 && compare(square(height), extent) >= 0;
        });
    }

    // Factor holds num / den^2, the square of the largest factor by which a vertex is outside the last part.
    struct Factor {
        Integer num, den = Int128{1};
    };
    Factor largest_factor() const {
        const LongVector& radii = parts_.back().radii;
        Factor result;
        LongVector others{Integer(Int128{1}), Integer(Int128{1}), Integer(Int128{1})};  // products of the other radii
        for (std::size_t k = 0; k < 3; ++k) {
            if (radii[k].is_zero()) continue;
            result.den = result.den * radii[k];
            for (std::size_t i = 0; i < 3; ++i) {
                if (i != k) others[i] = others[i] * radii[k];
            }
        }
        for (const LongVector& p : vertices_) {
            Integer sum;
            for (std::size_t k = 0; k < 3; ++k) {
                if (!radii[k].is_zero()) sum = sum + square(p[k] * others[k]);
            }
            if (compare(sum, result.num) > 0) result.num = std::move(sum);
        }
        return result;
    }

  private:
    struct Part {
        LongVector radii;
        Integer z;
    };

    static int unit_of(const Mesh& mesh, const CurvedBody& body, int axis) {
        BitRange digits;
        for (const Vec3& v : mesh.vertices()) digits.include(exact::decode(v[axis]));
        for (const CurvedPart& part : body) {
            digits.include(exact::decode(part.radii[static_cast<std::size_t>(axis)]));
            if (axis == 2) digits.include(exact::decode(part.z));
        }
        return digits.low;
    }
    LongVector vector(const std::array<double, 3>& x) const {
        LongVector result;
        for (std::size_t k = 0; k < 3; ++k) result[k] = exact::in_units(exact::decode(x[k]), units_[k]);
        return result;
    }

    std::array<int, 3> units_;
    std::vector<LongVector> vertices_;
    std::vector<Part> parts_;
};

// Returns the least double >= 0 for which holds() is true; infinity if there is none. If holds() is true for a number,
// it must be true for every greater number.
template <class Holds>
double least_double(const Holds& holds) {
    std::uint64_t low = 0, high = double_infinity_magnitude;
    while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        if (holds(std::bit_cast<double>(middle))) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return std::bit_cast<double>(high);
}

}  // namespace

bool contains(const Mesh& polytope, const CurvedBody& body) {
    const IntegerBody integers(polytope, body);
    return std::ranges::all_of(polytope.triangles(), [&](const Triangle& t) { return integers.is_inside(t); });
}

double deviation(const Mesh& polytope, const CurvedBody& body) {
    const auto [num, den] = IntegerBody(polytope, body).largest_factor();
    const Dyadic longest = exact::decode(std::ranges::max(body.back().radii, {}, key_of));
    // The condition (rho - 1) m <= x, with rho^2 = num / den^2, holds if and only if m^2 num <= (x + m)^2 den^2.
    return least_double([&](double value) {
        const Dyadic x = exact::decode(value);
        const int unit = x.m == 0 ? longest.e : std::min(x.e, longest.e);
        const Integer m = in_units(longest, unit);
        return compare(square(m) * num, square((in_units(x, unit) + m) * den)) <= 0;
    });
}

}  // namespace ecods::builders
