#include "property/guesses/bodies.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/next.hpp"

namespace ecods::guesses {

double some_power(Random& random, int low, int high) {
    return std::ldexp(1.0, low + static_cast<int>(random.below(static_cast<std::uint32_t>(high - low + 1))));
}

namespace {

using Corners = std::vector<Vec3>;  // of triangles in the world, three by three

Vec3 in_cube(Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}
Vec3 on_lattice(Random& random) {
    return {random.below(5) - 2.0, random.below(5) - 2.0, random.below(5) - 2.0};
}

// One triangle of a kind that the whole soup has.
std::array<Vec3, 3> some_triangle(Random& random, std::uint32_t kind, double small, double large) {
    const Vec3 at = in_cube(random), p = in_cube(random), q = in_cube(random);
    switch (kind) {
        case 0:  // a sliver
            return {p, q, p + random.uniform(0, 1) * (q - p) + small * in_cube(random)};
        case 1:
            return {on_lattice(random), on_lattice(random), on_lattice(random)};
        case 2:  // of a fan
            return {Vec3::Zero(), p, p + 0.3 * q};
        case 3:  // of a strip
            return {large * Vec3(0, -1, 0) + at, large * Vec3(0, 1, 0) + at, at + small * p};
        case 4:  // of a sheet
            return {large * p, large * q, large * at};
        case 5:  // of a terrain that is nearly flat
            return {at + 0.2 * Vec3(p[0], p[1], small * p[2]), at + 0.2 * Vec3(q[0], q[1], small * q[2]),
                    at + Vec3(0, 0, small)};
        case 6:  // small, among others
            return {at, at + 0.1 * p, at + 0.1 * q};
        default:
            return {at, p, q};
    }
}

Corners some_soup(Random& random, std::uint32_t count) {
    const std::uint32_t kind = random.below(10);
    const double small = some_power(random, -60, -5), large = some_power(random, 0, 50);
    const bool is_flat = kind == 5 || random.below(8) == 0;
    Corners corners;
    for (std::uint32_t i = 0; i < count; ++i) {
        for (Vec3 v : some_triangle(random, kind, small, large)) {
            if (is_flat) v[2] *= small;
            corners.push_back(v);
        }
    }
    return corners;
}

Vec3 point_on(Random& random, const Vec3& p, const Vec3& q, const Vec3& r) {
    double s = random.uniform(0, 1), t = random.uniform(0, 1);
    const std::uint32_t kind = random.below(4);
    if (kind == 0) s = t = 0;
    if (kind == 1) t = 0;
    if (s + t > 1) s = 1 - s, t = 1 - t;
    return p + s * (q - p) + t * (r - p);
}
Vec3 point_of(Random& random, const Corners& corners) {
    const std::size_t i = 3 * random.below(static_cast<std::uint32_t>(corners.size() / 3));
    return point_on(random, corners[i], corners[i + 1], corners[i + 2]);
}

// Moves b so that the two only just meet, or only just do not, at a face of either or at an edge of each.
void lay_on(Random& random, const Corners& a, Corners& b) {
    const std::array<Vec3, 3> ways{(a[1] - a[0]).cross(a[2] - a[0]), (b[1] - b[0]).cross(b[2] - b[0]),
                                   (a[1] - a[0]).cross(b[1] - b[0])};
    const std::uint32_t which = random.below(3);
    Vec3 n = (random.below(2) == 0 ? 1 : -1) * ways[which].normalized();
    if (!n.allFinite()) n = random.direction();
    const auto along = [&](const Vec3& p, const Vec3& q) { return n.dot(p) < n.dot(q); };
    Vec3 p = *std::ranges::max_element(a, along), q = *std::ranges::min_element(b, along);
    if (which == 0) p = point_on(random, a[0], a[1], a[2]);
    if (which == 1) q = point_on(random, b[0], b[1], b[2]);
    const double gap = random.below(6) == 0 ? 0 : some_power(random, -56, -8);
    for (Vec3& v : b) v += p - q + (random.below(2) == 0 ? gap : -gap) * n;
}

// Brings b to a: as they are, at a gap, laid on it, a copy that is off by little, faces in parallel planes, or far
// away.
void relate(Random& random, const Corners& a, Corners& b) {
    const Vec3 p = point_of(random, a), q = point_of(random, b);
    const Vec3 normal = (a[1] - a[0]).cross(a[2] - a[0]).normalized();
    const Vec3 way = random.below(2) == 0 && normal.allFinite() ? normal : random.direction();
    const double gap = random.below(6) == 0 ? 0 : some_power(random, -60, 0);
    switch (random.below(9)) {
        case 0:
            return;
        case 1:
            for (std::size_t i = 0; i < b.size(); ++i) b[i] = a[i % a.size()] + gap * (way + 0.25 * in_cube(random));
            return;
        case 2:
            for (Vec3& v : b) v[2] = a[0][2] + gap;
            return;
        case 3: {
            const double distance = some_power(random, 2, 45);
            for (Vec3& v : b) v += distance * way;
            return;
        }
        case 4:
        case 5:
            for (Vec3& v : b) v += p - q + gap * way;
            return;
        default:
            lay_on(random, a, b);
    }
}

// A pose and how to come to the points of the body from the world.
struct Placed {
    Pose pose;
    Mat3 inverse;
};

Placed some_pose(Random& random) {
    const Mat3 Q = random.below(4) == 0 ? Mat3(Mat3::Identity()) : Mat3(random.rotation().toRotationMatrix());
    Placed placed{{Q, Vec3::Zero()}, Q.transpose()};
    const auto i = static_cast<Eigen::Index>(random.below(3)), j = (i + 1 + random.below(2)) % 3;
    switch (random.below(9)) {
        case 5:  // bent a little
            placed.pose.R += some_power(random, -40, -6) * random.rotation().matrix();
            placed.inverse = placed.pose.R.inverse();
            break;
        case 0: {  // a size of its own
            const double size = some_power(random, -40, 40);
            placed.pose.R *= size;
            placed.inverse /= size;
            break;
        }
        case 1: {  // stretched along an axis, or two
            const int most = random.below(3) == 0 ? 300 : 20;
            for (int k = 0; k < 2; ++k) {
                const double size = some_power(random, -most, most);
                placed.pose.R.col((i + k) % 3) *= size;
                placed.inverse.row((i + k) % 3) /= size;
            }
            break;
        }
        case 2: {  // sheared
            const double by = random.uniform(-4, 4);
            placed.pose.R.col(j) += by * placed.pose.R.col(i);
            placed.inverse.row(i) -= by * placed.inverse.row(j);
            break;
        }
        case 3:  // flattened, or nearly: its points are elsewhere
            placed.pose.R.col(i) = placed.pose.R.col(j) * random.uniform(-1, 1);
            if (random.below(3) == 0) placed.pose.R.col((3 - i - j)) = placed.pose.R.col(j) * random.uniform(-1, 1);
            if (random.below(3) != 0) placed.pose.R += some_power(random, -70, -10) * random.rotation().matrix();
            break;
        case 4:  // its points are far from its origin: R v and t cancel
            placed.pose.t = some_power(random, 0, 50) * random.direction();
            break;
        default:
            break;
    }
    return placed;
}

std::shared_ptr<const Mesh> mesh_of(const Corners& world, const Placed& placed) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (const Vec3& w : world) vertices.push_back(placed.inverse * (w - placed.pose.t));
    for (std::uint32_t i = 0; i < vertices.size(); i += 3) triangles.push_back({i, i + 1, i + 2});
    for (const Vec3& v : vertices) {
        if (!v.allFinite()) return nullptr;
    }
    return Mesh::create(std::move(vertices), std::move(triangles));
}

// Any numbers at all.
Bodies any_bodies(Random& random, std::uint32_t count_a, std::uint32_t count_b) {
    const int range = std::min(1020, 1 + static_cast<int>(random.below(8)) * 150);
    const auto any = [&] {
        return random.below(5) == 0 ? 0 : random.uniform(-1, 1) * some_power(random, -range, range);
    };
    const auto any_mesh = [&](std::uint32_t count) {
        Corners corners;
        for (std::uint32_t i = 0; i < 3 * count; ++i) corners.emplace_back(any(), any(), any());
        return mesh_of(corners, {Pose{}, Mat3::Identity()});
    };
    const auto any_pose = [&] {
        Pose pose;
        for (double& x : pose.R.reshaped()) x = any();
        pose.t = {any(), any(), any()};
        return pose;
    };
    return {any_mesh(count_a), any_mesh(count_b), any_pose(), any_pose()};
}

}  // namespace

