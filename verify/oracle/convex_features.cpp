#include "oracle/convex_features.hpp"

#include <gmpxx.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <tuple>

#include "oracle/integer_points.hpp"

namespace ecods::oracle {
namespace {

using Point = Vector<mpz_class>;

int sign_of(const mpz_class& x) {
    return sgn(x);
}

bool is_zero(const Point& v) {
    return std::ranges::all_of(v, [](const mpz_class& x) { return sgn(x) == 0; });
}

// The points of the mesh, each once, and its triangles of positive area by these points; all triangles if none has an
// area.
struct PointSet {
    std::vector<Point> points;
    std::vector<std::uint32_t> in_mesh;
    struct Corners {
        std::uint32_t triangle;
        std::array<std::uint32_t, 3> points;
    };
    std::vector<Corners> triangles;
    bool have_area = false;

    explicit PointSet(const Mesh& mesh) {
        const Soup soup{mesh.vertices(), mesh.triangles(), Pose()};
        const CommonIntegers integers({&soup, 1});
        const std::vector<Point>& all = integers.points.front();
        std::map<std::array<double, 3>, std::uint32_t> known;
        const auto has_area = [&](const Triangle& c) {
            return !is_zero(cross(Point(all[c[1]] - all[c[0]]), Point(all[c[2]] - all[c[0]])));
        };
        have_area = std::ranges::any_of(mesh.triangles(), has_area);
        for (std::uint32_t t = 0; t < mesh.triangles().size(); ++t) {
            const Triangle& c = mesh.triangles()[t];
            if (have_area && !has_area(c)) continue;
            Corners corners{t, {}};
            for (std::size_t i = 0; i < 3; ++i) {
                std::array<double, 3> key{};
                for (int k = 0; k < 3; ++k) {
                    const double x = mesh.vertices()[c[i]][k];
                    key[static_cast<std::size_t>(k)] = x == 0 ? 0 : x;
                }
                const auto [at, is_new] = known.try_emplace(key, static_cast<std::uint32_t>(points.size()));
                if (is_new) {
                    points.push_back(all[c[i]]);
                    in_mesh.push_back(c[i]);
                }
                corners.points[i] = at->second;
            }
            triangles.push_back(corners);
        }
    }
};

// A plane that has no point beyond it.
struct FacePlane {
    std::uint32_t triangle = 0;  // the least in it
    Point normal;
    std::vector<bool> holds;  // by point

    bool holds_everything() const { return std::ranges::find(holds, false) == holds.end(); }

    bool holds_all(const std::array<std::uint32_t, 3>& points) const {
        return std::ranges::all_of(points, [&](std::uint32_t p) { return holds[p]; });
    }
};

// Nothing if there are points on both sides of the plane.
std::optional<FacePlane> face_plane(const PointSet& set, const PointSet::Corners& t) {
    const Point& origin = set.points[t.points[0]];
    FacePlane plane;
    plane.triangle = t.triangle;
    plane.normal = cross(Point(set.points[t.points[1]] - origin), Point(set.points[t.points[2]] - origin));
    plane.holds.resize(set.points.size());
    int side = 0;
    for (std::size_t p = 0; p < set.points.size(); ++p) {
        const int sign = sign_of(dot(plane.normal, Point(set.points[p] - origin)));
        plane.holds[p] = sign == 0;
        if (sign * side < 0) return std::nullopt;
        if (sign != 0) side = sign;
    }
    return plane;
}

// Planes of three faces meet at an extreme point and nowhere else; those through other points share a line.
bool is_extreme(std::uint32_t point, const std::vector<FacePlane>& planes) {
    std::vector<const Point*> normals;
    for (const FacePlane& plane : planes) {
        if (plane.holds[point]) normals.push_back(&plane.normal);
    }
    for (std::size_t i = 2; i < normals.size(); ++i) {
        if (sgn(dot(*normals[i], cross(*normals[0], *normals[1]))) != 0) return true;
    }
    return false;
}

NamedFeature vertex_name(const PointSet& set, std::uint32_t point) {
    for (const auto& t : set.triangles) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            if (t.points[c] == point) return {0, t.triangle, c};
        }
    }
    throw std::logic_error("a point of no triangle");
}

