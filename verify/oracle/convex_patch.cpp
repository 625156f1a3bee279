#include "oracle/convex_patch.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "oracle/convex_facets.hpp"
#include "oracle/float_environment.hpp"
#include "oracle/rounded.hpp"

namespace ecods::oracle {
namespace {

using Point = Vector<mpq_class>;
using Flat = std::array<mpq_class, 2>;  // of a plane

mpq_class turn(const Flat& a, const Flat& b, const Flat& c) {
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Returns true if x is between a and b, or at one of them.
bool is_between(const Flat& x, const Flat& a, const Flat& b) {
    if (sgn(turn(a, b, x)) != 0) return false;
    return sgn((x[0] - a[0]) * (x[0] - b[0]) + (x[1] - a[1]) * (x[1] - b[1])) <= 0;
}

// The corners of the convex hull of different points, counterclockwise; of points of one line its two ends.
std::vector<Flat> hull_of(std::vector<Flat> points) {
    std::ranges::sort(points);
    points.erase(std::ranges::unique(points).begin(), points.end());
    if (points.size() < 3) return points;
    std::vector<Flat> hull;
    for (int half = 0; half < 2; ++half) {
        const std::size_t begin = hull.size();
        for (const Flat& p : points) {
            while (hull.size() >= begin + 2 && sgn(turn(hull[hull.size() - 2], hull.back(), p)) <= 0) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();
        std::ranges::reverse(points);
    }
    return hull;
}

bool is_inside(const Flat& x, const std::vector<Flat>& hull) {
    if (hull.size() == 1) return x == hull[0];
    if (hull.size() == 2) return is_between(x, hull[0], hull[1]);
    for (std::size_t i = 0; i < hull.size(); ++i) {
        if (sgn(turn(hull[i], hull[(i + 1) % hull.size()], x)) < 0) return false;
    }
    return true;
}

// Returns where the segments from a to b and from c to d cross, if they cross in one point.
std::optional<Flat> crossing(const Flat& a, const Flat& b, const Flat& c, const Flat& d) {
    const mpq_class at_c = turn(a, b, c), at_d = turn(a, b, d);
    if (sgn(at_c) * sgn(at_d) >= 0 || sgn(turn(c, d, a)) * sgn(turn(c, d, b)) > 0) return std::nullopt;
    const mpq_class s = at_c / (at_c - at_d);
    return Flat{c[0] + s * (d[0] - c[0]), c[1] + s * (d[1] - c[1])};
}

Point in_fractions(const Vector<mpz_class>& v, long unit) {
    Point result;
    const auto shift = static_cast<mp_bitcnt_t>(std::abs(unit));
    for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class x(v[k]);
        if (unit >= 0) {
            mpq_mul_2exp(result[k].get_mpq_t(), x.get_mpq_t(), shift);
        } else {
            mpq_div_2exp(result[k].get_mpq_t(), x.get_mpq_t(), shift);
        }
    }
    return result;
}

// Shown is what a body shows along a vector: the vertices of a feature, in space and in the plane.
struct Shown {
    std::vector<std::uint32_t> vertices;  // ascending
    std::vector<Point> points;
    std::vector<Flat> flat;
    std::vector<Flat> hull;
};

class Seeing {
  public:
    Seeing(const ConvexBodies& bodies, const Point& normal) : bodies_(bodies), normal_(normal) {
        for (std::size_t k = 1; k < 3; ++k) {
            if (abs(normal[k]) > abs(normal[axis_])) axis_ = k;
        }
    }

    // Along the normal into a plane: counterclockwise there is counterclockwise around the normal.
    Flat flat(const Point& p) const {
        const mpq_class along = p[axis_] / normal_[axis_];
        const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
        Flat result{p[i] - along * normal_[i], p[j] - along * normal_[j]};
        if (sgn(normal_[axis_]) < 0) std::swap(result[0], result[1]);
        return result;
    }

    Point point(std::size_t side, std::uint32_t vertex) const {
        return in_fractions(bodies_.exact[side].vertices[vertex], bodies_.unit);
    }

    Shown show(std::size_t side, double min_cos_squared) const {
        Shown shown;
        shown.vertices = facing(side, min_cos_squared);
        std::ranges::sort(shown.vertices);
        for (const std::uint32_t v : shown.vertices) {
            shown.points.push_back(point(side, v));
            shown.flat.push_back(flat(shown.points.back()));
        }
        shown.hull = hull_of(shown.flat);
        return shown;
    }

    // The feature that is seen at a point of the plane.
    NamedFeature named(std::size_t side, const Shown& shown, const Flat& x) const {
        std::vector<std::uint32_t> corners;
        for (std::size_t i = 0; i < shown.flat.size(); ++i) {
            if (shown.flat[i] == x) corners = {shown.vertices[i]};
        }
        const std::vector<Flat>& hull = shown.hull;
        const auto vertex_at = [&](const Flat& p) {
            return shown.vertices[static_cast<std::size_t>(std::ranges::find(shown.flat, p) - shown.flat.begin())];
        };
        for (std::size_t i = 0; i < hull.size() && corners.empty() && hull.size() > 1; ++i) {
            const Flat &p = hull[i], &q = hull[(i + 1) % hull.size()];
            if (is_between(x, p, q)) corners = {vertex_at(p), vertex_at(q)};
        }
        if (corners.empty()) corners = shown.vertices;
        std::ranges::sort(corners);
        return bodies_.features[side].name_of(corners);
    }

    // The point of the feature that is seen at a point of the plane.
    Point lifted(const Shown& shown, const Flat& x) const {
        const std::vector<Point>& p = shown.points;
        if (p.size() == 1) return p[0];
        if (p.size() == 2) {
            const std::size_t k = shown.flat[0][0] == shown.flat[1][0] ? 1 : 0;
            const mpq_class s = (x[k] - shown.flat[0][k]) / (shown.flat[1][k] - shown.flat[0][k]);
            return {p[0][0] + s * (p[1][0] - p[0][0]), p[0][1] + s * (p[1][1] - p[0][1]),
                    p[0][2] + s * (p[1][2] - p[0][2])};
        }
        // by the weights of three vertices
        const std::vector<Flat>& f = shown.flat;
        const mpq_class all = turn(f[0], f[1], f[2]), b = turn(f[0], x, f[2]) / all, c = turn(f[0], f[1], x) / all;
        Point result;
        for (std::size_t k = 0; k < 3; ++k) result[k] = p[0][k] + b * (p[1][k] - p[0][k]) + c * (p[2][k] - p[0][k]);
        return result;
    }

  private:
    // The vertices of the feature that faces the normal: n for the first body, -n for the second.
    std::vector<std::uint32_t> facing(std::size_t side, double min_cos_squared) const {
        const ConvexBody<mpz_class>& body = bodies_.exact[side];
        const mpq_class nn = dot(normal_, normal_), least(min_cos_squared);
        Point out = normal_;
        if (side == 1) out = {-out[0], -out[1], -out[2]};
        std::vector<std::uint32_t> support;
        mpq_class best;
        for (std::uint32_t v = 0; v < body.vertices.size(); ++v) {
            const mpq_class height = dot(out, in_fractions(body.vertices[v], 0));
            if (support.empty() || height > best) {
                support.clear();
                best = height;
            }
            if (height == best) support.push_back(v);
        }
        const auto has = [&](const std::vector<std::uint32_t>& list) {
            return std::ranges::all_of(support, [&](std::uint32_t v) { return std::ranges::count(list, v) > 0; });
        };
        std::optional<std::pair<mpq_class, std::vector<std::uint32_t>>> chosen;
        for (std::size_t f = 0; f < body.faces.size(); ++f) {
            const std::vector<std::uint32_t>& corners = bodies_.features[side].faces[f].corners;
            const Point m = in_fractions(body.faces[f].normal, 0);
            const mpq_class along = dot(m, out), cosine = along * along / (dot(m, m) * nn);
            if (!has(corners) || sgn(along) <= 0 || cosine < least) continue;
            if (!chosen || cosine > chosen->first) chosen = {cosine, corners};
        }
        if (chosen) return chosen->second;
        if (support.size() > 1) return support;
        for (const auto& edge : bodies_.features[side].edges) {
            const std::vector<std::uint32_t> ends(edge.ends.begin(), edge.ends.end());
            if (!has(ends)) continue;
            const Point way = in_fractions(Vector<mpz_class>(body.vertices[ends[1]] - body.vertices[ends[0]]), 0);
            const mpq_class along = dot(way, out), sine = along * along / (dot(way, way) * nn);
            if (sine > 1 - least) continue;
            if (!chosen || sine < chosen->first) chosen = {sine, ends};
        }
        return chosen ? chosen->second : support;
    }

    const ConvexBodies& bodies_;
    Point normal_;
    std::size_t axis_ = 0;
};

auto rank(const ConvexPatch::Corner& c) {
    const auto [less, more] = std::minmax(c.a.dimension, c.b.dimension);
    const Closeness kind = less == 1 ? Closeness::edge_edge : static_cast<Closeness>(more);
    return std::tuple(c.height, kind, c.a.triangle, c.a.corner, c.b.triangle, c.b.corner, c.a.dimension);
}

Vec3 rounded(const Point& x, const Point& normal, const mpq_class& square, const mpq_class& along) {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[static_cast<int>(k)] = nearest(FractionAndRoot{x[k], along * normal[k] / square, square});
    }
    return result;
}

}  // namespace

ConvexPatch::ConvexPatch(const std::array<const Mesh*, 2>& meshes, const std::array<Pose, 2>& poses,
                         const std::array<mpz_class, 3>& normal, double min_cos_squared) {
    const FloatEnvironment environment;
    const ConvexBodies bodies(meshes, poses);
    normal_ = {mpq_class(normal[0]), mpq_class(normal[1]), mpq_class(normal[2])};
    square_ = dot(normal_, normal_);
    const Seeing seeing(bodies, normal_);
    const std::array<Shown, 2> shown{seeing.show(0, min_cos_squared), seeing.show(1, min_cos_squared)};
    std::vector<Flat> common;
    for (const std::size_t side : {0U, 1U}) {
        for (const Flat& x : shown[side].flat) {
            if (is_inside(x, shown[1 - side].hull)) common.push_back(x);
        }
    }
    const std::vector<Flat>&p = shown[0].flat, &q = shown[1].flat;
    for (std::size_t i = 0; i < p.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            for (std::size_t k = 0; k < q.size(); ++k) {
                for (std::size_t l = 0; l < k; ++l) {
                    if (const auto x = crossing(p[i], p[j], q[k], q[l])) common.push_back(*x);
                }
            }
        }
    }
    for (const Flat& x : hull_of(common)) {
        Corner corner;
        corner.a = seeing.named(0, shown[0], x);
        corner.b = seeing.named(1, shown[1], x);
        corner.at = {seeing.lifted(shown[0], x), seeing.lifted(shown[1], x)};
        corner.height = dot(normal_, Point(corner.at[1] - corner.at[0]));
        corners_.push_back(corner);
    }
    std::ranges::rotate(corners_, std::ranges::min_element(corners_, {}, [](const Corner& c) { return rank(c); }));
}

