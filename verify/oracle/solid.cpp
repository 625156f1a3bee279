#include "oracle/solid.hpp"

#include <algorithm>
#include <map>
#include <stdexcept>

#include "oracle/float_environment.hpp"
#include "oracle/oracle.hpp"
#include "oracle/solid_pieces.hpp"
#include "oracle/solid_points.hpp"

namespace ecods::oracle {
namespace {

using Triangles = std::vector<IntegerTriangle>;

bool share_a_point(const Soup& a, const Triangles& of_a, const Soup& b, const Triangles& of_b) {
    for (const IntegerTriangle& s : of_a) {
        for (const IntegerTriangle& t : of_b) {
            if (boxes_are_apart(s, t)) continue;
            if (triangle_triangle(a.pose, s.vertices, b.pose, t.vertices) != Relation::apart) return true;
        }
    }
    return false;
}

bool is_same(const SolidPoint& p, const SolidPoint& q) {
    return p == q;
}

// On the open segment between two points.
bool is_between(const SolidPoint& x, const SolidPoint& p, const SolidPoint& q) {
    const SolidPoint from = x - p, to = q - x;
    const SolidPoint normal = cross(from, to);
    return std::ranges::all_of(normal, [](const mpz_class& n) { return sgn(n) == 0; }) && sgn(dot(from, to)) > 0;
}

bool is_inside_face(const SolidPoint& x, const IntegerTriangle& t) {
    if (!t.has_area() || sgn(dot(t.normal, SolidPoint(x - t.corners[0]))) != 0) return false;
    for (std::size_t c = 0; c < 3; ++c) {
        const SolidPoint edge = t.corners[(c + 1) % 3] - t.corners[c];
        if (sgn(dot(t.normal, cross(edge, SolidPoint(x - t.corners[c])))) <= 0) return false;
    }
    return true;
}

std::optional<NamedFeature> feature_at(const SolidPoint& x, const Triangles& triangles) {
    for (const IntegerTriangle& t : triangles) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            if (is_same(x, t.corners[c])) return NamedFeature{0, t.index, c};
        }
    }
    for (const IntegerTriangle& t : triangles) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            if (is_between(x, t.corners[c], t.corners[(c + 1) % 3])) return NamedFeature{1, t.index, c};
        }
    }
    for (const IntegerTriangle& t : triangles) {
        if (is_inside_face(x, t)) return NamedFeature{2, t.index, 0};
    }
    return std::nullopt;
}

// Whether a point that is not on the surface is in the solid.
bool is_in(const SolidPoint& x, const Triangles& solid) {
    Directions directions;
    CrossedSurface surface(solid);
    while (true) {
        if (const auto crossings = surface.count({x, 1}, directions.current())) return crossings->after % 2 != 0;
        directions.take_next();
    }
}

// Which open regions there are.
struct Regions {
    bool both = false;
    bool only_a = false;
    bool only_b = false;

    bool has_all() const { return both && only_a && only_b; }
    void add(bool in_a, bool in_b) {
        both = both || (in_a && in_b);
        only_a = only_a || (in_a && !in_b);
        only_b = only_b || (in_b && !in_a);
    }
};

// Those beside the pieces of one of the surfaces.
void add_regions(const Triangles& own, const Triangles& other, bool is_swapped, Regions& regions) {
    Directions directions;
    CrossedSurface of_own_solid(own), of_other_solid(other);
    for (const IntegerTriangle& triangle : own) {
        for (const RationalPolygon& piece : pieces(triangle, other)) {
            if (regions.has_all()) return;
            const auto [of_own, of_other] = count_both(piece, of_own_solid, of_other_solid, directions);
            if ((of_own.after + of_own.before) % 2 == 0) throw std::logic_error("a surface is no border of its solid");
            for (const auto& [in_own, in_other] :
                 {std::pair(of_own.after, of_other.after), std::pair(of_own.before, of_other.before)}) {
                const bool first = in_own % 2 != 0, second = in_other % 2 != 0;
                regions.add(is_swapped ? second : first, is_swapped ? first : second);
            }
        }
    }
}

}  // namespace

PointLocation locate(const Vec3& point, const Soup& solid) {
    const FloatEnvironment environment;
    const Triangle corner{0, 0, 0};
    const Soup alone{{&point, 1}, {&corner, 1}, Pose()};
    const std::array<SoupChoice, 2> soups{{{&alone, true}, {&solid, false}}};
    const auto triangles = integer_triangles(soups);
    const SolidPoint& x = triangles[0].front().corners[0];
    if (const auto feature = feature_at(x, triangles[1])) return {PointSide::on, *feature};
    if (is_singular(solid.pose) || !is_in(x, triangles[1])) return {PointSide::outside, {}};
    return {PointSide::inside, {}};
}

