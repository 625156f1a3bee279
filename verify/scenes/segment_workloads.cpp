#include "scenes/segment_workloads.hpp"

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "scenes/mesh_ball.hpp"
#include "scenes/random.hpp"
#include "scenes/room.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scenes {

namespace {

constexpr double tube = 0.4;  // the torus's, whose points are at most 1.4 from its middle

Vec3 in_unit_ball(Random& random) {
    for (;;) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
        if ((x * x + y * y) + z * z <= 1) return {x, y, z};
    }
}

// A multiple of 2^-20, as the vertices of tori are.
Vec3 on_lattice(const Vec3& v) {
    return {std::ldexp(std::nearbyint(std::ldexp(v.x(), 20)), -20),
            std::ldexp(std::nearbyint(std::ldexp(v.y(), 20)), -20),
            std::ldexp(std::nearbyint(std::ldexp(v.z(), 20)), -20)};
}

Pose any_pose(Random& random) {
    const Mat3 R = random.rotation().toRotationMatrix();
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    return {R, Vec3(x, y, random.uniform(-1, 1))};
}

// A turn by 120 degrees and a translation that keep multiples of 2^-20.
Pose lattice_pose() {
    Mat3 R = Mat3::Zero();
    R(0, 1) = R(1, 2) = R(2, 0) = 1;
    return {R, Vec3(0.25, -0.5, 0.125)};
}

class Against {
  public:
    Against(NamedMesh mesh, const Pose& pose, std::uint32_t seed)
        : mesh_(std::move(mesh)), pose_(pose), random_(seed) {}

    SegmentWorkload chords(std::size_t count) {
        return make("chords", count, [&]() -> Segment {
            const Vec3 from = random_.direction();
            return {1.68 * from, 1.68 * random_.direction()};
        });
    }
    SegmentWorkload probes(std::size_t count) {
        return make("probes", count, [&] {
            const std::array<Vec3, 3> corners = any_triangle();
            const double s = random_.uniform(0, 1), t = random_.uniform(0, 1 - s);
            const Vec3 point = corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
            const Vec3 edge = corners[1] - corners[0];
            const double length = std::sqrt((edge.x() * edge.x() + edge.y() * edge.y()) + edge.z() * edge.z());
            return around(point, 2 * length * random_.direction());
        });
    }
    SegmentWorkload vertices(const std::string& name, std::size_t count) {
        return make(name, count, [&] { return around(any_triangle()[0], on_lattice(0.3 * in_unit_ball(random_))); });
    }
    SegmentWorkload edges(const std::string& name, std::size_t count) {
        return make(name, count, [&] {
            const std::array<Vec3, 3> corners = any_triangle();
            return around((corners[0] + corners[1]) / 2, on_lattice(0.3 * in_unit_ball(random_)));
        });
    }
    SegmentWorkload along_edges(std::size_t count) {
        return make("along edges", count, [&]() -> Segment {
            const std::array<Vec3, 3> corners = any_triangle();
            const Vec3 edge = corners[1] - corners[0];
            return {corners[0] - edge, corners[1] + edge};
        });
    }
    SegmentWorkload haptic(std::size_t count);

  private:
    std::array<Vec3, 3> any_triangle() {
        const Triangle& t =
            mesh_.mesh->triangles()[random_.below(static_cast<std::uint32_t>(mesh_.mesh->triangles().size()))];
        const auto vertices = mesh_.mesh->vertices();
        return {vertices[t[0]], vertices[t[1]], vertices[t[2]]};
    }
    static Segment around(const Vec3& point, const Vec3& arm) { return {point + arm, point - arm}; }

    Vec3 posed(const Vec3& v) const { return image(pose_.R, v) + pose_.t; }

    template <class Local>
    SegmentWorkload make(const std::string& kind, std::size_t count, const Local& local) {
        SegmentWorkload workload{mesh_.name + ", " + kind, {mesh_}, {{0, pose_}}, {}};
        while (workload.queries.size() < count) {
            const Segment segment = local();
            workload.queries.push_back({posed(segment.a), posed(segment.b)});
        }
        return workload;
    }

    NamedMesh mesh_;
    Pose pose_;
    Random random_;
};

// Turned by twice the angle of tangent h: no sine is asked for.
std::array<double, 2> turned(const std::array<double, 2>& v, double h) {
    const double norm = 1 + h * h;
    return {((1 - h * h) * v[0] - 2 * h * v[1]) / norm, (2 * h * v[0] + (1 - h * h) * v[1]) / norm};
}

SegmentWorkload Against::haptic(std::size_t count) {
    std::array<double, 2> about{1, 0}, around_tube{0.8, 0.6};
    std::size_t step = 0;
    const auto next = [&] {
        about = turned(about, 0.001);
        around_tube = turned(around_tube, 0.002);
        const double wave = std::abs(static_cast<double>(step++ % 40) - 20) / 10 - 1;  // from -1 to 1 and back
        const double from_middle = tube + 0.016 * wave;
        const double from_axis = 1 + from_middle * around_tube[0];
        return Vec3(from_axis * about[0], from_axis * about[1], from_middle * around_tube[1]);
    };
    Vec3 last = next();
    SegmentWorkload workload = make("haptic probe", count, [&]() -> Segment {
        const Vec3 from = last;
        return {from, last = next()};
    });
    workload.is_path = true;
    return workload;
}