mpq_class ConvexPatch::area_of(const std::vector<Corner>& corners, const std::vector<std::size_t>& chosen) const {
    const Point& first = corners[chosen[0]].at[0];
    if (chosen.size() == 2) {
        const Point way = corners[chosen[1]].at[0] - first;
        const Point across = cross(normal_, way);
        return dot(across, across);
    }
    mpq_class sum = 0;
    for (std::size_t i = 1; i + 1 < chosen.size(); ++i) {
        const Point u = corners[chosen[i]].at[0] - first, v = corners[chosen[i + 1]].at[0] - first;
        sum += dot(normal_, cross(u, v));
    }
    return sum;
}

std::vector<std::size_t> ConvexPatch::chosen(const std::vector<Corner>& corners, std::size_t count) const {
    std::vector<std::size_t> best;
    mpq_class most;
    std::vector<bool> is_chosen(corners.size());
    std::fill_n(is_chosen.begin(), count, true);
    do {  // lexicographically
        if (!is_chosen[0]) break;
        std::vector<std::size_t> list;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            if (is_chosen[i]) list.push_back(i);
        }
        const mpq_class area = area_of(corners, list);
        if (!best.empty() && area <= most) continue;
        most = area;
        best = list;
    } while (std::prev_permutation(is_chosen.begin(), is_chosen.end()));
    return best;
}

