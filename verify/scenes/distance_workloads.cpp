#include "scenes/distance_workloads.hpp"

#include <array>
#include <cmath>

#include "scenes/approach.hpp"
#include "scenes/mesh_ball.hpp"
#include "scenes/mesh_builder.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::scenes {

namespace {

struct Gap {
    double share;  // of the diameter
    const char* name;
};
constexpr std::array gaps{Gap{1e-1, "1e-1"}, Gap{1e-2, "1e-2"}, Gap{1e-4, "1e-4"}, Gap{1e-8, "1e-8"}};

DistanceWorkload at_gap(const NamedMesh& mesh, const Gap& gap, std::size_t count) {
    DistanceWorkload workload{{mesh.name + ", gap " + gap.name, {mesh}, {}}};
    Random random(7);
    Approach approach(mesh.mesh, mesh.mesh);
    while (workload.queries.size() < count) {
        approach.resting = random.rotation().toRotationMatrix();
        approach.moving = random.rotation().toRotationMatrix();
        approach.line = random.direction();
        if (const auto distance = approach.stop_at(gap.share * approach.diameter()))
            workload.queries.push_back(approach.at(*distance));
    }
    return workload;
}

DistanceWorkload path(const NamedMesh& mesh, std::size_t count) {
    DistanceWorkload workload{{mesh.name + ", path", {mesh}, {}}, true};
    Random random(8);
    Approach approach(mesh.mesh, mesh.mesh);
    approach.resting = random.rotation().toRotationMatrix();
    const Mat3 around = turn_about(random.direction(), 0.005), own = turn_about(random.direction(), 0.005);
    approach.line = random.direction();
    for (int tries = 0; workload.queries.size() < count && tries < 10000; ++tries) {
        approach.line = image(around, approach.line);
        approach.moving = product(own, approach.moving);
        if (const auto distance = approach.stop_at(0.01 * approach.diameter()))
            workload.queries.push_back(approach.at(*distance));
    }
    return workload;
}

// Nine boxes side by side, which touch.
std::shared_ptr<const Mesh> wall() {
    MeshBuilder mesh;
    for (int x = 0; x < 3; ++x) {
        for (int y = 0; y < 3; ++y) {
            std::array<std::uint32_t, 8> v{};
            for (std::uint32_t i = 0; i < 8; ++i) {
                v[i] = mesh.add(Vec3(x + ((i & 1) != 0 ? 1 : 0), y + ((i & 2) != 0 ? 1 : 0), (i & 4) != 0 ? 0.5 : 0));
            }
            mesh.add_quad(v[0], v[2], v[3], v[1]);
            mesh.add_quad(v[4], v[5], v[7], v[6]);
            mesh.add_quad(v[0], v[1], v[5], v[4]);
            mesh.add_quad(v[2], v[6], v[7], v[3]);
            mesh.add_quad(v[0], v[4], v[6], v[2]);
            mesh.add_quad(v[1], v[3], v[7], v[5]);
        }
    }
    return mesh.finish();
}

// Beside, above or beyond, shifted by whole or half boxes; each other query axis-aligned, the others in one rotation.
DistanceWorkload bricks(const Gap& gap, std::size_t count) {
    const NamedMesh mesh{"bricks", wall()};
    DistanceWorkload workload{{mesh.name + ", gap " + gap.name, {mesh}, {}}};
    const double apart = gap.share * 2 * ball_of(*mesh.mesh).radius;
    Random random(9);
    while (workload.queries.size() < count) {
        const auto shift = [&] { return 0.5 * (static_cast<double>(random.below(5)) - 2); };
        Vec3 offset(3 + apart, shift(), 0.25 * shift());
        if (random.below(3) == 0) offset = Vec3(shift(), shift(), 0.5 + apart);
        if (random.below(4) == 0) offset = Vec3(3 + apart, 3 + apart, 0.25 * shift());
        Pose a, b;
        if (workload.queries.size() % 2 == 1) a.R = b.R = random.rotation().toRotationMatrix();
        b.t = image(a.R, offset);
        workload.queries.push_back({{0, a}, {0, b}});
    }
    return workload;
}

// A point and a ball of radius 1; the point is off the sphere by at most this share of the radius.
DistanceWorkload points_near(const NamedMesh& ball, double share, const char* name, std::size_t count) {
    const NamedMesh point{"point", Mesh::create({Vec3::Zero()}, {Triangle{0, 0, 0}})};
    DistanceWorkload workload{{"points, " + ball.name + ", " + name, {point, ball}, {}}, false, true};
    Random random(11);
    while (workload.queries.size() < count) {
        Pose at;
        at.t = (1 + share * random.uniform(-1, 1)) * random.direction();
        workload.queries.push_back({{0, at}, {1, Pose{}}});
    }
    return workload;
}

std::shared_ptr<const Mesh> cloud_of_needles() {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    Random random(10);
    const auto anywhere = [&] {
        const double x = random.uniform(-0.5, 0.5), y = random.uniform(-0.5, 0.5);
        return Vec3(x, y, random.uniform(-0.5, 0.5));
    };
    for (std::uint32_t i = 0; i < 300; ++i) {
        const Vec3 from = anywhere(), along = anywhere(), aside = anywhere();
        const double width = std::ldexp(random.uniform(1, 2), -17 - static_cast<int>(random.below(13)));
        vertices.push_back(from);
        vertices.push_back(from + along);
        vertices.push_back(from + random.uniform(0, 1) * along + width * aside);
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

}  // namespace

std::vector<DistanceWorkload> distance_workloads(WorkloadSize size) {
    const bool is_tiny = size == WorkloadSize::tiny;
    const auto count = [&](std::size_t full) { return is_tiny ? std::size_t{3} : full; };
    std::vector<DistanceWorkload> workloads;
    const NamedMesh of_ship{"ship", ship()};
    for (const Gap& gap : gaps) workloads.push_back(at_gap(of_ship, gap, count(200)));
    workloads.push_back(path(of_ship, count(400)));
    const NamedMesh torus_10k{"torus 10k", torus(100, 50, 0.4)}, torus_100k{"torus 100k", torus(400, 125, 0.4)};
    if (!is_tiny) {
        for (const Gap& gap : gaps) workloads.push_back(at_gap(torus_10k, gap, 60));
        workloads.push_back(path(torus_10k, 200));
        for (const Gap& gap : gaps) workloads.push_back(at_gap(torus_100k, gap, 30));
        workloads.push_back(path(torus_100k, 100));
        for (const NamedMesh& mesh : real_meshes()) {
            workloads.push_back(at_gap(mesh, gaps[1], 60));
            workloads.push_back(at_gap(mesh, gaps[2], 60));
        }
    }
    for (const Gap& gap : gaps) workloads.push_back(bricks(gap, count(100)));
    const NamedMesh needles{"needles", cloud_of_needles()};
    workloads.push_back(at_gap(needles, gaps[0], count(60)));
    workloads.push_back(at_gap(needles, gaps[2], count(60)));
    const NamedMesh small_ball{"ball 320", sphere(16, 11)}, ball{"ball 20k", sphere(160, 65)};
    workloads.push_back(points_near(small_ball, 0.01, "1e-2", count(2000)));
    workloads.push_back(points_near(ball, 0.01, "1e-2", count(2000)));
    if (!is_tiny) workloads.push_back(points_near(ball, 0.5, "0.5", 1000));
    return workloads;
}

}  // namespace ecods::scenes
