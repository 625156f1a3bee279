#include "oracle/triangle_distance.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace ecods::oracle {
namespace {

std::vector<FeaturePair> make_feature_pairs() {
    std::vector<FeaturePair> pairs;
    for (std::uint32_t i = 0; i < 3; ++i) {
        for (std::uint32_t j = 0; j < 3; ++j) {
            pairs.push_back({Closeness::vertex_vertex, 0, i, 0, j});
            pairs.push_back({Closeness::vertex_edge, 0, i, 1, j});
            pairs.push_back({Closeness::vertex_edge, 1, i, 0, j});
            pairs.push_back({Closeness::edge_edge, 1, i, 1, j});
        }
        pairs.push_back({Closeness::vertex_face, 0, i, 2, 0});
        pairs.push_back({Closeness::vertex_face, 2, 0, 0, i});
    }
    std::ranges::sort(pairs, {}, [](const FeaturePair& p) { return std::tuple(p.kind, p.a, p.b, p.dimension_a); });
    return pairs;
}

IntegerPoint corner_of(const TriangleOf<mpz_class>& t, std::size_t corner) {
    return {t.corner[corner], 1};
}

// p + along / den * direction.
IntegerPoint point_along(const Vector<mpz_class>& p, const Vector<mpz_class>& direction, const mpz_class& along,
                         const mpz_class& den) {
    IntegerPoint point;
    for (std::size_t k = 0; k < 3; ++k) point.num[k] = p[k] * den + direction[k] * along;
    point.den = den;
    return point;
}

IntegerPoint point_of_piercing(const TriangleOf<mpz_class>& s, std::size_t edge, const Piercing<mpz_class>& piercing) {
    mpz_class along = piercing.height_from, den = piercing.height_from - piercing.height_to;
    if (sgn(den) < 0) {
        den = -den;
        along = -along;
    }
    return point_along(s.corner[edge], s.edge[edge], along, den);
}

}  // namespace

std::span<const FeaturePair> feature_pairs() {
    static const std::vector<FeaturePair> pairs = make_feature_pairs();
    return pairs;
}

int IntegerPoint::compare(const IntegerPoint& p, const IntegerPoint& q) {
    for (std::size_t k = 0; k < 3; ++k) {
        const int sign = cmp(mpz_class(p.num[k] * q.den), mpz_class(q.num[k] * p.den));
        if (sign != 0) return sign;
    }
    return 0;
}

namespace {

double middle(const Interval& x) {
    return 0.5 * x.inf() + 0.5 * x.sup();
}

Vector<double> middle(const Vector<Interval>& v) {
    return {middle(v[0]), middle(v[1]), middle(v[2])};
}

// About the direction from one feature to the other, of any length.
Vector<double> direction(const FeaturePair& pair, const TriangleOf<Interval>& a, const TriangleOf<Interval>& b) {
    const Vector<double> w = middle(b.corner[pair.b]) - middle(a.corner[pair.a]);
    if (pair.kind == Closeness::vertex_vertex) return w;
    if (pair.kind == Closeness::vertex_face) return middle(pair.dimension_a == 2 ? a.normal : b.normal);
    if (pair.kind == Closeness::edge_edge) return cross(middle(a.edge[pair.a]), middle(b.edge[pair.b]));
    const Vector<double> u = middle(pair.dimension_a == 1 ? a.edge[pair.a] : b.edge[pair.b]);
    const double along = dot(w, u) / dot(u, u);
    return {w[0] - along * u[0], w[1] - along * u[1], w[2] - along * u[2]};
}

// A lower bound of the squared distance: the gap of the projections on any line is no longer than the distance.
double gap_along(const Vector<double>& direction, const TriangleOf<Interval>& a, const TriangleOf<Interval>& b) {
    if (!std::isfinite(direction[0] + direction[1] + direction[2])) return 0;
    const Vector<Interval> n{direction[0], direction[1], direction[2]};
    double least = std::numeric_limits<double>::infinity(), least_back = least;
    for (const auto& p : a.corner) {
        for (const auto& q : b.corner) {
            const Interval along = dot(n, Vector<Interval>(q - p));
            least = std::min(least, along.inf());
            least_back = std::min(least_back, -along.sup());
        }
    }
    const double gap = std::max(least, least_back);
    return gap > 0 ? (CGAL::square(Interval(gap)) / square_of(n)).inf() : 0;
}

}  // namespace

