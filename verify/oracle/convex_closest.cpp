#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "oracle/convex_facets.hpp"

namespace ecods::oracle {
namespace {

// Two features by their indices.
struct Candidate {
    Closeness kind = Closeness::vertex_vertex;
    std::array<int, 2> dimensions{};
    std::array<std::uint32_t, 2> index{};
    double lower = 0;  // of the squared distance
};

// Above the inside of a face.
template <class N>
FeatureDistance<N> vertex_polygon(const Vector<N>& p, const typename ConvexBody<N>::Face& face) {
    FeatureDistance<N> d;
    d.is_inside = d.may_be_inside = true;
    for (std::size_t i = 0; i < face.corners.size() && d.may_be_inside; ++i) {
        const Vector<N>&from = face.corners[i], &to = face.corners[(i + 1) % face.corners.size()];
        const N side = dot(cross(Vector<N>(to - from), Vector<N>(p - from)), face.normal);
        d.may_be_inside = may_be_positive(side);
        d.is_inside = d.is_inside && is_positive(side);
    }
    if (!d.may_be_inside) return d;
    d.above = dot(face.normal, Vector<N>(p - face.corners[0]));
    d.num = square(d.above);
    d.den = square_of(face.normal);
    return d;
}

template <class N>
FeatureDistance<N> distance_of(const Candidate& pair, const std::array<ConvexBody<N>, 2>& in) {
    const bool is_vertex_first = pair.dimensions[0] == 0;
    const auto [i, j] = is_vertex_first ? pair.index : std::array{pair.index[1], pair.index[0]};
    const ConvexBody<N>&first = in[is_vertex_first ? 0 : 1], &second = in[is_vertex_first ? 1 : 0];
    switch (pair.kind) {
        case Closeness::vertex_vertex:
            return vertex_vertex(first.vertices[i], second.vertices[j]);
        case Closeness::vertex_edge:
            return vertex_edge(first.vertices[i], second.edges[j], 0);
        case Closeness::vertex_face:
            return vertex_polygon(first.vertices[i], second.faces[j]);
        default:
            return edge_edge(in[0].edges[pair.index[0]], 0, in[1].edges[pair.index[1]], 0);
    }
}

double lower_of(const FeatureDistance<Interval>& d) {
    if (!(d.den.inf() > 0)) return 0;
    const double lower = (d.num / d.den).inf();
    return lower > 0 ? lower : 0;
}
double upper_of(const FeatureDistance<Interval>& d) {
    if (!d.is_inside || !(d.den.inf() > 0)) return std::numeric_limits<double>::infinity();
    return (d.num / d.den).sup();
}

std::size_t count_of(const ConvexBody<Interval>& body, int dimension) {
    return dimension == 0 ? body.vertices.size() : dimension == 1 ? body.edges.size() : body.faces.size();
}

// All that intervals leave.
std::vector<Candidate> candidates_of(const ConvexBodies& bodies) {
    constexpr std::tuple<Closeness, int, int> kinds[] = {
        {Closeness::vertex_vertex, 0, 0}, {Closeness::vertex_edge, 0, 1}, {Closeness::vertex_edge, 1, 0},
        {Closeness::vertex_face, 0, 2},   {Closeness::vertex_face, 2, 0}, {Closeness::edge_edge, 1, 1}};
    double upper = std::numeric_limits<double>::infinity();
    std::vector<Candidate> found;
    for (const auto& [kind, of_a, of_b] : kinds) {
        for (std::uint32_t i = 0; i < count_of(bodies.around[0], of_a); ++i) {
            for (std::uint32_t j = 0; j < count_of(bodies.around[1], of_b); ++j) {
                Candidate candidate{kind, {of_a, of_b}, {i, j}};
                const auto d = distance_of(candidate, bodies.around);
                if (!d.may_be_inside) continue;
                candidate.lower = lower_of(d);
                upper = std::min(upper, upper_of(d));
                if (candidate.lower <= upper) found.push_back(candidate);
            }
        }
    }
    std::erase_if(found, [&](const Candidate& candidate) { return candidate.lower > upper; });
    return found;
}

const NamedFeature& name_of(const ConvexFeatures& features, int dimension, std::uint32_t index) {
    return dimension == 0   ? features.vertices[index].name
           : dimension == 1 ? features.edges[index].name
                            : features.faces[index].name;
}

Vector<mpz_class> scaled(const Vector<mpz_class>& v, const mpz_class& by) {
    return {v[0] * by, v[1] * by, v[2] * by};
}

// p + v * num / den
ExactPoint point_along(const Vector<mpz_class>& p, const Vector<mpz_class>& v, const mpz_class& num,
                       const mpz_class& den, long unit) {
    const Vector<mpz_class> start = scaled(p, den), way = scaled(v, num);
    ExactPoint point;
    for (std::size_t k = 0; k < 3; ++k) point.x[k] = {start[k] + way[k], den, unit};
    return point;
}

ExactClosest measured(const Candidate& pair, const FeatureDistance<mpz_class>& d, const ConvexBodies& bodies) {
    ExactClosest closest;
    closest.distance = {d.num, d.den, bodies.unit};
    closest.kind = pair.kind;
    closest.a = name_of(bodies.features[0], pair.dimensions[0], pair.index[0]);
    closest.b = name_of(bodies.features[1], pair.dimensions[1], pair.index[1]);
    std::array<ExactPoint, 2> points;
    for (std::size_t s = 0; s < 2; ++s) {
        const ConvexBody<mpz_class>&own = bodies.exact[s], &other = bodies.exact[1 - s];
        const std::uint32_t i = pair.index[s], j = pair.index[1 - s];
        if (pair.dimensions[s] == 0) {
            points[s] = point_along(own.vertices[i], own.vertices[i], 0, 1, bodies.unit);
        } else if (pair.dimensions[s] == 1) {
            const bool is_first = pair.kind == Closeness::edge_edge && s == 0;
            points[s] = point_along(own.edges[i].corner[0], own.edges[i].edge[0], is_first ? d.along_a : d.along_b,
                                    d.den, bodies.unit);
        } else {
            points[s] = point_along(other.vertices[j], own.faces[i].normal, -d.above, d.den, bodies.unit);
        }
    }
    closest.point_a = points[0];
    closest.point_b = points[1];
    return closest;
}

auto rank(const ExactClosest& c) {
    return std::tuple(c.kind, c.a.triangle, c.a.corner, c.b.triangle, c.b.corner, c.a.dimension);
}

}  // namespace

ExactClosest closest_features(const ConvexBodies& bodies) {
    std::optional<ExactClosest> first;
    for (const Candidate& candidate : candidates_of(bodies)) {
        const auto d = distance_of(candidate, bodies.exact);
        if (!d.is_inside) continue;
        if (first) {
            const int order = cmp(mpz_class(d.num * first->distance.den), mpz_class(first->distance.num * d.den));
            if (order > 0) continue;
            ExactClosest other = measured(candidate, d, bodies);
            if (order < 0 || rank(other) < rank(*first)) first = std::move(other);
        } else {
            first = measured(candidate, d, bodies);
        }
    }
    return *first;
}

namespace {

using Point = Vector<mpz_class>;

// The parts of a body that are furthest along a vector: all of its vertices, edges and faces whose corners are, and the
// corners seen along the vector, which are the products with it.
struct Seen {
    const ConvexBody<mpz_class>& body;
    std::vector<std::uint32_t> vertices, edges, faces;
    std::map<std::uint32_t, Point> at;  // by vertex

