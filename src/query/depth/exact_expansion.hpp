// ExactExpansion grows the polytope that exact_depth.hpp describes, in integers of L limbs.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "exact/measure/round/direction.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "query/depth/border_edges.hpp"
#include "query/depth/exact_depth.hpp"
#include "query/depth/exact_differences.hpp"

namespace ecods::depths {

// An ExactPlane is a plane n . x = h through vertices of the Minkowski difference.
template <int L>
struct ExactPlane {
    exact::LimbVector<2 * L> n;
    exact::Magnitude<3 * L> h;
    exact::Magnitude<4 * L> nn;
    int side = 0;               // sign of h
    exact::LeadingDigits near;  // leading 127 digits of h^2 / n.n

    using Point = typename ExactDifferences<L>::Point;

    ExactPlane(const Point& a, const Point& b, const Point& c) noexcept {
        n = exact::cross<L>(exact::difference<L>(b, a), exact::difference<L>(c, a));
        h = exact::dot<2 * L, L>(n, exact::difference<L>(a, Point{}));
        nn = exact::dot<2 * L, 2 * L>(n, n);
        side = exact::sign<3 * L>(h);
        const auto hh = exact::multiply<3 * L, 3 * L>(h.limbs, h.limbs);
        near = exact::leading_digits(exact::without_leading_zeros(hh), exact::without_leading_zeros(nn.limbs));
        // Shortens 128 digits to 127, so that all planes have equally many digits, and the order of the digits is the
        // order of the quotients. is_exact stays true only if no nonzero digit is dropped.
        if (near.digits >> 127 != 0) {
            near.is_exact &= (near.digits & 1) == 0;
            near.digits >>= 1;
            ++near.exponent;
        }
    }

    // Returns the sign of n . x - h.
    int sign_at(const Point& x) const noexcept {
        const auto along = exact::dot<2 * L, L>(n, exact::difference<L>(x, Point{}));
        return exact::sign<3 * L>(exact::minus<3 * L>(along, h));
    }

    exact::SquaredDistance square(int unit) const noexcept {
        exact::SquaredDistance result;
        result.num.assign(exact::multiply<3 * L, 3 * L>(h.limbs, h.limbs));
        result.den.assign(nn.limbs);
        result.exponent = unit;
        return result;
    }
};

// Returns the sign of (distance of plane x from the origin) - (distance of plane y). A distance is signed: it is
// measured along the plane's normal.
template <int L>
int compare(const ExactPlane<L>& x, const ExactPlane<L>& y) noexcept {
    if (x.side != y.side) return x.side < y.side ? -1 : 1;
    if (x.side == 0) return 0;
    const auto further = [&](int sign) { return x.side < 0 ? -sign : sign; };
    if (x.near.exponent != y.near.exponent) return further(x.near.exponent < y.near.exponent ? -1 : 1);
    // The dropped digits are less than one unit in the last place, so different leading digits decide.
    if (x.near.digits != y.near.digits) return further(x.near.digits < y.near.digits ? -1 : 1);
    if (x.near.is_exact && y.near.is_exact) return 0;
    return further(exact::compare(x.square(0), y.square(0)));
}

// NearestFirst orders planes by their distances from the origin.
template <int L>
struct NearestFirst {
    int operator()(const ExactPlane<L>& x, const ExactPlane<L>& y) const noexcept { return compare(x, y); }
};

// ExactExpansion finds the face of the Minkowski difference that is first in an order of planes. The order must put
// planes that have the origin beyond them first, and all faces that tie at the end must contain a common point of the
// border.
template <int L, class Order = NearestFirst<L>>
class ExactExpansion {
  public:
    explicit ExactExpansion(const ExactDifferences<L>& points, const Order& order = {})
        : points_(points), compare_(order) {}

    struct Found {
        DifferenceFace face;
        const ExactPlane<L>* plane;  // valid as long as the expansion lives
    };
    // Returns the face that is first in the order; by order_of(), if several are equal; nullopt if the solids share no
    // point.
    std::optional<Found> find() {
        begin();
        std::optional<std::size_t> nearest;
        while ((nearest = next_face())) {
            const DifferenceVertex w = furthest(faces_[*nearest].plane.n, faces_[*nearest].corners[0]);
            const Point m = points_.difference(w);
            if (faces_[*nearest].plane.sign_at(m) == 0) {
                faces_[*nearest].is_final = true;
                if (faces_[*nearest].plane.side < 0) return std::nullopt;
            } else {
                add(w, m);
            }
        }
        return first_of_nearest();
    }

  private:
    using Point = typename ExactDifferences<L>::Point;
    using Normal = typename ExactDifferences<L>::Normal;
    using Corners = std::array<std::uint32_t, 3>;

    struct Face {
        Corners at;  // indices of vertices_, counterclockwise seen from outside
        std::array<DifferenceVertex, 3> corners;
        ExactPlane<L> plane;
        bool is_final = false;  // true if the face is in the plane of a face of the whole difference
    };

    DifferenceVertex furthest(const Normal& n, const DifferenceVertex& from) const {
        return {points_.furthest(0, n, from.p).vertex, points_.furthest(1, n, from.q).vertex};
    }