NamedFeature edge_name(const PointSet& set, const FacePlane& f, const FacePlane& g) {
    for (const auto& t : set.triangles) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::uint32_t p = t.points[c], q = t.points[(c + 1) % 3];
            if (f.holds[p] && f.holds[q] && g.holds[p] && g.holds[q]) return {1, t.triangle, c};
        }
    }
    throw std::logic_error("an edge of the solid without a side of a triangle");
}

template <class List>
void sort_by_name(List& list) {
    std::ranges::sort(list, {}, [](const auto& each) { return std::tuple(each.name.triangle, each.name.corner); });
}

// The ends of the edges of one face, as a cycle.
std::vector<std::uint32_t> cycle(std::vector<std::array<std::uint32_t, 2>> sides) {
    std::vector<std::uint32_t> corners{sides.front()[0]};
    std::uint32_t next = sides.front()[1];
    sides.erase(sides.begin());
    while (!sides.empty()) {
        const auto at =
            std::ranges::find_if(sides, [&](const auto& side) { return side[0] == next || side[1] == next; });
        if (at == sides.end()) throw std::logic_error("the edges of a face are no cycle");
        corners.push_back(next);
        next = (*at)[0] == next ? (*at)[1] : (*at)[0];
        sides.erase(at);
    }
    return corners;
}

// Returns true if the way from p to q is a side of the polygon: everything is left of it, around the normal, or on it.
bool is_side(const PointSet& set, std::uint32_t p, std::uint32_t q, const Point& normal) {
    if (p == q) return false;
    const Point way = set.points[q] - set.points[p];
    return std::ranges::all_of(set.points, [&](const Point& x) {
        const Point to = x - set.points[p];
        const mpz_class along = dot(way, to);
        const int turn = sgn(dot(normal, cross(way, to)));
        return turn > 0 || (turn == 0 && sgn(along) >= 0 && along <= square_of(way));
    });
}

// The least side of a triangle of which both ends are on the line of two points, and are not one point.
NamedFeature side_on_line(const PointSet& set, std::uint32_t a, std::uint32_t b) {
    const Point way = set.points[b] - set.points[a];
    const auto is_on = [&](std::uint32_t p) { return is_zero(cross(way, Point(set.points[p] - set.points[a]))); };
    for (const auto& t : set.triangles) {
        for (std::uint32_t c = 0; c < 3; ++c) {
            const std::uint32_t p = t.points[c], q = t.points[(c + 1) % 3];
            if (p != q && is_on(p) && is_on(q)) return {1, t.triangle, c};
        }
    }
    throw std::logic_error("an edge of a flat set without a side of a triangle");
}

// Returns the features of a polygon, a segment or a point. The polygon goes around as its first triangle.
ConvexFeatures flat_features(const PointSet& set) {
    ConvexFeatures features;
    std::map<std::uint32_t, std::uint32_t> next;  // by point: the other end of a side
    const auto count = static_cast<std::uint32_t>(set.points.size());
    if (set.have_area) {
        const auto& first = set.triangles.front().points;
        const Point normal = cross(Point(set.points[first[1]] - set.points[first[0]]),
                                   Point(set.points[first[2]] - set.points[first[0]]));
        for (std::uint32_t p = 0; p < count; ++p) {
            for (std::uint32_t q = 0; q < count; ++q) {
                if (is_side(set, p, q, normal)) next[p] = q;
            }
        }
    } else {
        const auto [low, high] = std::ranges::minmax_element(set.points);
        const auto from = static_cast<std::uint32_t>(low - set.points.begin()),
                   to = static_cast<std::uint32_t>(high - set.points.begin());
        next[from] = to;
        next.try_emplace(to, to);
    }
    for (const auto& [p, q] : next) features.vertices.push_back({vertex_name(set, p), p});
    sort_by_name(features.vertices);
    std::map<std::uint32_t, std::uint32_t> vertex_of;
    for (std::uint32_t v = 0; v < features.vertices.size(); ++v) vertex_of[features.vertices[v].in_mesh] = v;
    for (const auto& [p, q] : next) {
        const std::uint32_t v = vertex_of[p], w = vertex_of[q];
        if (v != w) features.edges.push_back({side_on_line(set, p, q), {std::min(v, w), std::max(v, w)}});
    }
    sort_by_name(features.edges);
    if (set.have_area) {
        ConvexFeatures::Face face{{2, set.triangles.front().triangle, 0}, {}};
        const std::uint32_t start = next.begin()->first;
        for (std::uint32_t p = start; face.corners.empty() || p != start; p = next[p]) {
            face.corners.push_back(vertex_of[p]);
        }
        features.faces.push_back(std::move(face));
    }
    for (auto& vertex : features.vertices) vertex.in_mesh = set.in_mesh[vertex.in_mesh];
    return features;
}

}  // namespace

