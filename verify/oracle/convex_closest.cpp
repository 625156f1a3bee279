#include <algorithm>
#include <limits>
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

}  // namespace ecods::oracle