    // Sets the polytope to a tetrahedron of four points of the Minkowski difference that are not in one plane.
    void begin() {
        points_.hull(0).is_flat() ? add_spanning() : add_beside_face();
        const bool is_above = ExactPlane<L>(points_at_[0], points_at_[1], points_at_[2]).sign_at(points_at_[3]) > 0;
        const std::uint32_t b = is_above ? 2 : 1, c = is_above ? 1 : 2;
        add_face({0, b, c});
        add_face({0, c, 3});
        add_face({c, b, 3});
        add_face({b, 0, 3});
    }

    // Adds three vertices of a face of the first solid and a vertex off that face, each minus the same vertex of the
    // second solid.
    void add_beside_face() {
        const convex::Hull& hull = points_.hull(0);
        const auto cycle = hull.cycle_of(0);
        for (std::size_t i = 0; i < 3; ++i) add_vertex({cycle[i].vertex, 0});
        const auto beside = std::ranges::find_if(
            hull.neighbors_of(cycle[0].vertex),
            [&](const convex::Hull::Neighbor& neighbor) { return !convex::is_edge_of(hull, neighbor.edge, 0); });
        add_vertex({beside->vertex, 0});
    }

    // Adds four vertices for a flat first solid: vertices of the first solid minus one vertex of the second, then one
    // vertex of the first minus vertices of the second. Together they span the difference.
    void add_spanning() {
        add_vertex({0, 0});
        for (const std::size_t side : {0, 1}) {
            for (std::uint32_t v = 1; v < points_.hull(side).vertex_count() && vertices_.size() < 4; ++v) {
                const DifferenceVertex next = side == 0 ? DifferenceVertex{v, 0} : DifferenceVertex{0, v};
                if (leaves_span(points_.difference(next))) add_vertex(next);
            }
        }
    }

    // Returns true if m is not in the span of the vertices so far, of which there are up to three: not on the line of
    // two, and not in the plane of three. m must be none of the vertices.
    bool leaves_span(const Point& m) const noexcept {
        const std::vector<Point>& at = points_at_;
        if (at.size() == 1) return true;
        if (at.size() == 2)
            return !exact::is_parallel<L>(exact::difference<L>(at[1], at[0]), exact::difference<L>(m, at[0]));
        return ExactPlane<L>(at[0], at[1], at[2]).sign_at(m) != 0;
    }

    std::uint32_t add_vertex(const DifferenceVertex& v) {
        vertices_.push_back(v);
        points_at_.push_back(points_.difference(v));
        return static_cast<std::uint32_t>(vertices_.size() - 1);
    }

    void add_face(const Corners& at) {
        faces_.push_back({at,
                          {vertices_[at[0]], vertices_[at[1]], vertices_[at[2]]},
                          ExactPlane<L>(points_at_[at[0]], points_at_[at[1]], points_at_[at[2]])});
    }

    // Returns a nearest face that is not final; nullopt if all nearest faces are final.
    std::optional<std::size_t> next_face() const noexcept {
        std::size_t nearest = 0;
        for (std::size_t i = 1; i < faces_.size(); ++i) {
            const int sign = compare_(faces_[i].plane, faces_[nearest].plane);
            if (sign < 0 || (sign == 0 && !faces_[i].is_final)) nearest = i;
        }
        if (faces_[nearest].is_final) return std::nullopt;
        return nearest;
    }

    // Adds a vertex w, at the point m, that is strictly outside the polytope. Faces that w is strictly beyond are
    // replaced by triangles that join w to their border. Faces whose plane contains w stay. A new triangle at such a
    // face has an area, too: w is strictly beyond the face on the other side of the border edge, and so not on the line
    // of that edge.
    void add(const DifferenceVertex& w, const Point& m) {
        const std::uint32_t apex = add_vertex(w);
        std::uint32_t border_count = 0;
        std::erase_if(faces_, [&](const Face& face) {
            if (face.plane.sign_at(m) <= 0) return false;
            border_.resize(border_count + 3);
            border_count = add_edges(face.at, border_.data(), border_count);
            return true;
        });
        for (std::uint32_t i = 0; i < border_count; ++i)
            add_face({static_cast<std::uint32_t>(border_[i] >> 32), static_cast<std::uint32_t>(border_[i]), apex});
    }

    Found first_of_nearest() const {
        const Face* nearest = nullptr;
        for (const Face& face : faces_) {
            if (nearest == nullptr || compare_(face.plane, nearest->plane) < 0) nearest = &face;
        }
        const Face* first = nullptr;
        DifferenceFace names;
        for (const Face& face : faces_) {
            if (compare_(face.plane, nearest->plane) != 0) continue;
            const DifferenceFace other = names_of(face);
            if (first != nullptr && order_of(other, names) >= 0) continue;
            first = &face;
            names = other;
        }
        return {names, &first->plane};
    }

    // Returns the features of both solids that form a final face. The face's corners are extreme along its normal.
    DifferenceFace names_of(const Face& face) const {
        const auto feature = [&](std::size_t side) {
            const convex::Furthest furthest = points_.furthest(side, face.plane.n, face.corners[0].of(side));
            return furthest.level.feature(points_.hull(side), furthest.vertex);
        };
        return {feature(0), feature(1)};
    }

    ExactDifferences<L> points_;
    Order compare_;
    std::vector<DifferenceVertex> vertices_;
    std::vector<Point> points_at_;  // by vertex
    std::vector<Face> faces_;
    std::vector<BorderEdge> border_;
};

}  // namespace ecods::depths