std::shared_ptr<const Mesh> soup(std::uint32_t triangle_count) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    Random random(12);
    for (std::uint32_t i = 0; i < triangle_count; ++i) {
        for (int k = 0; k < 3; ++k) vertices.push_back(1.4 * random.direction());
        triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

// `ends` is given random numbers and half the room's side.
template <class Ends>
SegmentWorkload in_room(const std::string& name, double side, std::size_t ship_count, std::size_t count,
                        const Ends& ends) {
    const Scene scene = room({.ship_count = ship_count, .frame_count = 0, .side = side, .seed = 10});
    SegmentWorkload workload{name, scene.meshes, {}, {}};
    for (const SceneBody& body : scene.bodies) workload.bodies.push_back({body.mesh_index, body.pose});
    Random random(14);
    while (workload.queries.size() < count) workload.queries.push_back(ends(random, side / 2));
    return workload;
}

Vec3 anywhere(Random& random, double half) {
    const double x = random.uniform(-half, half), y = random.uniform(-half, half);
    return {x, y, random.uniform(-half, half)};
}

Segment from_wall_to_wall(Random& random, double half) {
    Vec3 from = anywhere(random, half), to = anywhere(random, half);
    from.x() = -half;
    to.x() = half;
    return {from, to};
}

Segment of_a_ships_length(Random& random, double half) {
    const Vec3 from = anywhere(random, half);
    return {from, from + 2 * random.direction()};
}

// From one corner to the other, but for a tenth of the side.
Segment diagonal(Random& random, double half) {
    const Vec3 from = anywhere(random, half / 10), to = anywhere(random, half / 10);
    return {from - Vec3::Constant(half), to + Vec3::Constant(half)};
}

void add_rooms(std::vector<SegmentWorkload>& workloads, bool is_tiny) {
    const std::size_t ships = is_tiny ? 100 : 10000, count = is_tiny ? 20 : 5000;
    const std::string of_ships = is_tiny ? "100 ships" : "10,000 ships";
    const double side = calibrated_side_by_density(ships), dense = calibrated_side_by_density(ships / 10);
    workloads.push_back(in_room(of_ships + ", wall to wall", side, ships, count, from_wall_to_wall));
    workloads.push_back(in_room(of_ships + ", a ship's length", side, ships, count, of_a_ships_length));
    workloads.push_back(in_room(of_ships + ", dense, diagonals", dense, ships, count, diagonal));
}

}  // namespace

std::vector<SegmentWorkload> segment_workloads(WorkloadSize size) {
    const bool is_tiny = size == WorkloadSize::tiny;
    const auto count = [&](std::size_t full) { return is_tiny ? std::size_t{20} : full; };
    std::vector<NamedMesh> meshes = {{"torus 10k", torus(100, 50, tube)}};
    if (!is_tiny) {
        meshes.push_back({"torus 100k", torus(400, 125, tube)});
        meshes.push_back({"torus 1M", torus(1000, 500, tube)});
    }
    std::vector<SegmentWorkload> workloads;
    for (const NamedMesh& mesh : meshes) {
        Random random(11);
        Against any(mesh, any_pose(random), 1), lattice(mesh, lattice_pose(), 2);
        workloads.push_back(any.chords(count(10000)));
        workloads.push_back(any.probes(count(10000)));
        workloads.push_back(any.vertices("near vertices", count(2000)));
        workloads.push_back(any.edges("near edges", count(2000)));
        workloads.push_back(lattice.vertices("through vertices", count(2000)));
        workloads.push_back(lattice.edges("through edges", count(2000)));
        workloads.push_back(lattice.along_edges(count(2000)));
        if (&mesh == (is_tiny ? &meshes[0] : &meshes[1])) workloads.push_back(any.haptic(count(2000)));
    }
    Random random(13);
    workloads.push_back(Against({"soup 2k", soup(is_tiny ? 200 : 2000)}, any_pose(random), 3).chords(count(500)));
    add_rooms(workloads, is_tiny);
    return workloads;
}

PosedTriangles posed_triangles(const SegmentWorkload& workload) {
    PosedTriangles all;
    for (const MeshAt& body : workload.bodies) {
        const Mesh& mesh = *workload.meshes[body.mesh_index].mesh;
        const auto first = static_cast<std::uint32_t>(all.vertices.size());
        for (const Vec3& v : mesh.vertices()) all.vertices.emplace_back(image(body.pose.R, v) + body.pose.t);
        for (const Triangle& t : mesh.triangles()) all.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    }
    return all;
}

std::vector<std::uint32_t> first_triangles(const SegmentWorkload& workload) {
    std::vector<std::uint32_t> firsts;
    std::size_t next = 0;
    for (const MeshAt& body : workload.bodies) {
        firsts.push_back(static_cast<std::uint32_t>(next));
        next += workload.meshes[body.mesh_index].mesh->triangles().size();
    }
    return firsts;
}

}  // namespace ecods::scenes