Vec3 ConvexPatch::point(const Corner& corner, std::size_t side, const std::array<double, 2>& radii) const {
    const mpq_class radius(radii[side]);
    return rounded(corner.at[side], normal_, square_, side == 0 ? radius : mpq_class(-radius));
}

Vec3 ConvexPatch::middle(const Corner& corner, const std::array<double, 2>& radii) const {
    Point sum;
    for (std::size_t k = 0; k < 3; ++k) sum[k] = (corner.at[0][k] + corner.at[1][k]) / 2;
    return rounded(sum, normal_, square_, (mpq_class(radii[0]) - mpq_class(radii[1])) / 2);
}

double ConvexPatch::gap(const Corner& corner, const std::array<double, 2>& radii) const {
    const FractionAndRoot gap{-mpq_class(radii[0]) - mpq_class(radii[1]), corner.height / square_, square_};
    const double rounded = nearest(gap);
    return rounded == 0 ? gap.sign() * std::numeric_limits<double>::denorm_min() : rounded;
}

int ConvexPatch::sign_of_gap(const Corner& corner, const std::array<double, 2>& radii, double d) const {
    return FractionAndRoot{-mpq_class(radii[0]) - mpq_class(radii[1]) - mpq_class(d), corner.height / square_, square_}
        .sign();
}

}  // namespace ecods::oracle