bool has_piece_inside(const Soup& surface, const Soup& solid) {
    const FloatEnvironment environment;
    if (is_singular(solid.pose)) return false;
    const std::array<SoupChoice, 2> soups{{{&surface, true}, {&solid, false}}};
    const auto triangles = integer_triangles(soups);
    const Triangles& of_solid = triangles[1];
    if (of_solid.empty()) return false;
    SolidPoint low = of_solid.front().low, high = of_solid.front().high;
    for (const IntegerTriangle& t : of_solid) {
        for (std::size_t k = 0; k < 3; ++k) {
            low[k] = std::min(low[k], t.low[k]);
            high[k] = std::max(high[k], t.high[k]);
        }
    }
    // Pieces are named by their least triangle: as often as it takes, triangles take the least name of their corners.
    std::map<SolidPoint, std::size_t> names;
    const Triangles& all = triangles[0];
    for (bool is_changed = true; is_changed;) {
        is_changed = false;
        for (std::size_t i = 0; i < all.size(); ++i) {
            std::size_t least = i;
            for (const SolidPoint& corner : all[i].corners)
                least = std::min(least, names.try_emplace(corner, i).first->second);
            for (const SolidPoint& corner : all[i].corners) {
                std::size_t& name = names[corner];
                is_changed = is_changed || name != least;
                name = least;
            }
        }
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        const SolidPoint& x = all[i].corners[0];
        if (names[x] != i) continue;
        bool is_in_box = true;
        for (std::size_t k = 0; k < 3; ++k) is_in_box = is_in_box && low[k] <= x[k] && x[k] <= high[k];
        if (is_in_box && (feature_at(x, of_solid) || is_in(x, of_solid))) return true;
    }
    return false;
}

Relation solid_relation(const Soup& a, const Soup& b) {
    const FloatEnvironment environment;
    const std::array<SoupChoice, 2> soups{{{&a, false}, {&b, false}}};
    const auto triangles = integer_triangles(soups);
    const Triangles &of_a = triangles[0], &of_b = triangles[1];
    if (of_a.empty() || of_b.empty()) return Relation::apart;
    const bool is_flat_a = is_singular(a.pose), is_flat_b = is_singular(b.pose);
    if (!is_flat_a && !is_flat_b) {
        Regions regions;
        add_regions(of_a, of_b, false, regions);
        add_regions(of_b, of_a, true, regions);
        if (regions.both) {
            if (regions.only_a) return regions.only_b ? Relation::overlapping : Relation::contains;
            return regions.only_b ? Relation::inside : Relation::equal;
        }
    }
    if (share_a_point(a, of_a, b, of_b)) return Relation::touching;
    // Their surfaces are apart, so that any point of a flat one decides.
    if (is_flat_a && !is_flat_b && std::ranges::any_of(of_a, [&](auto& t) { return is_in(t.corners[0], of_b); })) {
        return Relation::touching;
    }
    if (is_flat_b && !is_flat_a && std::ranges::any_of(of_b, [&](auto& t) { return is_in(t.corners[0], of_a); })) {
        return Relation::touching;
    }
    return Relation::apart;
}

Relation surface_relation(const Soup& surface, const Soup& solid) {
    const FloatEnvironment environment;
    const std::array<SoupChoice, 2> soups{{{&surface, true}, {&solid, false}}};
    const auto triangles = integer_triangles(soups);
    const Triangles &of_surface = triangles[0], &of_solid = triangles[1];
    if (of_solid.empty()) return Relation::apart;
    bool has_inside = false, has_outside = false;
    Directions directions;
    CrossedSurface crossed(of_solid);
    for (const IntegerTriangle& triangle : of_surface) {
        if (is_singular(solid.pose)) break;
        for (const RationalPolygon& piece : pieces(triangle, of_solid)) {
            const Crossings crossings = count_one(piece, crossed, directions);
            if (crossings.at != 0) continue;  // on the solid's surface
            (crossings.after % 2 != 0 ? has_inside : has_outside) = true;
        }
    }
    if (has_inside) return has_outside ? Relation::crossing : Relation::inside;
    return share_a_point(surface, of_surface, solid, of_solid) ? Relation::touching : Relation::apart;
}

}  // namespace ecods::oracle
