#include <algorithm>
#include <map>
#include <string>

#include "oracle/float_environment.hpp"
#include "oracle/solid.hpp"
#include "oracle/solid_points.hpp"

namespace ecods::oracle {
namespace {

std::vector<IntegerTriangle> own_triangles(const Mesh& mesh) {
    const Soup soup{mesh.vertices(), mesh.triangles(), Pose()};
    const SoupChoice choice{&soup, false};
    return std::move(integer_triangles({&choice, 1}).front());
}

// The same text for all edges of one line: its direction without common factor, the first coordinate that is not zero
// being positive, and its moment.
struct Line {
    std::string name;
    mpz_class from, to;  // the ends along it

    Line(const SolidPoint& p, const SolidPoint& q) {
        SolidPoint d = q - p;
        mpz_class divisor = gcd(gcd(d[0], d[1]), d[2]);
        const auto first = std::ranges::find_if(d, [](const mpz_class& x) { return sgn(x) != 0; });
        if (sgn(*first) < 0) divisor = -divisor;
        for (mpz_class& x : d) x /= divisor;
        const SolidPoint moment = cross(p, d);
        for (const SolidPoint& vector : {d, moment}) {
            for (const mpz_class& x : vector) name += x.get_str(36) + ' ';
        }
        from = dot(p, d);
        to = dot(q, d);
    }
};

// What the triangle and a plane share, if it is a segment, as numbers along the direction.
struct Interval {
    mpq_class low, high;
    bool is_side = false;  // of the triangle
    bool is_segment = false;
};

Interval on_plane(const IntegerTriangle& triangle, const IntegerTriangle& plane, const SolidPoint& direction) {
    std::array<mpz_class, 3> heights;
    std::vector<mpq_class> ends;
    int zero_count = 0;
    for (std::size_t c = 0; c < 3; ++c) {
        heights[c] = dot(plane.normal, SolidPoint(triangle.corners[c] - plane.corners[0]));
        if (sgn(heights[c]) != 0) continue;
        ++zero_count;
        ends.emplace_back(dot(triangle.corners[c], direction));
    }
    for (std::size_t c = 0; c < 3; ++c) {
        const std::size_t next = (c + 1) % 3;
        if (sgn(heights[c]) * sgn(heights[next]) >= 0) continue;
        const mpz_class from = dot(triangle.corners[c], direction), to = dot(triangle.corners[next], direction);
        mpq_class crossing(from * heights[next] - to * heights[c], heights[next] - heights[c]);
        crossing.canonicalize();
        ends.push_back(crossing);
    }
    if (ends.size() < 2) return {};
    const auto [low, high] = std::ranges::minmax(ends);
    return {low, high, zero_count == 2, low < high};
}

using Flat = std::array<mpq_class, 2>;

// Twice the area to the left of p to q of the point; positive there.
mpq_class left_of(const Flat& p, const Flat& q, const Flat& point) {
    return (q[0] - p[0]) * (point[1] - p[1]) - (q[1] - p[1]) * (point[0] - p[0]);
}

std::vector<Flat> clipped(const std::vector<Flat>& polygon, const Flat& p, const Flat& q) {
    std::vector<Flat> left;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Flat& u = polygon[i];
        const Flat& v = polygon[(i + 1) % polygon.size()];
        const mpq_class at_u = left_of(p, q, u), at_v = left_of(p, q, v);
        if (sgn(at_u) >= 0) left.push_back(u);
        if (sgn(at_u) * sgn(at_v) >= 0) continue;
        const mpq_class s = at_u / (at_u - at_v);
        left.push_back({u[0] + s * (v[0] - u[0]), u[1] + s * (v[1] - u[1])});
    }
    return left;
}

// Of two triangles in one plane.
bool share_area(const IntegerTriangle& a, const IntegerTriangle& b) {
    std::size_t axis = 0;
    while (sgn(a.normal[axis]) == 0) ++axis;
    const auto flat = [&](const IntegerTriangle& triangle) {
        std::vector<Flat> corners;
        for (const SolidPoint& p : triangle.corners) corners.push_back({p[(axis + 1) % 3], p[(axis + 2) % 3]});
        if (sgn(left_of(corners[0], corners[1], corners[2])) < 0) std::swap(corners[1], corners[2]);
        return corners;
    };
    std::vector<Flat> shared = flat(a);
    const std::vector<Flat> sides = flat(b);
    for (std::size_t c = 0; c < 3; ++c) shared = clipped(shared, sides[c], sides[(c + 1) % 3]);
    mpq_class area = 0;
    for (std::size_t i = 2; i < shared.size(); ++i) area += left_of(shared[0], shared[i - 1], shared[i]);
    return sgn(area) > 0;
}

bool meet_wrongly(const IntegerTriangle& a, const IntegerTriangle& b) {
    const SolidPoint direction = cross(a.normal, b.normal);
    if (std::ranges::all_of(direction, [](const mpz_class& x) { return sgn(x) == 0; })) {
        return sgn(dot(a.normal, SolidPoint(b.corners[0] - a.corners[0]))) == 0 && share_area(a, b);
    }
    const Interval of_a = on_plane(a, b, direction), of_b = on_plane(b, a, direction);
    if (!of_a.is_segment || !of_b.is_segment || (of_a.is_side && of_b.is_side)) return false;
    return std::max(of_a.low, of_b.low) < std::min(of_a.high, of_b.high);
}

}  // namespace

bool bounds_nothing(const Mesh& mesh) {
    const FloatEnvironment environment;
    return own_triangles(mesh).empty();
}

std::optional<CornerEdge> open_edge(const Mesh& mesh) {
    const FloatEnvironment environment;
    struct Edge {
        CornerEdge name;
        Line line;

        std::pair<mpz_class, mpz_class> ends() const { return std::minmax(line.from, line.to); }
    };
    struct OfLine {
        std::map<std::pair<mpz_class, mpz_class>, bool> is_odd_edge;
        std::map<mpz_class, bool> is_odd_end;
    };
    std::vector<Edge> edges;
    std::map<std::string, OfLine> lines;
    for (const IntegerTriangle& triangle : own_triangles(mesh)) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            edges.push_back({{triangle.index, c}, Line(triangle.corners[c], triangle.corners[(c + 1) % 3])});
            OfLine& line = lines[edges.back().line.name];
            const auto flip = [](bool& bit) { bit = !bit; };
            flip(line.is_odd_edge[edges.back().ends()]);
            flip(line.is_odd_end[edges.back().line.from]);
            flip(line.is_odd_end[edges.back().line.to]);
        }
    }
    for (const Edge& edge : edges) {
        const OfLine& line = lines.at(edge.line.name);
        if (!line.is_odd_edge.at(edge.ends())) continue;
        if (line.is_odd_end.at(edge.line.from) || line.is_odd_end.at(edge.line.to)) return edge.name;
    }
    return std::nullopt;
}

std::vector<TrianglePair> self_intersections(const Mesh& mesh) {
    const FloatEnvironment environment;
    const std::vector<IntegerTriangle> triangles = own_triangles(mesh);
    std::vector<TrianglePair> pairs;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        for (std::size_t j = i + 1; j < triangles.size(); ++j) {
            if (boxes_are_apart(triangles[i], triangles[j]) || !meet_wrongly(triangles[i], triangles[j])) continue;
            pairs.push_back({triangles[i].index, triangles[j].index});
        }
    }
    return pairs;
}

}  // namespace ecods::oracle