const NamedFeature& ConvexFeatures::name_of(const std::vector<std::uint32_t>& corners) const {
    if (corners.size() == 1) return vertices[corners.front()].name;
    if (corners.size() == 2) {
        const auto at = std::ranges::find_if(
            edges, [&](const Edge& edge) { return edge.ends[0] == corners[0] && edge.ends[1] == corners[1]; });
        if (at != edges.end()) return at->name;
    }
    for (const Face& face : faces) {
        std::vector<std::uint32_t> sorted = face.corners;
        std::ranges::sort(sorted);
        if (sorted == corners) return face.name;
    }
    throw std::logic_error("no feature has these vertices");
}

std::optional<ConvexFeatures> convex_features(const Mesh& mesh) {
    const PointSet set(mesh);
    if (set.triangles.empty()) return std::nullopt;
    std::vector<FacePlane> planes;
    for (const auto& t : set.triangles) {
        if (!set.have_area) break;
        if (std::ranges::any_of(planes, [&](const FacePlane& plane) { return plane.holds_all(t.points); })) continue;
        auto plane = face_plane(set, t);
        if (!plane) return std::nullopt;
        planes.push_back(std::move(*plane));
    }
    if (!set.have_area || (planes.size() == 1 && planes.front().holds_everything())) return flat_features(set);
    ConvexFeatures features;
    for (std::uint32_t p = 0; p < set.points.size(); ++p) {
        if (is_extreme(p, planes)) features.vertices.push_back({vertex_name(set, p), p});
    }
    sort_by_name(features.vertices);
    std::vector<std::vector<std::array<std::uint32_t, 2>>> sides(planes.size());
    for (std::size_t f = 0; f < planes.size(); ++f) {
        for (std::size_t g = f + 1; g < planes.size(); ++g) {
            std::vector<std::uint32_t> shared;
            for (std::uint32_t v = 0; v < features.vertices.size(); ++v) {
                const std::uint32_t p = features.vertices[v].in_mesh;
                if (planes[f].holds[p] && planes[g].holds[p]) shared.push_back(v);
            }
            if (shared.size() != 2) continue;
            features.edges.push_back({edge_name(set, planes[f], planes[g]), {shared[0], shared[1]}});
            sides[f].push_back(features.edges.back().ends);
            sides[g].push_back(features.edges.back().ends);
        }
    }
    sort_by_name(features.edges);
    for (std::size_t f = 0; f < planes.size(); ++f) {
        features.faces.push_back({{2, planes[f].triangle, 0}, cycle(sides[f])});
    }
    // Until here a vertex is known by its point.
    for (auto& vertex : features.vertices) vertex.in_mesh = set.in_mesh[vertex.in_mesh];
    return features;
}

bool is_bent(const Mesh& mesh, std::uint32_t triangle, std::uint32_t corner, std::uint32_t beyond) {
    const auto vertices = mesh.vertices();
    const auto exact = [&](std::uint32_t v) {
        return Vector<mpq_class>{mpq_class(vertices[v][0]), mpq_class(vertices[v][1]), mpq_class(vertices[v][2])};
    };
    const Triangle& t = mesh.triangles()[triangle];
    const auto p = exact(t[0]);
    const auto normal = cross(Vector<mpq_class>(exact(t[1]) - p), Vector<mpq_class>(exact(t[2]) - p));
    if (sgn(dot(normal, Vector<mpq_class>(exact(beyond) - p))) == 0) return false;
    const std::array<Vec3, 3> wanted{vertices[t[corner]], vertices[t[(corner + 1) % 3]], vertices[beyond]};
    return std::ranges::any_of(mesh.triangles(), [&](const Triangle& other) {
        return std::ranges::all_of(wanted, [&](const Vec3& x) {
            return std::ranges::any_of(other, [&](std::uint32_t v) { return vertices[v] == x; });
        });
    });
}

}  // namespace ecods::oracle
