#include "scenes/convex_workloads.hpp"

#include <array>
#include <cmath>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/solid.hpp"
#include "scenes/lattice_hull.hpp"
#include "scenes/mesh_builder.hpp"

namespace ecods::scenes {

namespace {

Mat3 rotation(Random& random) {
    return random.rotation().toRotationMatrix();
}

// The hull of 32 points on an ellipsoid, all of which are its vertices.
std::shared_ptr<const Mesh> hull(Random& random, const Vec3& half_axes) {
    while (true) {
        const LatticeMesh mesh = ellipsoid_hull(32, half_axes, random);
        if (mesh.triangles.size() == 60) return to_mesh(mesh, ellipsoid_unit);
    }
}

// Of these half extents, around the origin; turned outwards.
std::shared_ptr<const Mesh> box_mesh(const Vec3& half) {
    std::vector<Vec3> vertices;
    for (unsigned i = 0; i < 8; ++i)
        vertices.emplace_back((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                              (i & 4) != 0 ? half.z() : -half.z());
    return Mesh::create(std::move(vertices), {{0, 2, 3},
                                              {0, 3, 1},
                                              {4, 5, 7},
                                              {4, 7, 6},
                                              {0, 1, 5},
                                              {0, 5, 4},
                                              {2, 6, 7},
                                              {2, 7, 3},
                                              {0, 4, 6},
                                              {0, 6, 2},
                                              {1, 3, 7},
                                              {1, 7, 5}});
}

// A hull that comes along a line towards another one.
class HullPair {
  public:
    explicit HullPair(Random& random)
        : a_mesh(hull(random, {1, 0.8, 0.6})),
          b_mesh(hull(random, {0.9, 0.7, 0.8})),
          a_(a_mesh),
          b_(b_mesh),
          a_pose_{rotation(random), anywhere(random)},
          b_rotation_(rotation(random)),
          line_(random.direction()) {}

    const std::shared_ptr<const Mesh> a_mesh, b_mesh;

    // So far along the line from where their middles are one point.
    MeshQuery at(double way) const { return {{0, a_pose_}, {1, {b_rotation_, a_pose_.t + way * line_}}}; }

    // Just farther than this gap.
    double stop_at(double gap) {
        double near = 0, far = 4;
        while (true) {
            const double middle = near + (far - near) / 2;
            if (middle == near || middle == far || far - near < 0x1p-10 * gap) return far;
            (is_within(middle, gap) ? near : far) = middle;
        }
    }

    // So far in that the depth is about this, where they meet on one feature each; 0 where the line grazes.
    double stop_within(double depth) {
        const double gap = depth / 16, way = stop_at(gap);
        const MeshQuery query = at(way);
        const ClosestPoints points = closest({a_, query.a.pose}, {b_, query.b.pose}, memory_);
        const Vec3 across = points.point_b - points.point_a;
        const double slope = ((across.x() * line_.x() + across.y() * line_.y()) + across.z() * line_.z()) / gap;
        return slope < 0.25 ? 0 : way - (gap + depth) / slope;
    }

  private:
    static Vec3 anywhere(Random& random) {
        const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        return {x, y, random.uniform(-1, 1)};
    }
    // Of the solids: near their common middle the surfaces may be apart.
    bool is_within(double way, double gap) {
        const MeshQuery query = at(way);
        return way < 0.25 || within({a_, query.a.pose}, {b_, query.b.pose}, gap, memory_);
    }

    MeshShape a_, b_;
    Pose a_pose_;
    Mat3 b_rotation_;
    Vec3 line_;
    QueryMemory memory_;
};

void add(ConvexWorkload& workload, const std::shared_ptr<const Mesh>& a, const std::shared_ptr<const Mesh>& b,
         MeshQuery query) {
    query.a.mesh_index = workload.meshes.size();
    query.b.mesh_index = query.a.mesh_index + 1;
    workload.meshes.push_back({workload.name, a});
    workload.meshes.push_back({workload.name, b});
    workload.queries.push_back(query);
}

ConvexWorkload hulls(const std::string& name, ConvexQuestion question, double nominal, std::size_t count) {
    ConvexWorkload workload{{name, {}, {}}, question, nominal};
    Random random(17);
    while (workload.queries.size() < count) {
        HullPair pair(random);
        double way = 0;
        if (nominal == 0) {
            way = on_grid(random.uniform(0.05, 0.5));
        } else {
            way = question == ConvexQuestion::distance ? pair.stop_at(nominal) : pair.stop_within(nominal);
        }
        if (way != 0) add(workload, pair.a_mesh, pair.b_mesh, pair.at(way));
    }
    return workload;
}

struct BoxKind {
    const char* name;
    double thickness;  // of the third extent
    bool is_turned;
};

ConvexWorkload boxes(const BoxKind& kind, std::size_t count) {
    ConvexWorkload workload{{kind.name, {}, {}}, ConvexQuestion::depth, 0};
    Random random(18);
    QueryMemory memory;
    while (workload.queries.size() < count) {
        const auto mesh = [&] {
            const double x = random.uniform(0.5, 1), y = random.uniform(0.5, 1);
            return box_mesh(on_grid(Vec3(x, y, kind.thickness * random.uniform(0.5, 1))));
        };
        const auto a_mesh = mesh(), b_mesh = mesh();
        MeshQuery query;
        if (kind.is_turned) query.a.pose.R = rotation(random), query.b.pose.R = rotation(random);
        query.b.pose.t = on_grid(Vec3(random.uniform(0, 1.5) * random.direction()));
        const Solid a(a_mesh), b(b_mesh);
        const Relation relation = ecods::relation({a, query.a.pose}, {b, query.b.pose}, memory);
        if (relation != Relation::apart && relation != Relation::touching) add(workload, a_mesh, b_mesh, query);
    }
    return workload;
}

// Bodies that stand on each other, the upper one turned by any angle, with a gap or a depth of 2^-6.
struct StackKind {
    const char* name;
    int side_count;  // of a regular prism
    ConvexQuestion question;
};

ConvexWorkload stacks(const StackKind& kind, std::size_t count) {
    constexpr int half_height = 512;
    ConvexWorkload workload{{kind.name, {}, {}}, kind.question, 0};
    const bool is_gap = kind.question == ConvexQuestion::distance;
    if (is_gap) workload.nominal = 0x1p-6 * (1 - 0x1p-20);
    Random random(19);
    const auto mesh = to_mesh(prism(kind.side_count, 1024, 2 * half_height), 0x1p-10);
    while (workload.queries.size() < count) {
        MeshQuery query;
        const double angle = random.uniform(0, 6.25), c = std::cos(angle), s = std::sin(angle);
        query.b.pose.R << c, -s, 0, s, c, 0, 0, 0, 1;
        query.a.pose.t = on_grid(Vec3(random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)));
        const double x = random.uniform(-0.25, 0.25), y = random.uniform(-0.25, 0.25);
        query.b.pose.t = query.a.pose.t + on_grid(Vec3(x, y, 1 + (is_gap ? 0x1p-6 : -0x1p-6)));
        add(workload, mesh, mesh, query);
    }
    return workload;
}

}  // namespace

std::vector<ConvexWorkload> convex_workloads(WorkloadSize size) {
    const std::size_t count = size == WorkloadSize::tiny ? 3 : 300;
    struct Nominal {
        double value;
        const char* name;
    };
    std::vector<ConvexWorkload> workloads;
    for (const auto& [gap, name] :
         std::array{Nominal{1e-1, "1e-1"}, Nominal{1e-3, "1e-3"}, Nominal{1e-6, "1e-6"}, Nominal{1e-9, "1e-9"}})
        workloads.push_back(hulls(std::string("hulls, gap ") + name, ConvexQuestion::distance, gap, count));
    workloads.push_back(hulls("hulls, deep", ConvexQuestion::depth, 0, count));
    for (const auto& [depth, name] : std::array{Nominal{1e-3, "1e-3"}, Nominal{1e-6, "1e-6"}})
        workloads.push_back(hulls(std::string("hulls, depth ") + name, ConvexQuestion::depth, depth, count));
    for (const BoxKind& kind : std::array{BoxKind{"boxes, turned", 1, true}, BoxKind{"boxes, aligned", 1, false},
                                          BoxKind{"plates 500:1", 0.002, true}})
        workloads.push_back(boxes(kind, count));
    for (const StackKind& kind : std::array{StackKind{"boxes, stacked", 4, ConvexQuestion::depth},
                                            StackKind{"prisms, stacked", 16, ConvexQuestion::depth},
                                            StackKind{"boxes, stacked, gap", 4, ConvexQuestion::distance},
                                            StackKind{"prisms, stacked, gap", 16, ConvexQuestion::distance}})
        workloads.push_back(stacks(kind, count));
    return workloads;
}

}  // namespace ecods::scenes
