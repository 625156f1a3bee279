#include "oracle/convex_facets.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "oracle/integer_points.hpp"

namespace ecods::oracle {
namespace {

using Point = Vector<mpz_class>;

template <class N>
ConvexBody<N> body_of(const ConvexFeatures& features, const std::vector<Vector<N>>& points) {
    ConvexBody<N> body;
    for (const auto& vertex : features.vertices) body.vertices.push_back(points[vertex.in_mesh]);
    for (const auto& edge : features.edges) {
        const Vector<N>&from = body.vertices[edge.ends[0]], &to = body.vertices[edge.ends[1]];
        body.edges.push_back(TriangleOf<N>({from, to, from}));
    }
    for (const auto& face : features.faces) {
        auto& made = body.faces.emplace_back();
        for (const std::uint32_t corner : face.corners) made.corners.push_back(body.vertices[corner]);
        made.normal = cross(Vector<N>(made.corners[1] - made.corners[0]), Vector<N>(made.corners[2] - made.corners[0]));
    }
    return body;
}

// Returns true if the face's corners are clockwise, seen from outside: some vertex is above it. A polygon's are not.
bool is_turned_in(const ConvexBody<mpz_class>& body, const ConvexBody<mpz_class>::Face& face) {
    for (const Point& p : body.vertices) {
        const int sign = sgn(dot(face.normal, Point(p - face.corners[0])));
        if (sign != 0) return sign > 0;
    }
    return false;
}

template <class N>
void turn(typename ConvexBody<N>::Face& face) {
    std::ranges::reverse(face.corners);
    for (N& x : face.normal) x = -x;
}

// Whether the ends of the edge are the only vertices that are furthest along the normal. `side` is 1 or -1: the
// normal's factor.
template <class N>
bool may_be_furthest(const ConvexBody<N>& body, const Vector<N>& from, const std::array<std::uint32_t, 2>& ends,
                     const Vector<N>& normal, bool is_negative) {
    for (std::uint32_t v = 0; v < body.vertices.size(); ++v) {
        if (v == ends[0] || v == ends[1]) continue;
        const N below = dot(normal, Vector<N>(from - body.vertices[v]));
        if (!may_be_positive(is_negative ? N(-below) : below)) return false;
    }
    return true;
}

template <class N>
bool may_be_facet(const ConvexBodies& bodies, const std::array<ConvexBody<N>, 2>& in, std::uint32_t i, std::uint32_t j,
                  const Vector<N>& normal, bool is_negative) {
    return may_be_furthest(in[0], in[0].edges[i].corner[0], bodies.features[0].edges[i].ends, normal, is_negative) &&
           may_be_furthest(in[1], in[1].edges[j].corner[0], bodies.features[1].edges[j].ends, normal, !is_negative);
}

mpz_class height_along(const ConvexBodies& bodies, const Point& normal) {
    Point back = normal;
    for (mpz_class& x : back) x = -x;
    const Point& p = bodies.exact[0].vertices[furthest(bodies.exact[0], normal).front()];
    const Point& q = bodies.exact[1].vertices[furthest(bodies.exact[1], back).front()];
    return dot(normal, Point(p - q));
}

DifferenceFacet make_facet(DifferenceFacet::Kind kind, std::uint32_t a, std::uint32_t b, const Point& normal,
                           const ConvexBodies& bodies) {
    return {kind, a, b, normal, height_along(bodies, normal), square_of(normal)};
}

}  // namespace

ConvexBodies::ConvexBodies(const std::array<const Mesh*, 2>& meshes, const std::array<Pose, 2>& poses) {
    const IntegerPoints points({meshes[0]->vertices(), meshes[0]->triangles(), poses[0]},
                               {meshes[1]->vertices(), meshes[1]->triangles(), poses[1]});
    unit = points.unit;
    for (std::size_t s = 0; s < 2; ++s) {
        auto found = convex_features(*meshes[s]);
        if (!found) throw std::logic_error("not convex");
        features[s] = std::move(*found);
        exact[s] = body_of(features[s], points.exact[s]);
        around[s] = body_of(features[s], points.around[s]);
        for (std::size_t f = 0; f < exact[s].faces.size(); ++f) {
            if (!is_turned_in(exact[s], exact[s].faces[f])) continue;
            turn<mpz_class>(exact[s].faces[f]);
            turn<Interval>(around[s].faces[f]);
        }
    }
}

std::vector<std::uint32_t> furthest(const ConvexBody<mpz_class>& body, const Point& along) {
    std::vector<std::uint32_t> found;
    mpz_class best;
    for (std::uint32_t v = 0; v < body.vertices.size(); ++v) {
        const mpz_class height = dot(along, body.vertices[v]);
        const int order = found.empty() ? 1 : cmp(height, best);
        if (order > 0) {
            found.clear();
            best = height;
        }
        if (order >= 0) found.push_back(v);
    }
    return found;
}

int DifferenceFacet::compare(const DifferenceFacet& other) const {
    const int sign = sgn(height), other_sign = sgn(other.height);
    if (sign != other_sign) return sign < other_sign ? -1 : 1;
    const mpz_class own = height * height * other.square, others = other.height * other.height * square;
    return sign * cmp(own, others);
}

namespace {

Point negative(Point v) {
    for (mpz_class& x : v) x = -x;
    return v;
}

// The first product of a vector and an axis that is not zero.
Point across(const Point& u) {
    for (std::size_t k = 0; k < 3; ++k) {
        Point axis;
        axis[k] = 1;
        if (Point n = cross(u, axis); sgn(square_of(n)) != 0) return n;
    }
    throw std::logic_error("an edge without length");
}

// Both normals of a polygon: first the one along which the other body has the first feature.
std::array<Point, 2> normals_of_polygon(const ConvexBodies& bodies, std::size_t side) {
    const Point& n = bodies.exact[side].faces[0].normal;
    const std::size_t other = 1 - side;
    const auto feature = [&](const Point& along) {
        const NamedFeature& name = bodies.features[other].name_of(furthest(bodies.exact[other], along));
        return std::tuple(name.dimension, name.triangle, name.corner);
    };
    // The other body lies against the first one's normal.
    if (feature(negative(n)) <= feature(n)) return {n, negative(n)};
    return {negative(n), n};
}

void add_face_normals(const ConvexBodies& bodies, std::size_t side, std::vector<DifferenceFacet>& facets) {
    using Kind = DifferenceFacet::Kind;
    const ConvexBody<mpz_class>& body = bodies.exact[side];
    const auto add = [&](std::uint32_t f, const Point& out) {
        if (side == 0) facets.push_back(make_facet(Kind::face_of_a, f, 0, out, bodies));
        if (side == 1) facets.push_back(make_facet(Kind::face_of_b, 0, f, negative(out), bodies));
    };
    if (body.is_flat() && !body.faces.empty()) {
        for (const Point& out : normals_of_polygon(bodies, side)) add(0, out);
        return;
    }
    for (std::uint32_t f = 0; f < body.faces.size(); ++f) add(f, body.faces[f].normal);
}

}  // namespace

// Tries all triples of differences from the first vertices.
std::optional<Point> normal_of_flat_difference(const ConvexBodies& bodies) {
    if (!bodies.exact[0].is_flat() || !bodies.exact[1].is_flat()) return std::nullopt;
    std::vector<Point> ways;
    for (const auto& body : bodies.exact) {
        for (const Point& p : body.vertices) ways.push_back(p - body.vertices[0]);
    }
    for (const Point& u : ways) {
        for (const Point& v : ways) {
            const Point n = cross(u, v);
            if (std::ranges::any_of(ways, [&](const Point& w) { return sgn(dot(n, w)) != 0; })) return std::nullopt;
        }
    }
    for (const auto& body : bodies.exact) {
        if (!body.faces.empty()) return body.faces[0].normal;
    }
    std::optional<Point> edge;
    for (const auto& body : bodies.exact) {
        if (body.edges.empty()) continue;
        const Point& way = body.edges[0].edge[0];
        if (edge && sgn(square_of(cross(*edge, way))) != 0) return cross(*edge, way);
        if (!edge) edge = way;
    }
    return edge ? across(*edge) : Point{1, 0, 0};
}

std::vector<DifferenceFacet> difference_facets(const ConvexBodies& bodies) {
    using Kind = DifferenceFacet::Kind;
    const auto& [a, b] = bodies.exact;
    std::vector<DifferenceFacet> facets;
    if (const auto n = normal_of_flat_difference(bodies)) {
        for (const Point& normal : {*n, negative(*n)}) {
            facets.push_back(make_facet(Kind::edges, 0, 0, normal, bodies));
        }
        return facets;
    }
    add_face_normals(bodies, 0, facets);
    add_face_normals(bodies, 1, facets);
    for (std::uint32_t i = 0; i < a.edges.size(); ++i) {
        for (std::uint32_t j = 0; j < b.edges.size(); ++j) {
            const Vector<Interval> around = cross(bodies.around[0].edges[i].edge[0], bodies.around[1].edges[j].edge[0]);
            for (const bool is_negative : {false, true}) {
                if (!may_be_facet(bodies, bodies.around, i, j, around, is_negative)) continue;
                Point normal = cross(a.edges[i].edge[0], b.edges[j].edge[0]);
                if (!may_be_facet(bodies, bodies.exact, i, j, normal, is_negative)) continue;
                if (is_negative) {
                    for (mpz_class& x : normal) x = -x;
                }
                facets.push_back(make_facet(Kind::edges, i, j, normal, bodies));
            }
        }
    }
    return facets;
}

}  // namespace ecods::oracle