    Seen(const ConvexBodies& bodies, std::size_t side, const Point& out, const Point& along)
        : body(bodies.exact[side]), vertices(furthest(body, out)) {
        for (const std::uint32_t v : vertices) at[v] = cross(along, body.vertices[v]);
        const auto is_seen = [&](const auto& corners) {
            return std::ranges::all_of(corners, [&](std::uint32_t v) { return at.contains(v); });
        };
        const ConvexFeatures& features = bodies.features[side];
        for (std::uint32_t e = 0; e < features.edges.size(); ++e) {
            if (is_seen(features.edges[e].ends)) edges.push_back(e);
        }
        for (std::uint32_t f = 0; f < features.faces.size(); ++f) {
            if (is_seen(features.faces[f].corners)) faces.push_back(f);
        }
    }
};

// Where a point is strictly between two others, as a part of the way.
std::optional<ExactFraction> part_between(const Point& p, const Point& from, const Point& to) {
    const Point way = to - from, w = p - from;
    const mpz_class along = dot(w, way), all = square_of(way);
    if (sgn(square_of(cross(w, way))) != 0 || sgn(along) <= 0 || along >= all) return std::nullopt;
    return ExactFraction{along, all, 0};
}

bool is_strictly_inside(const Point& p, const std::vector<Point>& polygon, const Point& normal) {
    int side = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Point &from = polygon[i], &to = polygon[(i + 1) % polygon.size()];
        const int sign = sgn(dot(cross(Point(to - from), Point(p - from)), normal));
        if (sign == 0 || sign * side < 0) return false;
        side = sign;
    }
    return true;
}

// Where two segments cross in their insides, as parts of both ways.
std::optional<std::array<ExactFraction, 2>> parts_of_crossing(const Point& p, const Point& p_to, const Point& q,
                                                              const Point& q_to) {
    const Point u = p_to - p, v = q_to - q, w = q - p, turn = cross(u, v);
    const mpz_class all = square_of(turn);
    const mpz_class s = dot(cross(w, v), turn), t = dot(cross(w, u), turn);
    if (sgn(all) == 0 || sgn(s) <= 0 || s >= all || sgn(t) <= 0 || t >= all) return std::nullopt;
    return std::array<ExactFraction, 2>{{{s, all, 0}, {t, all, 0}}};
}

// All pairs of features of which each has a point that the translation along a facet's normal brings to the other's.
class Deepest {
  public:
    Deepest(const ConvexBodies& bodies, const DifferenceFacet& facet)
        : bodies_(bodies),
          n_(facet.normal),
          seen_{Seen(bodies, 0, n_, n_), Seen(bodies, 1, scaled(n_, -1), n_)},
          depth_{facet.height * facet.height, facet.square, bodies.unit} {}

