#include "query/patch/seen_along.hpp"

#include <algorithm>
#include <utility>

#include "exact/point/posed_point.hpp"
#include "exact/point/vectors.hpp"
#include "query/convex/exact_hulls.hpp"

namespace ecods::patches {
namespace {

using exact::cross;
using exact::dot;
using exact::minus;
using exact::plus;
using exact::times;
using Kind = Feature::Kind;

// Returns the point num / den, with a positive denominator.
LongPoint quotient(ScaledLongVector num, ScaledInteger den) {
    if (den.sign() > 0) return {std::move(num), std::move(den)};
    return {{-num[0], -num[1], -num[2]}, -den};
}

// Sets corner.num / corner.den to n . (y - x), the difference of the corner's two points along n.
void set_rise(LongCorner& corner, const ScaledLongVector& n) {
    const LongPoint &x = corner.at[0], &y = corner.at[1];
    corner.num = dot(n, minus(times(y.num, x.den), times(x.num, y.den)));
    corner.den = x.den * y.den;
}

}  // namespace

ExactNormal scaled_normal(convex::PosedHulls& hulls, const convex::LeastDifference& least) {
    const exact::LongDirection found = convex::exact_normal(hulls, least);
    return {{ScaledInteger(found.x[0], 0), ScaledInteger(found.x[1], 0), ScaledInteger(found.x[2], 0)},
            {found.square, 0}};
}

SeenAlong::SeenAlong(const convex::PosedHulls& hulls, const Polygons& polygons, const ExactNormal& normal)
    : polygons_(polygons), normal_(normal) {
    for (const std::size_t side : {0, 1}) {
        const Polygon& polygon = polygons[side];
        for (const auto& corner : polygon.corners) {
            const exact::PointRef vertex = hulls.reference({side, corner.vertex});
            points_[side].push_back(exact::posed_point(*vertex.pose, *vertex.v));
        }
        for (std::size_t i = 0; i < polygon.edge_count(); ++i) {
            const ScaledLongVector way = minus(point(side, polygon.next(i)), point(side, i)),
                                   left = cross(normal.n, way);
            edges_[side].push_back({way, left, polygon.is_face() ? ScaledLongVector{} : cross(left, normal.n)});
        }
    }
}

void SeenAlong::list(convex::LeastPairs& pairs) {
    pairs.clear();
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < edges_[side].size(); ++i) {
            for (const ScaledLongVector& c : points_[1 - side])
                signs_[side].push_back(dot(minus(c, point(side, i)), edges_[side][i].left).sign());
        }
    }
    for (const std::size_t side : {0, 1}) {
        for (std::size_t i = 0; i < points_[side].size(); ++i) {
            bool is_over = false;
            const HullFeature own = polygons_[side].vertex(i), other = feature_below(side, i, is_over);
            if (!is_over || (side == 1 && other.kind == Kind::vertex)) continue;  // vertices were listed for the first
            pairs.push_back(side == 0 ? HullFeaturePair{own, other} : HullFeaturePair{other, own});
        }
    }
    for (std::size_t i = 0; i < edges_[0].size(); ++i) {
        for (std::size_t j = 0; j < edges_[1].size(); ++j) {
            if (do_cross(i, j)) pairs.push_back({polygons_[0].edge(i), polygons_[1].edge(j)});
        }
    }
}

// Returns the vertex, edge or face of the other polygon whose relative interior contains a vertex of polygon `side`,
// seen along the normal, and sets is_over. If there is none, is_over stays false and the result has no meaning.
HullFeature SeenAlong::feature_below(std::size_t side, std::size_t vertex, bool& is_over) const {
    const std::size_t of = 1 - side;
    const Polygon& polygon = polygons_[of];
    const ScaledLongVector& c = point(side, vertex);
    if (polygon.vertex_count() == 1) {
        is_over = is_zero(cross(minus(c, point(of, 0)), normal_.n));
        return polygon.feature;
    }
    if (!polygon.is_face()) return sign(of, 0, vertex) == 0 ? on_edge(of, c, is_over) : HullFeature{};
    HullFeature found = polygon.feature;
    for (std::size_t i = 0; i < polygon.edge_count(); ++i) {
        const int at = sign(of, i, vertex);
        if (at < 0) return found;
        if (at > 0) continue;
        found = sign(of, polygon.previous(i), vertex) == 0 ? polygon.vertex(i)
                : sign(of, polygon.next(i), vertex) == 0   ? polygon.vertex(polygon.next(i))
                                                           : polygon.edge(i);
    }
    is_over = true;
    return found;
}

