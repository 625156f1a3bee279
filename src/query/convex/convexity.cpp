#include "query/convex/convexity.hpp"

#include <array>
#include <span>

#include "base/assert.hpp"
#include "base/make_error.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/number/long_vector.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::convex {
namespace {

// Returns the distance of a point from the plane of a triangle, rounded once.
double distance_from_plane(const std::array<Vec3, 3>& triangle, const Vec3& point) {
    using exact::LongVector;
    exact::BitRange digits;
    for (int axis = 0; axis < 3; ++axis) {
        digits.include(exact::decode(point[axis]));
        for (const Vec3& v : triangle) digits.include(exact::decode(v[axis]));
    }
    const auto vector = [&](const Vec3& v) {
        LongVector result;
        for (std::size_t k = 0; k < 3; ++k) {
            result[k] = exact::in_units(exact::decode(v[static_cast<Eigen::Index>(k)]), digits.low);
        }
        return result;
    };
    const LongVector a = vector(triangle[0]), n = cross(minus(vector(triangle[1]), a), minus(vector(triangle[2]), a));
    exact::SquaredDistance square;
    square.num.assign(exact::square(dot(n, minus(vector(point), a))).limbs());
    square.den.assign(dot(n, n).limbs());
    square.exponent = digits.low;
    return exact::round_root(square);
}

class Check {
  public:
    Check(const Border& border, const Shells& shells, const Mesh& given)
        : border_(border), shells_(shells), given_(given), triangles_(border.proper->mesh->triangles()) {}

    // Returns, by edge, whether the edge is flat; throws if an edge is a dent. An edge of four or more triangles always
    // has a dent, where one triangle is beyond another's plane. Otherwise the gaps on both sides of a wedge of the
    // solid would be at least half a turn each, and leave no angle for the wedge.
    std::vector<std::uint8_t> find_flat() const {
        std::vector<std::uint8_t> is_flat(border_.edges->count());
        for (std::size_t e = 0; e < is_flat.size(); ++e) {
            const auto sides = border_.edges->sides(e);
            for (const SideRef& side : sides) {
                for (const SideRef& other : sides) {
                    if (&side == &other) continue;
                    const std::uint32_t apex = opposite_corner(triangles_[other.triangle], other.corner);
                    const int beyond = side_of_plane(border_, side.triangle, apex);
                    if (beyond > 0) fail_at_dent(side, other);
                    is_flat[e] = beyond == 0;
                    if (sides.size() == 2) break;
                }
                if (sides.size() == 2) break;
            }
            ECODS_ASSERT(sides.size() == 2);
        }
        return is_flat;
    }

    // Throws NotSolid if there is a second shell. If both of two shells are convex, and neither is a cavity, one of
    // them has a vertex outside the other.
    void require_one_shell() const {
        if (shells_.first.size() == 1) return;
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (shells_.of_triangle[i] != 1) continue;
            for (const std::uint32_t vertex : triangles_[i]) {
                for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
                    if (shells_.of_triangle[k] == 0 && side_of_plane(border_, k, vertex) > 0) {
                        fail(named_side(k), beyond_corner(i, k, vertex));
                    }
                }
            }
        }
        ECODS_ASSERT(false);
    }

  private:
    // Returns side 0 of the triangle of the named mesh that contains triangle i as a piece.
    SideRef named_side(std::uint32_t i) const noexcept { return {border_.origin({i, 0}).triangle, 0}; }

    // Returns a corner of a triangle of the named mesh: of the triangle that contains `of` as a piece, a corner beyond
    // the plane of triangle `plane`. `vertex` must be a corner of `of` beyond that plane. If `vertex` is inside a side
    // of the whole triangle, an end of that side is beyond the plane, too.
    std::uint32_t beyond_corner(std::uint32_t of, std::uint32_t plane, std::uint32_t vertex) const noexcept {
        const std::uint32_t whole = border_.origin({of, 0}).triangle;
        const Triangle& named = border_.named->mesh->triangles()[whole];
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            if (named[corner] == vertex) return given_.triangles()[whole][corner];
        }
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            if (side_of_plane(border_, plane, named[corner]) > 0) return given_.triangles()[whole][corner];
        }
        ECODS_ASSERT(false);
        return given_.triangles()[whole][0];
    }

    [[noreturn]] void fail_at_dent(const SideRef& side, const SideRef& other) const {
        const std::uint32_t apex = opposite_corner(triangles_[other.triangle], other.corner);
        fail(border_.origin(side), beyond_corner(other.triangle, side.triangle, apex));
    }

    [[noreturn]] void fail(const SideRef& side, std::uint32_t beyond) const {
        const Triangle& triangle = given_.triangles()[side.triangle];
        const std::span<const Vec3> v = given_.vertices();
        throw dent(
            {side.triangle, static_cast<int>(side.corner), {triangle[side.corner], triangle[(side.corner + 1) % 3]}},
            beyond, distance_from_plane({v[triangle[0]], v[triangle[1]], v[triangle[2]]}, v[beyond]));
    }

    const Border& border_;
    const Shells& shells_;
    const Mesh& given_;
    std::span<const Triangle> triangles_;
};

}  // namespace

std::vector<std::uint8_t> require_convex(const Border& border, const Shells& shells, const Mesh& given) {
    const Check check(border, shells, given);
    std::vector<std::uint8_t> is_flat = check.find_flat();
    check.require_one_shell();
    return is_flat;
}

}  // namespace ecods::convex
