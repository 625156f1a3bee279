#include "oracle/solid_points.hpp"

#include <algorithm>

namespace ecods::oracle {

RationalPoint posed(const Pose& pose, const Vec3& v) {
    RationalPoint point;
    for (int k = 0; k < 3; ++k) {
        mpq_class sum = pose.t[k];
        for (int i = 0; i < 3; ++i) sum += mpq_class(pose.R(k, i)) * mpq_class(v[i]);
        point[static_cast<std::size_t>(k)] = sum;
    }
    return point;
}

namespace {

bool has_own_area(const std::array<Vec3, 3>& v) {
    const auto exact = [](const Vec3& x) { return RationalPoint{mpq_class(x[0]), mpq_class(x[1]), mpq_class(x[2])}; };
    const RationalPoint a = exact(v[0]);
    const RationalPoint normal = cross(RationalPoint(exact(v[1]) - a), RationalPoint(exact(v[2]) - a));
    return std::ranges::any_of(normal, [](const mpq_class& x) { return sgn(x) != 0; });
}

}  // namespace

bool has_area(const Mesh& mesh, std::uint32_t triangle) {
    const auto& [a, b, c] = mesh.triangles()[triangle];
    const auto vertices = mesh.vertices();
    return has_own_area({vertices[a], vertices[b], vertices[c]});
}

mpz_class determinant(const SolidPoint& u, const SolidPoint& v, const SolidPoint& w) {
    return dot(u, cross(v, w));
}

bool boxes_are_apart(const IntegerTriangle& a, const IntegerTriangle& b) {
    for (std::size_t k = 0; k < 3; ++k) {
        if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) return true;
    }
    return false;
}

bool is_singular(const Pose& pose) {
    const auto row = [&](int k) {
        return RationalPoint{mpq_class(pose.R(k, 0)), mpq_class(pose.R(k, 1)), mpq_class(pose.R(k, 2))};
    };
    return sgn(dot(row(0), cross(row(1), row(2)))) == 0;
}

std::vector<std::vector<IntegerTriangle>> integer_triangles(std::span<const SoupChoice> soups) {
    std::vector<std::vector<RationalPoint>> points(soups.size());
    mpz_class unit = 1;  // denominators are powers of two: the greatest is a multiple of all
    for (std::size_t s = 0; s < soups.size(); ++s) {
        for (const Vec3& v : soups[s].soup->vertices) {
            points[s].push_back(posed(soups[s].soup->pose, v));
            for (const mpq_class& x : points[s].back()) unit = std::max(unit, mpz_class(x.get_den()));
        }
    }
    std::vector<std::vector<IntegerTriangle>> all(soups.size());
    for (std::size_t s = 0; s < soups.size(); ++s) {
        const Soup& soup = *soups[s].soup;
        for (std::uint32_t i = 0; i < soup.triangles.size(); ++i) {
            IntegerTriangle triangle;
            triangle.index = i;
            for (std::size_t c = 0; c < 3; ++c) {
                const std::uint32_t vertex = soup.triangles[i][c];
                triangle.vertices[c] = soup.vertices[vertex];
                for (std::size_t k = 0; k < 3; ++k) {
                    const mpq_class& x = points[s][vertex][k];
                    triangle.corners[c][k] = x.get_num() * (unit / x.get_den());
                }
            }
            if (!soups[s].takes_zero_area && !has_own_area(triangle.vertices)) continue;
            const SolidPoint& a = triangle.corners[0];
            triangle.normal = cross(SolidPoint(triangle.corners[1] - a), SolidPoint(triangle.corners[2] - a));
            triangle.low = triangle.high = a;
            for (std::size_t k = 0; k < 3; ++k) {
                for (const SolidPoint& corner : triangle.corners) {
                    if (corner[k] < triangle.low[k]) triangle.low[k] = corner[k];
                    if (corner[k] > triangle.high[k]) triangle.high[k] = corner[k];
                }
            }
            all[s].push_back(std::move(triangle));
        }
    }
    return all;
}

}  // namespace ecods::oracle