Bodies some_bodies(Random& random, std::uint32_t triangle_max) {
    const std::uint32_t count_a = 1 + random.below(triangle_max), count_b = 1 + random.below(triangle_max);
    if (random.below(16) == 0) return any_bodies(random, count_a, count_b);
    for (;;) {
        Corners a = some_soup(random, count_a), b = some_soup(random, count_b);
        relate(random, a, b);
        if (random.below(4) == 0) {  // far from the origin
            const Vec3 by = some_power(random, 0, 50) * random.direction();
            for (Corners* corners : {&a, &b}) {
                for (Vec3& v : *corners) v += by;
            }
        }
        Placed of_a = some_pose(random);
        Placed of_b = random.below(4) == 0 ? of_a : some_pose(random);
        Bodies bodies{mesh_of(a, of_a), mesh_of(b, of_b), of_a.pose, of_b.pose};
        if (!bodies.a || !bodies.b) continue;
        if (random.below(4) == 0) {
            const double size = random.below(4) == 0 ? some_power(random, -1074, -1000) : some_power(random, -700, 600);
            for (Pose* pose : {&bodies.pose_a, &bodies.pose_b}) {
                pose->R *= size;
                pose->t *= size;
            }
        }
        const auto is_finite = [](const Pose& pose) { return pose.R.allFinite() && pose.t.allFinite(); };
        if (is_finite(bodies.pose_a) && is_finite(bodies.pose_b)) return bodies;
    }
}

