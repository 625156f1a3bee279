// Nothing leaks out of a ball or through a plane of triangles of floats, far from the origin, where they are coarse
// (Embree, tutorials/verify/verify.cpp, WatertightTest, which allows one ray in 50,000 to miss; here none may).
#include <cmath>
#include <optional>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::foreign::embree {
namespace {

constexpr int random_rays = 3000;
const Vec3 center(148376, 1234, -223423);

Vec3 as_floats(const Vec3& p) {
    return p.cast<float>().cast<double>();
}
Vec3 in_cube(scenes::Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// Rays anywhere, and to every vertex and the middle of every edge, where triangles meet. The last come with directions
// that are rounded, so they only pass near there.
template <class Origin, class Direction>
void ask_mesh(Expectations& expect, const std::shared_ptr<const Mesh>& mesh, Origin origin, Direction direction) {
    const MeshShape shape(mesh);
    const auto hits = [&](const Vec3& from, const Vec3& along) {
        return first_hit(Ray{from, along}, {shape, Pose{}}).has_value();
    };
    for (int i = 0; i < random_rays; ++i) expect.is(hits(origin(), as_floats(direction())), true);
    for (const Triangle& t : mesh->triangles()) {
        const Vec3 p = mesh->vertices()[t[0]], q = mesh->vertices()[t[1]], from = origin();
        expect.is(hits(from, as_floats(p - from)), true);
        expect.is(hits(from, as_floats((p + q) / 2 - from)), true);
        expect.is(first_hit(Segment{from, p}, {shape, Pose{}}).has_value(), true);
    }
}

}  // namespace

void ask(Expectations& expect) {
    scenes::Random random(1);
    expect.from("WatertightTest, sphere.triangles");
    const auto sphere =
        scenes::mapped(*scenes::sphere(60, 30), [](const Vec3& v) { return as_floats(center + 2 * v); });
    ask_mesh(
        expect, sphere, [&] { return as_floats(center + in_cube(random)); }, [&] { return in_cube(random); });

    expect.from("WatertightTest, plane.triangles");
    constexpr std::uint32_t count = 40;
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i <= count; ++i) {
        for (std::uint32_t j = 0; j <= count; ++j) {
            vertices.push_back(as_floats({center[0], 12. / count * j - 6, 12. / count * i - 6}));
            if (i == count || j == count) continue;
            const std::uint32_t at = (count + 1) * i + j;
            triangles.push_back({at, at + 1, at + count + 1});
            triangles.push_back({at + 1, at + count + 2, at + count + 1});
        }
    }
    const auto plane = Mesh::create(std::move(vertices), std::move(triangles));
    ask_mesh(
        expect, plane,
        [&] {
            return as_floats({center[0] - 3, 0, 0});
        },
        [&] { return Vec3(1, random.uniform(-1, 1), random.uniform(-1, 1)); });
}

}  // namespace ecods::foreign::embree