// Returns the result of feature_below() for a polygon that is a single edge, and a point c on the line of this edge.
HullFeature SeenAlong::on_edge(std::size_t of, const ScaledLongVector& c, bool& is_over) const {
    const ScaledLongVector& along = edges_[of][0].along;
    const int from = dot(minus(c, point(of, 0)), along).sign(), to = dot(minus(c, point(of, 1)), along).sign();
    is_over = from >= 0 && to <= 0;
    return from == 0 ? polygons_[of].vertex(0) : to == 0 ? polygons_[of].vertex(1) : polygons_[of].feature;
}

// Returns true if edge i of the first polygon and edge j of the second cross: the ends of each are strictly on both
// sides of the other one's line.
bool SeenAlong::do_cross(std::size_t i, std::size_t j) const noexcept {
    return sign(0, i, j) * sign(0, i, polygons_[1].next(j)) < 0 && sign(1, j, i) * sign(1, j, polygons_[0].next(i)) < 0;
}

int SeenAlong::of(const HullFeaturePair& edges) const {
    const Edge &u = edges_[0][polygons_[0].index_of(edges[0])], &v = edges_[1][polygons_[1].index_of(edges[1])];
    return dot(u.left, v.way).sign();
}

// Returns the point p + s way of edge i that is over c along the normal n: n x (c - p) = s (n x way), so any coordinate
// of `left` = n x way that is not zero gives s.
LongPoint SeenAlong::foot_on_edge(std::size_t of, std::size_t i, const ScaledLongVector& c) const {
    const ScaledLongVector& p = point(of, i);
    const Edge& edge = edges_[of][i];
    const ScaledLongVector left_of_c = cross(normal_.n, minus(c, p));
    std::size_t k = 0;
    while (edge.left[k].sign() == 0) ++k;
    return quotient(plus(times(p, edge.left[k]), times(edge.way, left_of_c[k])), edge.left[k]);
}

// Returns the point c + t n of the face's plane: m . (c + t n - p) = 0, with m the face's normal and p its first
// corner.
LongPoint SeenAlong::foot_on_face(std::size_t of, const ScaledLongVector& c) const {
    const ScaledLongVector m = cross(edges_[of][0].way, edges_[of][1].way);
    const ScaledInteger den = dot(m, normal_.n);
    return quotient(plus(times(c, den), times(normal_.n, dot(m, minus(point(of, 0), c)))), den);
}

// Returns the two points that make the corner. For two edges from p and q, along u and v, these are p + s u and q + r
// v: with w = q - p, s = [w, v, n] / [u, v, n] and r = [w, u, n] / [u, v, n].
LongCorner SeenAlong::corner(const HullFeaturePair& pair) const {
    LongCorner result;
    if (pair[0].kind == Kind::edge && pair[1].kind == Kind::edge) {
        const std::size_t i = polygons_[0].index_of(pair[0]), j = polygons_[1].index_of(pair[1]);
        const ScaledLongVector &p = point(0, i), &q = point(1, j), w = minus(q, p);
        const Edge &u = edges_[0][i], &v = edges_[1][j];
        // den, s and r are -[u, v, n], -[w, v, n] and -[w, u, n], because `left` is n x `way`.
        const ScaledInteger den = dot(u.way, v.left), s = dot(w, v.left), r = dot(w, u.left);
        result.at[0] = quotient(plus(times(p, den), times(u.way, s)), den);
        result.at[1] = quotient(plus(times(q, den), times(v.way, r)), den);
        set_rise(result, normal_.n);
        return result;
    }
    const std::size_t side = pair[0].kind == Kind::vertex ? 0 : 1, of = 1 - side;
    const ScaledLongVector& c = point_of(side, pair[side]);
    result.at[side].num = c;
    switch (pair[of].kind) {
        case Kind::vertex:
            result.at[of].num = point_of(of, pair[of]);
            break;
        case Kind::edge:
            result.at[of] = foot_on_edge(of, polygons_[of].index_of(pair[of]), c);
            break;
        default:
            result.at[of] = foot_on_face(of, c);
    }
    set_rise(result, normal_.n);
    return result;
}

}  // namespace ecods::patches