Vec3 some_point(Random& random, const Mesh& mesh, const Pose& pose) {
    const Triangle& t = mesh.triangles()[random.below(static_cast<std::uint32_t>(mesh.triangles().size()))];
    const auto v = mesh.vertices();
    return pose.R * point_on(random, v[t[0]], v[t[1]], v[t[2]]) + pose.t;
}

namespace {

void make_finite(Random& random, Vec3& v) {
    for (double& x : v) {
        if (!std::isfinite(x)) x = random.uniform(-1, 1);
    }
}

}  // namespace

Vec3 some_motion(Random& random, const Bodies& bodies) {
    const Vec3 p = some_point(random, *bodies.a, bodies.pose_a), q = some_point(random, *bodies.b, bodies.pose_b);
    constexpr std::array shares{0.5, 1.0, 1.5, 4.0};
    Vec3 motion = shares[random.below(4)] * (q - p);
    if (random.below(3) == 0) motion += 0.25 * (some_point(random, *bodies.a, bodies.pose_a) - p);
    if (random.below(8) == 0) motion = some_power(random, -40, 40) * in_cube(random);
    make_finite(random, motion);
    if (motion == Vec3::Zero()) motion[0] = 1;
    return motion;
}

Pose some_end(Random& random, const Pose& from, const Vec3& by) {
    Pose to = from;
    if (random.below(4) != 0) to.t += by;
    if (random.below(3) == 0) to.R = random.rotation().toRotationMatrix() * from.R;
    if (random.below(8) == 0)
        to.R += some_power(random, -60, 0) * from.R.cwiseAbs().maxCoeff() * random.rotation().matrix();
    if (random.below(10) == 0) to.R *= -1;
    if (random.below(10) == 0) to.R *= some_power(random, -800, 800);
    if (!to.R.allFinite()) to.R = from.R;
    if (!to.t.allFinite()) to.t = from.t;
    return to;
}

Line some_line(Random& random, const Mesh& mesh, const Pose& pose) {
    Vec3 target = some_point(random, mesh, pose);
    make_finite(random, target);
    const double size = std::max(target.cwiseAbs().maxCoeff(), pose.R.cwiseAbs().maxCoeff());
    Vec3 from = target + size * some_power(random, -20, 4) * random.direction();
    if (random.below(4) == 0) from = some_point(random, mesh, pose);  // along a face, or from one to another
    make_finite(random, from);
    Vec3 to = target;
    if (random.below(2) == 0) to = target + random.uniform(0, 2) * (target - from);
    if (random.below(4) == 0) {
        for (double& x : to) x = random.below(2) == 0 ? next_up(x) : x;
    }
    if (random.below(12) == 0) to = from;
    make_finite(random, to);
    if (random.below(2) == 0) return Line(Segment{from, to});
    Vec3 along = to - from;
    if (random.below(4) == 0) along *= some_power(random, -1000, 1000);
    make_finite(random, along);
    if (along == Vec3::Zero()) along[0] = 1;
    constexpr double ends[] = {0, 0.5, 1, std::numeric_limits<double>::infinity()};
    return Line(Ray{from, along, ends[random.below(4)]});
}

}  // namespace ecods::guesses
