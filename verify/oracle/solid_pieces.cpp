#include "oracle/solid_pieces.hpp"

#include <algorithm>
#include <tuple>

namespace ecods::oracle {
namespace {

// The points x with normal . x = offset.
struct Plane {
    SolidPoint normal;
    mpz_class offset;

    Plane(const SolidPoint& n, const SolidPoint& through) : normal(n), offset(dot(n, through)) {}

    mpq_class height(const RationalPoint& x) const {
        mpq_class sum = -offset;
        for (std::size_t k = 0; k < 3; ++k) sum += mpq_class(normal[k]) * x[k];
        return sum;
    }
    int side(const SolidPoint& x) const { return sgn(mpz_class(dot(normal, x) - offset)); }
    // Whether all three corners are strictly on one side.
    bool misses(const IntegerTriangle& t) const {
        const int first = side(t.corners[0]);
        return first != 0 && first == side(t.corners[1]) && first == side(t.corners[2]);
    }
};

void cut(std::vector<RationalPolygon>& polygons, const Plane& plane) {
    std::vector<RationalPolygon> halves;
    for (RationalPolygon& polygon : polygons) {
        std::vector<mpq_class> heights;
        for (const RationalPoint& corner : polygon) heights.push_back(plane.height(corner));
        const auto [low, high] = std::ranges::minmax(heights);
        if (sgn(low) >= 0 || sgn(high) <= 0) {
            halves.push_back(std::move(polygon));
            continue;
        }
        RationalPolygon above, below;
        // A segment has one side, a polygon as many as corners.
        const std::size_t side_count = polygon.size() == 2 ? 1 : polygon.size();
        for (std::size_t i = 0; i < polygon.size(); ++i) {
            if (sgn(heights[i]) >= 0) above.push_back(polygon[i]);
            if (sgn(heights[i]) <= 0) below.push_back(polygon[i]);
            const std::size_t next = (i + 1) % polygon.size();
            if (i >= side_count || sgn(heights[i]) * sgn(heights[next]) >= 0) continue;
            const mpq_class s = heights[i] / (heights[i] - heights[next]);
            RationalPoint crossing;
            for (std::size_t k = 0; k < 3; ++k) crossing[k] = polygon[i][k] + s * (polygon[next][k] - polygon[i][k]);
            above.push_back(crossing);
            below.push_back(crossing);
        }
        halves.push_back(std::move(above));
        halves.push_back(std::move(below));
    }
    polygons = std::move(halves);
}

RationalPoint rational(const SolidPoint& p) {
    return {mpq_class(p[0]), mpq_class(p[1]), mpq_class(p[2])};
}

// Of a triangle without area the two corners that are furthest apart, or one of three equal ones.
RationalPolygon as_polygon(const IntegerTriangle& triangle) {
    const auto& c = triangle.corners;
    if (triangle.has_area()) return {rational(c[0]), rational(c[1]), rational(c[2])};
    const auto [low, high] = std::ranges::minmax(c);  // by coordinates: along a line, the ends
    if (low == high) return {rational(low)};
    return {rational(low), rational(high)};
}

HomogeneousPoint inner_point(const RationalPolygon& piece, Directions& directions) {
    RationalPoint sum{0, 0, 0};
    std::uint32_t weights = 0;
    for (const RationalPoint& corner : piece) {
        const std::uint32_t weight = directions.weight();
        weights += weight;
        for (std::size_t k = 0; k < 3; ++k) sum[k] += weight * corner[k];
    }
    HomogeneousPoint point;
    mpz_class common = 1;
    for (const mpq_class& x : sum) common = lcm(common, mpz_class(x.get_den()));
    for (std::size_t k = 0; k < 3; ++k) point.x[k] = sum[k].get_num() * (common / sum[k].get_den());
    point.denominator = common * weights;
    return point;
}

SolidPoint from(const HomogeneousPoint& point, const SolidPoint& corner) {
    return {point.denominator * corner[0] - point.x[0], point.denominator * corner[1] - point.x[1],
            point.denominator * corner[2] - point.x[2]};
}

// Two numbers that are the same for all points of a line of this direction: no coordinate of it is zero.
mpz_class across(const SolidPoint& direction, const SolidPoint& x, std::size_t k) {
    return direction[k + 1] * x[k] - direction[k] * x[k + 1];
}

}  // namespace

std::vector<RationalPolygon> pieces(const IntegerTriangle& triangle, const std::vector<IntegerTriangle>& others) {
    std::vector<RationalPolygon> result{as_polygon(triangle)};
    for (const IntegerTriangle& other : others) {
        if (!other.has_area() || boxes_are_apart(triangle, other)) continue;
        const Plane plane(other.normal, other.corners[0]);
        if (plane.misses(triangle)) continue;
        const bool is_in_plane = std::ranges::all_of(triangle.corners, [&](auto& c) { return plane.side(c) == 0; });
        if (!is_in_plane) {
            cut(result, plane);
            continue;
        }
        for (std::size_t c = 0; c < 3; ++c) {
            const SolidPoint edge = other.corners[(c + 1) % 3] - other.corners[c];
            cut(result, Plane(cross(other.normal, edge), other.corners[c]));
        }
    }
    return result;
}

void Directions::take_next() {
    for (mpz_class& x : current_) x = 1 + static_cast<long>(generator_() % 1000003);
}

void CrossedSurface::look_along(const SolidPoint& direction) {
    direction_ = direction;
    boxes_.clear();
    for (const IntegerTriangle& triangle : triangles_) {
        Box box;
        for (std::size_t k = 0; k < 2; ++k) {
            const auto [p, q, r] = triangle.corners;
            std::tie(box.low[k], box.high[k]) =
                std::minmax({across(direction, p, k), across(direction, q, k), across(direction, r, k)});
        }
        boxes_.push_back(std::move(box));
    }
}

std::optional<Crossings> CrossedSurface::count(const HomogeneousPoint& point, const SolidPoint& direction) {
    if (direction != direction_) look_along(direction);
    const std::array<mpz_class, 2> at{across(direction, point.x, 0), across(direction, point.x, 1)};
    const auto is_beside = [&](const Box& box) {
        for (std::size_t k = 0; k < 2; ++k) {
            if (at[k] < point.denominator * box.low[k] || at[k] > point.denominator * box.high[k]) return true;
        }
        return false;
    };
    Crossings count;
    for (std::size_t i = 0; i < triangles_.size(); ++i) {
        if (is_beside(boxes_[i])) continue;
        const IntegerTriangle& triangle = triangles_[i];
        // With s d = x u + y v + z w for the corners seen from the point: x = s [d v w] / [u v w], and x + y + z = 1.
        const SolidPoint u = from(point, triangle.corners[0]), v = from(point, triangle.corners[1]),
                         w = from(point, triangle.corners[2]);
        const SolidPoint vw = cross(v, w);
        const std::array<mpz_class, 3> parts{dot(direction, vw), dot(direction, cross(w, u)),
                                             dot(direction, cross(u, v))};
        const int slope = sgn(mpz_class(parts[0] + parts[1] + parts[2]));
        if (slope == 0) return std::nullopt;
        const auto [low, high] = std::minmax({sgn(parts[0]), sgn(parts[1]), sgn(parts[2])});
        if (low < 0 && high > 0) continue;  // beside the triangle
        const int height = sgn(dot(u, vw)) * slope;
        if (height == 0) {
            ++count.at;
        } else if (low == 0 || high == 0) {
            return std::nullopt;  // through an edge
        } else {
            ++(height > 0 ? count.after : count.before);
        }
    }
    return count;
}

Crossings count_one(const RationalPolygon& piece, CrossedSurface& surface, Directions& directions) {
    while (true) {
        const HomogeneousPoint point = inner_point(piece, directions);
        if (const auto crossings = surface.count(point, directions.current())) return *crossings;
        directions.take_next();
    }
}

std::pair<Crossings, Crossings> count_both(const RationalPolygon& piece, CrossedSurface& own, CrossedSurface& other,
                                           Directions& directions) {
    while (true) {
        const HomogeneousPoint point = inner_point(piece, directions);
        if (const auto of_own = own.count(point, directions.current())) {
            if (const auto of_other = other.count(point, directions.current())) return {*of_own, *of_other};
        }
        directions.take_next();
    }
}

}  // namespace ecods::oracle
