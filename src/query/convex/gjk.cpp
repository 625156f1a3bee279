#include "query/convex/gjk.hpp"

#include "exact/point/vectors.hpp"
#include "query/convex/gjk_rounds.hpp"
#include "simd/dispatch.hpp"

namespace ecods::convex {
namespace {

using exact::dot;
using exact::minus;
using exact::negated;
using gjk::add;
using gjk::descend;

struct OfScannedHulls {
    const PosedHulls& hulls;

    ECODS_ALWAYS_INLINE std::uint32_t operator()(std::size_t side, const Point& along, std::uint32_t) const noexcept {
        return hulls.scan(side, along);
    }
};
struct OfTriangles {
    const std::array<std::array<std::uint32_t, 3>, 2>& triangles;
    std::array<std::array<Point, 3>, 2> points;

    ECODS_ALWAYS_INLINE std::uint32_t operator()(std::size_t side, const Point& along, std::uint32_t) const noexcept {
        const auto& of = points[side];
        const double x = dot(along, of[0]), y = dot(along, of[1]), z = dot(along, of[2]);
        return triangles[side][x >= y ? (x >= z ? 0 : 2) : (y >= z ? 1 : 2)];
    }
};

ECODS_ALWAYS_INLINE void descend_scanned(Simplex& simplex, const PosedHulls& hulls) noexcept {
    descend(simplex, hulls, OfScannedHulls{hulls});
}

}  // namespace

Simplex between_centers(const PosedHulls& hulls) noexcept {
    const Point between = minus(hulls.center(1), hulls.center(0));
    Simplex start;
    add(start, hulls, {hulls.support(0, between), hulls.support(1, negated(between))});
    return start;
}

Simplex run_gjk(const PosedHulls& hulls, const Simplex& start) noexcept {
    Simplex simplex = start;
    if (hulls.is_scanned(0) && hulls.is_scanned(1)) {
        dispatch<descend_scanned>(simplex, hulls);
    } else {
        descend(simplex, hulls, [&](std::size_t side, const Point& along, std::uint32_t from) {
            return hulls.support(side, along, from);
        });
    }
    return simplex.count > 0 ? simplex : start;
}

Simplex run_gjk_of_triangles(const PosedHulls& hulls,
                             const std::array<std::array<std::uint32_t, 3>, 2>& triangles) noexcept {
    OfTriangles support{triangles, {}};
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < 3; ++i) support.points[side][i] = hulls.rounded(side, triangles[side][i]);
    }
    Simplex simplex;
    add(simplex, hulls, {triangles[0][0], triangles[1][0]});
    descend(simplex, hulls, support);
    return simplex;
}

}  // namespace ecods::convex
