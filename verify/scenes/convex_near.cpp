#include <algorithm>
#include <array>
#include <vector>

#include "scenes/convex_cases.hpp"

namespace ecods::scenes {
namespace {

std::vector<Vec3> posed_vertices(const PosedMesh& body) {
    std::vector<Vec3> points;
    for (const Vec3& v : body.mesh->vertices()) points.push_back(body.pose.R * v + body.pose.t);
    return points;
}

struct Bodies {
    std::array<std::vector<Vec3>, 2> points;
    std::array<std::span<const Triangle>, 2> triangles;

    explicit Bodies(const ConvexCase& made)
        : points{posed_vertices(made.a), posed_vertices(made.b)},
          triangles{made.a.mesh->triangles(), made.b.mesh->triangles()} {}

    std::array<Vec3, 3> any_triangle(std::size_t body, Random& random) const {
        const auto list = triangles[body];
        const Triangle& t = list[random.below(static_cast<std::uint32_t>(list.size()))];
        return {points[body][t[0]], points[body][t[1]], points[body][t[2]]};
    }
    const Vec3& furthest(std::size_t body, const Vec3& along) const {
        return *std::ranges::max_element(points[body], {}, [&](const Vec3& p) { return p.dot(along); });
    }
};

// The outer unit normal; zero if there is none.
Vec3 outer_normal(const Bodies& bodies, std::size_t body, const std::array<Vec3, 3>& t) {
    Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
    const double norm = n.norm();
    if (!(norm > 0)) return Vec3::Zero();
    n /= norm;
    const double above = bodies.furthest(body, n).dot(n) - t[0].dot(n);
    const double below = t[0].dot(n) - bodies.furthest(body, -n).dot(n);
    return above <= below ? n : Vec3(-n);
}

}  // namespace

void bring_near(ConvexCase& made, double gap, Random& random) {
    const Bodies bodies(made);
    for (int attempt = 0; attempt < 64 && random.below(2) == 0; ++attempt) {
        const auto s = bodies.any_triangle(0, random), t = bodies.any_triangle(1, random);
        Vec3 n = (s[1] - s[0]).cross(t[1] - t[0]);
        const double norm = n.norm();
        if (!(norm > 0)) continue;
        n /= random.below(2) == 0 ? norm : -norm;
        const double size = (s[1] - s[0]).norm() + (t[1] - t[0]).norm();
        const bool is_support = bodies.furthest(0, n).dot(n) - s[0].dot(n) < 0x1p-40 * size &&
                                t[0].dot(n) - bodies.furthest(1, -n).dot(n) < 0x1p-40 * size;
        if (!is_support) continue;
        made.b.pose.t += 0.5 * (s[0] + s[1]) - 0.5 * (t[0] + t[1]) + gap * n;
        return;
    }
    const std::size_t of_face = random.below(2);
    const auto face = bodies.any_triangle(of_face, random);
    const Vec3 n = outer_normal(bodies, of_face, face);
    const Vec3 foot = 0.25 * face[0] + 0.25 * face[1] + 0.5 * face[2];
    const Vec3 move = foot + gap * n - bodies.furthest(1 - of_face, -n);
    made.b.pose.t += of_face == 0 ? move : Vec3(-move);
}

}  // namespace ecods::scenes
