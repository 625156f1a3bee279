#include "fuzz/checks/way_bodies.hpp"

#include <cmath>

#include "fuzz/base/user_shape.hpp"

namespace ecods::fuzz {
namespace {

// Asking all pairs takes long where bodies are many, or have many triangles; and where numbers differ much in size, so
// that integers are long, some hundred times as long.
constexpr std::size_t triangle_pairs_max = 20000, triangle_pairs_max_of_long_integers = 200;
constexpr double moderate_min = 0x1p-64, moderate_max = 0x1p64;

bool is_moderate(const auto& numbers) {
    const auto sizes = numbers.array().abs();
    return (sizes == 0 || (sizes >= moderate_min && sizes <= moderate_max)).all();
}

}  // namespace

Posed<MeshShape> mesh_at(const Shape& shape, const Pose& pose) {
    const auto* user = dynamic_cast<const UserShape*>(&shape);
    return {user != nullptr ? user->as_mesh_shape() : dynamic_cast<const MeshShape&>(shape), pose};
}

Posed<MeshShape> mesh_at(const World& world, BodyId body) {
    return mesh_at(*world.shape(body), world.pose(body));
}

std::optional<Deforming> deformed(const Posed<MeshShape>& body, const Vec3& motion, scenes::Random& random) {
    std::vector<Vec3> from, to;
    const double aside = random.below(3) == 0 ? 0 : 0.25 * motion.norm();
    for (const Vec3& v : body.what->mesh().vertices()) {
        from.push_back(body.pose.R * v + body.pose.t);
        to.push_back(from.back() + motion + random.uniform(0, aside) * random.direction());
        if (!from.back().allFinite() || !to.back().allFinite()) return std::nullopt;
    }
    const auto triangles = body.what->mesh().triangles();
    return Deforming(std::make_shared<const MeshShape>(Mesh::create(from, {triangles.begin(), triangles.end()})), to);
}

Vec3 any_point(const World& world, const std::vector<BodyId>& bodies, scenes::Random& random) {
    const BodyId body = bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
    const Aabb box = world.box(body);
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis) point[axis] = random.below(2) == 0 ? box.min[axis] : box.max[axis];
    if (random.below(3) != 0) {
        const auto mesh = mesh_of(*world.shape(body));
        const auto vertices = mesh->vertices();
        const Pose pose = world.pose(body);
        const auto vertex = [&] { return vertices[random.below(static_cast<std::uint32_t>(vertices.size()))]; };
        point = pose.R * vertex() + pose.t;
        if (random.below(3) == 0) point = 0.5 * (point + (pose.R * vertex() + pose.t));
    }
    return point.allFinite() ? point : Vec3(0, 0, 0);
}

bool have_moderate_numbers(const World& world, const std::vector<BodyId>& bodies) {
    return std::ranges::all_of(bodies, [&](BodyId body) {
        const Pose pose = world.pose(body);
        return is_moderate(pose.R) && is_moderate(pose.t) &&
               std::ranges::all_of(mesh_of(*world.shape(body))->vertices(),
                                   [](const Vec3& v) { return is_moderate(v); });
    });
}

bool are_soon_asked(const World& world, const std::vector<BodyId>& bodies, std::size_t factor) {
    std::size_t count = 0, pairs = 0;
    for (const BodyId body : bodies) {
        const auto mesh = mesh_of(*world.shape(body));
        pairs += count * mesh->triangles().size();
        count += mesh->triangles().size();
    }
    const std::size_t most =
        have_moderate_numbers(world, bodies) ? triangle_pairs_max : triangle_pairs_max_of_long_integers;
    return factor * pairs <= most;
}

}  // namespace ecods::fuzz
