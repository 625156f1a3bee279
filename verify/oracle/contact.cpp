#include "oracle/contact.hpp"

#include <algorithm>
#include <array>

namespace ecods::oracle {
namespace {

// (p - corner) times the denominator of p.
Vector<mpz_class> from(const Vector<mpz_class>& corner, const IntegerPoint& p) {
    Vector<mpz_class> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = p.num[k] - corner[k] * p.den;
    return result;
}

// (q - p) times both denominators.
Vector<mpz_class> from(const IntegerPoint& p, const IntegerPoint& q) {
    Vector<mpz_class> result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = q.num[k] * p.den - p.num[k] * q.den;
    return result;
}

bool is_zero(const Vector<mpz_class>& v) {
    return sgn(v[0]) == 0 && sgn(v[1]) == 0 && sgn(v[2]) == 0;
}

IntegerPoint middle_of(const std::vector<IntegerPoint>& points) {
    IntegerPoint sum{{0, 0, 0}, 1};
    for (const IntegerPoint& p : points) {
        for (std::size_t k = 0; k < 3; ++k) sum.num[k] = sum.num[k] * p.den + p.num[k] * sum.den;
        sum.den *= p.den;
    }
    sum.den *= static_cast<unsigned long>(points.size());
    return sum;
}

}  // namespace

Contact::Contact(const TriangleOf<mpz_class>& a, const TriangleOf<mpz_class>& b)
    : a_(a), b_(b), corners_(shared_corners(a, b)), middle_(middle_of(corners_)) {
    if (corners_.size() > 2) sort_around();
}

// The next corner is the one that has all others on its left.
void Contact::sort_around() {
    for (std::size_t at = 1; at < corners_.size(); ++at) {
        const auto has_all_on_the_left = [&](const IntegerPoint& next) {
            const Vector<mpz_class> along = from(corners_[at - 1], next);
            return std::ranges::all_of(corners_, [&](const IntegerPoint& other) {
                return sgn(dot(cross(along, from(corners_[at - 1], other)), a_.normal)) >= 0;
            });
        };
        const auto rest = corners_.begin() + static_cast<std::ptrdiff_t>(at);
        std::iter_swap(rest, std::find_if(rest, corners_.end(), has_all_on_the_left));
    }
}

bool Contact::is_in_one_plane() const {
    std::vector<Vector<mpz_class>> edges;
    for (std::size_t k = 0; k < 3; ++k) {
        edges.push_back(a_.edge[k]);
        edges.push_back(b_.edge[k]);
    }
    edges.push_back(b_.corner[0] - a_.corner[0]);
    for (const auto& u : edges) {
        for (const auto& v : edges) {
            for (const auto& w : edges) {
                if (sgn(dot(cross(u, v), w)) != 0) return false;
            }
        }
    }
    return true;
}

// What is shared is convex, and its middle is in no lower part of a triangle than all of it.
Contact::Holder Contact::holder(const TriangleOf<mpz_class>& triangle) const {
    for (std::size_t i = 0; i < 3; ++i) {
        if (is_zero(from(triangle.corner[i], middle_))) return {0, i};
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const Vector<mpz_class> p = from(triangle.corner[i], middle_);
        const mpz_class along = dot(p, triangle.edge[i]);
        if (is_zero(cross(p, triangle.edge[i])) && sgn(along) > 0 && along < triangle.edge_square[i] * middle_.den) {
            return {1, i};
        }
    }
    return {2, 0};
}

bool Contact::is_crossing() const {
    if (is_in_one_plane()) return false;
    return std::ranges::all_of(std::array{&a_, &b_}, [&](const TriangleOf<mpz_class>* triangle) {
        const Holder inside = holder(*triangle);
        if (sgn(triangle->normal_square) != 0) return inside.dimension == 2;
        // Of a segment the ends are not inside; a point is inside itself.
        const auto is_end = [&](const Vector<mpz_class>& end) { return is_zero(from(end, middle_)); };
        const auto [least, most] = std::ranges::minmax(triangle->corner);
        return least == most || (!is_end(least) && !is_end(most));
    });
}

std::vector<std::size_t> Contact::features() const {
    std::vector<std::size_t> found;
    const auto pairs = feature_pairs();
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const FeatureDistance<mpz_class> d = feature_distance(pairs[i], a_, b_);
        if (d.is_inside && sgn(d.num) == 0) found.push_back(i);
    }
    return found;
}

std::optional<Vector<mpz_class>> Contact::normal() const {
    if (is_crossing()) return std::nullopt;
    if (corners_.size() > 2) return a_.normal;
    const Holder in_a = holder(a_), in_b = holder(b_);
    if (in_a.dimension == 2 && in_b.dimension < 2) return a_.normal;
    if (in_b.dimension == 2 && in_a.dimension < 2) return b_.normal;
    if (in_a.dimension != 1 || in_b.dimension != 1) return std::nullopt;
    const Vector<mpz_class> n = cross(a_.edge[in_a.index], b_.edge[in_b.index]);
    if (is_zero(n)) return std::nullopt;
    return n;
}

std::optional<Vector<mpz_class>> direction(const FeaturePair& pair, const TriangleOf<mpz_class>& a,
                                           const TriangleOf<mpz_class>& b) {
    const std::array<IntegerPoint, 2> ends = closest_points(pair, a, b);
    const Vector<mpz_class> gap = from(ends[0], ends[1]);
    if (!is_zero(gap)) return gap;
    if (pair.kind == Closeness::vertex_face) return pair.dimension_a == 2 ? a.normal : b.normal;
    if (pair.kind == Closeness::edge_edge) return cross(a.edge[pair.a], b.edge[pair.b]);
    return std::nullopt;
}

}  // namespace ecods::oracle