Enclosure enclose(const TriangleOf<Interval>& a, const TriangleOf<Interval>& b) {
    Enclosure result;
    const auto pairs = feature_pairs();
    std::size_t nearest = 0;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        result.feature_lower[i] = std::numeric_limits<double>::infinity();
        const FeatureDistance<Interval> d = feature_distance(pairs[i], a, b);
        if (!d.may_be_inside) continue;
        // Where the denominator may be zero nothing is known of the quotient, not even that there are such features.
        if (!(d.den.inf() > 0)) {
            result.feature_lower[i] = 0;
            continue;
        }
        const Interval square = d.num / d.den;
        result.feature_lower[i] = std::max(square.inf(), 0.0);
        if (d.is_inside && square.sup() < result.upper) {
            result.upper = square.sup();
            nearest = i;
        }
    }
    const double gap = gap_along(direction(pairs[nearest], a, b), a, b);
    for (double& lower : result.feature_lower) lower = std::max(lower, gap);
    result.lower = *std::ranges::min_element(result.feature_lower);
    for (std::size_t k = 0; gap == 0 && k < 3 && !result.may_pierce; ++k) {
        result.may_pierce = pierces(a, k, b).may_be || pierces(b, k, a).may_be;
    }
    if (result.may_pierce) result.lower = 0;
    return result;
}

LeastFeatures least_features(const TriangleOf<mpz_class>& a, const TriangleOf<mpz_class>& b,
                             const Enclosure& enclosure) {
    LeastFeatures least;
    for (std::size_t k = 0; k < 3 && enclosure.may_pierce; ++k) {
        if (!pierces(a, k, b).may_be && !pierces(b, k, a).may_be) continue;
        least.num = 0;
        return least;
    }
    const auto pairs = feature_pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (enclosure.feature_lower[i] > enclosure.upper) continue;
        const FeatureDistance<mpz_class> d = feature_distance(pairs[i], a, b);
        if (!d.is_inside) continue;
        const int order = sgn(least.num) < 0 ? -1 : cmp(mpz_class(d.num * least.den), mpz_class(least.num * d.den));
        if (order > 0) continue;
        if (order < 0) {
            least.num = d.num;
            least.den = d.den;
            least.pairs.clear();
        }
        least.pairs.push_back(i);
    }
    return least;
}

std::array<IntegerPoint, 2> closest_points(const FeaturePair& pair, const TriangleOf<mpz_class>& a,
                                           const TriangleOf<mpz_class>& b) {
    const FeatureDistance<mpz_class> d = feature_distance(pair, a, b);
    const bool is_swapped = pair.dimension_a > pair.dimension_b;
    const TriangleOf<mpz_class>& p = is_swapped ? b : a;
    const TriangleOf<mpz_class>& q = is_swapped ? a : b;
    const std::uint32_t i = is_swapped ? pair.b : pair.a, j = is_swapped ? pair.a : pair.b;
    std::array<IntegerPoint, 2> points{corner_of(p, i), corner_of(q, j)};
    if (pair.kind == Closeness::vertex_edge) {
        points[1] = point_along(q.corner[j], q.edge[j], d.along_b, d.den);
    } else if (pair.kind == Closeness::vertex_face) {
        points[1] = point_along(p.corner[i], q.normal, -d.above, d.den);
    } else if (pair.kind == Closeness::edge_edge) {
        points[0] = point_along(p.corner[i], p.edge[i], d.along_a, d.den);
        points[1] = point_along(q.corner[j], q.edge[j], d.along_b, d.den);
    }
    if (is_swapped) std::swap(points[0], points[1]);
    return points;
}

// A corner of what is shared is inside one face of each triangle, these being a vertex, an edge, or the whole, and is
// the only point that these two share: two features at distance zero, or an edge that passes through the face. The
// middle one of three corners on a line is found, too, and is no corner; it lies between the others.
std::vector<IntegerPoint> shared_corners(const TriangleOf<mpz_class>& a, const TriangleOf<mpz_class>& b) {
    std::vector<IntegerPoint> corners;
    for (const FeaturePair& pair : feature_pairs()) {
        const FeatureDistance<mpz_class> d = feature_distance(pair, a, b);
        if (d.is_inside && sgn(d.num) == 0) corners.push_back(closest_points(pair, a, b)[0]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
        if (const auto through = pierces(a, k, b); through.may_be) corners.push_back(point_of_piercing(a, k, through));
        if (const auto through = pierces(b, k, a); through.may_be) corners.push_back(point_of_piercing(b, k, through));
    }
    std::ranges::sort(corners,
                      [](const IntegerPoint& p, const IntegerPoint& q) { return IntegerPoint::compare(p, q) < 0; });
    const auto same = [](const IntegerPoint& p, const IntegerPoint& q) { return IntegerPoint::compare(p, q) == 0; };
    corners.erase(std::unique(corners.begin(), corners.end(), same), corners.end());
    const bool is_on_a_line = sgn(a.normal_square) == 0 || sgn(b.normal_square) == 0;
    if (is_on_a_line && corners.size() > 2) corners.erase(corners.begin() + 1, corners.end() - 1);
    return corners;
}

}  // namespace ecods::oracle