    ExactClosest first() {
        for (const std::uint32_t v : seen_[0].vertices) {
            for (const std::uint32_t w : seen_[1].vertices) {
                if (seen_[0].at[v] != seen_[1].at[w]) continue;
                take(Closeness::vertex_vertex, {0, 0}, {v, w}, {vertex(0, v), vertex(1, w)});
            }
        }
        for (const std::size_t side : {0U, 1U}) {
            for (const std::uint32_t v : seen_[side].vertices) add_vertex(side, v);
        }
        for (const std::uint32_t e : seen_[0].edges) {
            for (const std::uint32_t f : seen_[1].edges) {
                const auto &p = bodies_.features[0].edges[e].ends, &q = bodies_.features[1].edges[f].ends;
                const auto parts =
                    parts_of_crossing(seen_[0].at[p[0]], seen_[0].at[p[1]], seen_[1].at[q[0]], seen_[1].at[q[1]]);
                if (parts) take(Closeness::edge_edge, {1, 1}, {e, f}, {on(0, p, (*parts)[0]), on(1, q, (*parts)[1])});
            }
        }
        return *first_;
    }

  private:
    // With the insides of edges and of the face of the other body.
    void add_vertex(std::size_t side, std::uint32_t v) {
        const std::size_t other = 1 - side;
        const auto add = [&](Closeness kind, std::uint32_t feature, const ExactPoint& point) {
            const int dimension = kind == Closeness::vertex_edge ? 1 : 2;
            if (side == 0) take(kind, {0, dimension}, {v, feature}, {vertex(0, v), point});
            if (side == 1) take(kind, {dimension, 0}, {feature, v}, {point, vertex(1, v)});
        };
        for (const std::uint32_t e : seen_[other].edges) {
            const auto& ends = bodies_.features[other].edges[e].ends;
            const auto part = part_between(seen_[side].at[v], seen_[other].at[ends[0]], seen_[other].at[ends[1]]);
            if (part) add(Closeness::vertex_edge, e, on(other, ends, *part));
        }
        for (const std::uint32_t f : seen_[other].faces) {
            const auto& corners = bodies_.features[other].faces[f].corners;
            std::vector<Point> polygon;
            for (const std::uint32_t corner : corners) polygon.push_back(seen_[other].at[corner]);
            if (!is_strictly_inside(seen_[side].at[v], polygon, n_)) continue;
            const Point &from = bodies_.exact[side].vertices[v], &to = bodies_.exact[other].vertices[corners[0]];
            const mpz_class above = dot(n_, Point(to - from));
            add(Closeness::vertex_face, f, point_along(from, n_, above, square_of(n_), bodies_.unit));
        }
    }

    ExactPoint vertex(std::size_t side, std::uint32_t v) const {
        const Point& p = bodies_.exact[side].vertices[v];
        return point_along(p, p, 0, 1, bodies_.unit);
    }
    ExactPoint on(std::size_t side, const std::array<std::uint32_t, 2>& ends, const ExactFraction& part) const {
        const Point &from = bodies_.exact[side].vertices[ends[0]], &to = bodies_.exact[side].vertices[ends[1]];
        return point_along(from, to - from, part.num, part.den, bodies_.unit);
    }

    void take(Closeness kind, const std::array<int, 2>& dimensions, const std::array<std::uint32_t, 2>& index,
              const std::array<ExactPoint, 2>& points) {
        ExactClosest found{depth_,
                           kind,
                           name_of(bodies_.features[0], dimensions[0], index[0]),
                           name_of(bodies_.features[1], dimensions[1], index[1]),
                           points[0],
                           points[1]};
        if (!first_ || rank(found) < rank(*first_)) first_ = std::move(found);
    }

    const ConvexBodies& bodies_;
    const Point& n_;
    std::array<Seen, 2> seen_;
    ExactRoot depth_;
    std::optional<ExactClosest> first_;
};

}  // namespace

ExactClosest deepest_features(const ConvexBodies& bodies, const DifferenceFacet& facet) {
    return Deepest(bodies, facet).first();
}

}  // namespace ecods::oracle
