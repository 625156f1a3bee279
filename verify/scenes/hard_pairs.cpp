#include "scenes/hard_pairs.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace ecods::scenes {
namespace {

using Int3 = std::array<std::int64_t, 3>;
using IntTriangle = std::array<Int3, 3>;

// A number with a full mantissa, unlike Random::uniform.
double full(Random& random, double min, double max) {
    const double high = random.uniform(0, 1), low = random.uniform(0, 1);
    return min + (max - min) * std::min(1.0, high + low * 0x1p-32);
}

int integer(Random& random, int min, int max) {
    return min + static_cast<int>(random.below(static_cast<std::uint32_t>(max - min + 1)));
}

bool coin(Random& random) {
    return random.below(2) == 0;
}

Mat3 rotation(Random& random) {
    return random.rotation().toRotationMatrix();
}

Pose random_pose(Random& random) {
    Pose pose;
    pose.R = rotation(random);
    for (int k = 0; k < 3; ++k) pose.t[k] = full(random, -10, 10);
    return pose;
}

Int3 cross(const Int3& a, const Int3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Int3 minus(const Int3& a, const Int3& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
std::int64_t dot(const Int3& a, const Int3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

IntTriangle integer_triangle(Random& random, int size) {
    for (;;) {
        IntTriangle t;
        for (Int3& corner : t) {
            for (auto& x : corner) x = integer(random, -size, size);
        }
        if (cross(minus(t[1], t[0]), minus(t[2], t[0])) != Int3{}) return t;
    }
}

Vec3 to_vec(const Int3& p, double scale = 1) {
    return {double(p[0]) * scale, double(p[1]) * scale, double(p[2]) * scale};
}

std::array<Vec3, 3> to_vecs(const IntTriangle& t, double scale = 1) {
    return {to_vec(t[0], scale), to_vec(t[1], scale), to_vec(t[2], scale)};
}

// Corners as integer combinations of three vectors of 45 bits: exact in double for small integers.
struct Basis {
    std::array<Vec3, 3> vectors;

    explicit Basis(Random& random) {
        for (Vec3& v : vectors) {
            for (int k = 0; k < 3; ++k) v[k] = std::floor(full(random, -1, 1) * 0x1p44) * 0x1p-44;
        }
    }
    std::array<Vec3, 3> apply(const IntTriangle& t) const {
        std::array<Vec3, 3> result;
        for (std::size_t i = 0; i < 3; ++i) {
            result[i] = double(t[i][0]) * vectors[0] + double(t[i][1]) * vectors[1] + double(t[i][2]) * vectors[2];
        }
        return result;
    }
};

void nudge(double& x, Random& random) {
    x = std::nextafter(x, coin(random) ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest());
}

void nudge_one(PosedPair& pair, Random& random) {
    auto& triangle = coin(random) ? pair.a : pair.b;
    Vec3& corner = triangle[random.below(3)];
    nudge(corner[integer(random, 0, 2)], random);
}

PosedPair in_basis(const IntTriangle& a, const IntTriangle& b, Random& random) {
    const Basis basis(random);
    PosedPair pair{random_pose(random), {}, basis.apply(a), basis.apply(b), {}};
    pair.pose_b = pair.pose_a;
    return pair;
}

PosedPair lattice(Random& random) {
    const IntTriangle a = integer_triangle(random, 2);
    const IntTriangle b = integer_triangle(random, 2);
    return in_basis(a, b, random);
}

PosedPair generic(Random& random) {
    PosedPair pair;
    pair.pose_a = random_pose(random);
    pair.pose_b = random_pose(random);
    pair.pose_b.t = pair.pose_a.t;
    for (int k = 0; k < 3; ++k) pair.pose_b.t[k] += full(random, -0.5, 0.5);
    for (auto* triangle : {&pair.a, &pair.b}) {
        for (Vec3& corner : *triangle) {
            for (int k = 0; k < 3; ++k) corner[k] = full(random, -1, 1);
        }
    }
    return pair;
}

PosedPair coplanar(Random& random) {
    IntTriangle a, b;
    do {
        a = integer_triangle(random, 3);
        b = integer_triangle(random, 3);
        for (auto* t : {&a, &b}) {
            for (Int3& corner : *t) corner[2] = 1;
        }
    } while (cross(minus(a[1], a[0]), minus(a[2], a[0])) == Int3{} ||
             cross(minus(b[1], b[0]), minus(b[2], b[0])) == Int3{});
    return in_basis(a, b, random);
}

// Edges a0 a1 and b0 b1 cross in the origin of the lattice; the third corners are anywhere.
PosedPair edge_on_edge(Random& random) {
    IntTriangle a, b;
    const auto opposite = [](const Int3& p, std::int64_t factor) {
        return Int3{-factor * p[0], -factor * p[1], -factor * p[2]};
    };
    do {
        a = integer_triangle(random, 2);
        a[1] = opposite(a[0], integer(random, 1, 2));
        b = integer_triangle(random, 2);
        b[1] = opposite(b[0], integer(random, 1, 2));
    } while (cross(minus(a[1], a[0]), minus(a[2], a[0])) == Int3{} ||
             cross(minus(b[1], b[0]), minus(b[2], b[0])) == Int3{});
    return in_basis(a, b, random);
}

// Corner b0 is in the interior of triangle a, b1 and b2 are strictly on its positive side.
struct FaceContact {
    IntTriangle a;
    IntTriangle b;
    Int3 normal;
};

FaceContact face_contact(Random& random, int size) {
    FaceContact c;
    c.a = integer_triangle(random, size);
    c.normal = cross(minus(c.a[1], c.a[0]), minus(c.a[2], c.a[0]));
    for (std::size_t k = 0; k < 3; ++k) c.b[0][k] = 2 * c.a[0][k] + c.a[1][k] + c.a[2][k];
    for (Int3& corner : c.a) {
        for (auto& x : corner) x *= 4;
    }
    do {
        for (std::size_t i = 1; i < 3; ++i) {
            do {
                for (std::size_t k = 0; k < 3; ++k) c.b[i][k] = c.b[0][k] + integer(random, -4 * size, 4 * size);
            } while (dot(c.normal, minus(c.b[i], c.b[0])) <= 0);
        }
    } while (cross(minus(c.b[1], c.b[0]), minus(c.b[2], c.b[0])) == Int3{});
    return c;
}

// Moves b0 by `steps` units in the last place along a local axis on which the normal, as seen from there, is not zero.
// The contact is an interior one, so the bodies then pass through each other, or are apart.
void step_contact(PosedPair& pair, const Int3& local_normal, int steps, Random& random) {
    pair.intersects = true;
    if (steps == 0) return;
    std::size_t axis = 0;
    do axis = random.below(3);
    while (local_normal[axis] == 0);
    const bool up = coin(random);
    double& x = pair.b[0][static_cast<Eigen::Index>(axis)];
    for (int i = 0; i < steps; ++i) {
        x = std::nextafter(x, up ? std::numeric_limits<double>::max() : std::numeric_limits<double>::lowest());
    }
    pair.intersects = (local_normal[axis] > 0) != up;
}

// Products of a normal (38 bits) and a difference (20 bits) stay below 2^63.
PosedPair vertex_on_face(Random& random, int steps) {
    const FaceContact c = face_contact(random, 100000);
    PosedPair pair{random_pose(random), {}, to_vecs(c.a, 0x1p-40), to_vecs(c.b, 0x1p-40), {}};
    pair.pose_b = pair.pose_a;
    step_contact(pair, c.normal, steps, random);
    return pair;
}

// The scaled rotation of an integer quaternion: rows are orthogonal, of length |q|^2.
struct IntegerRotation {
    std::array<Int3, 3> rows;
    std::int64_t norm;

    IntegerRotation(Random& random, int size) {
        std::int64_t w, x, y, z;
        do {
            w = integer(random, -size, size);
            x = integer(random, -size, size);
            y = integer(random, -size, size);
            z = integer(random, -size, size);
            norm = w * w + x * x + y * y + z * z;
        } while (norm == 0);
        rows = {Int3{w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)},
                Int3{2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)},
                Int3{2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z}};
    }
    Mat3 matrix() const {
        Mat3 R;
        for (std::size_t i = 0; i < 3; ++i) R.row(static_cast<Eigen::Index>(i)) = to_vec(rows[i]).transpose();
        return R;
    }
    // M^T p, by which M undoes it times norm^2.
    Int3 undo(const Int3& p) const {
        Int3 result;
        for (std::size_t j = 0; j < 3; ++j) result[j] = rows[0][j] * p[0] + rows[1][j] * p[1] + rows[2][j] * p[2];
        return result;
    }
};

Int3 times(const Int3& p, std::int64_t factor) {
    return {p[0] * factor, p[1] * factor, p[2] * factor};
}

// The same real configuration, each body modelled in a frame of its own: R_a v_a = N_a^2 N_b^2 p for both.
PosedPair in_integer_frames(const IntTriangle& a, const IntTriangle& b, int size, double scale, Random& random,
                            Int3* normal) {
    const IntegerRotation ra(random, size), rb(random, size);
    PosedPair pair;
    pair.pose_a.R = ra.matrix();
    pair.pose_b.R = rb.matrix();
    for (std::size_t i = 0; i < 3; ++i) {
        pair.a[i] = to_vec(times(ra.undo(a[i]), rb.norm * rb.norm), scale);
        pair.b[i] = to_vec(times(rb.undo(b[i]), ra.norm * ra.norm), scale);
    }
    if (normal != nullptr) *normal = rb.undo(*normal);
    return pair;
}

PosedPair integer_rotations(Random& random) {
    const double scale = std::ldexp(1.0, -integer(random, 0, 40));
    const IntTriangle a = integer_triangle(random, 2);
    const IntTriangle b = integer_triangle(random, 2);
    PosedPair pair = in_integer_frames(a, b, 5, scale, random, nullptr);
    if (coin(random)) {
        for (int k = 0; k < 3; ++k) pair.pose_a.t[k] = pair.pose_b.t[k] = integer(random, -1000, 1000) * scale;
    }
    return pair;
}

// Numbers stay below 2^53: 2^15 for the contact, 3 * 16 for a rotation, 16^2 for the other's norm squared.
PosedPair vertex_on_face_integer(Random& random, int steps) {
    FaceContact c = face_contact(random, 1000);
    PosedPair pair = in_integer_frames(c.a, c.b, 2, 1, random, &c.normal);
    step_contact(pair, c.normal, steps, random);
    return pair;
}

Mat3 signed_permutation(Random& random) {
    std::array<int, 3> axes{0, 1, 2};
    for (std::size_t i = 2; i > 0; --i) {
        std::swap(axes[i], axes[random.below(static_cast<std::uint32_t>(i) + 1)]);
    }
    Mat3 R = Mat3::Zero();
    for (int i = 0; i < 3; ++i) R(i, axes[static_cast<std::size_t>(i)]) = coin(random) ? 1 : -1;
    return R;
}

// Corners of two boxes that share a face's plane, in space; undone by a permutation matrix for each body.
PosedPair permutations(Random& random) {
    const auto number = [&] { return std::floor(full(random, 0.1, 1) * 0x1p44) * 0x1p-44; };
    const Vec3 half_a{number(), number(), number()}, half_b{number(), number(), number()};
    Vec3 offset;
    for (int k = 0; k < 3; ++k) offset[k] = coin(random) ? half_a[k] - half_b[k] : half_a[k] + half_b[k];
    offset[integer(random, 0, 2)] = 0;
    PosedPair pair;
    pair.pose_a.R = signed_permutation(random);
    pair.pose_b.R = signed_permutation(random);
    pair.pose_b.t = offset;
    const auto corners = [&](const Vec3& half) {
        std::array<Vec3, 3> result;
        const int start = integer(random, 0, 7), axis = integer(random, 0, 2);
        // Two face neighbours of a corner: half a face of the box.
        const std::array<int, 3> bits{start, start ^ (1 << axis), start ^ (1 << (axis + 1) % 3)};
        for (std::size_t i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) result[i][k] = (bits[i] >> k & 1) != 0 ? half[k] : -half[k];
        }
        return result;
    };
    pair.a = corners(half_a);
    pair.b = corners(half_b);
    for (Vec3& v : pair.a) v = pair.pose_a.R.transpose() * v;
    for (Vec3& v : pair.b) v = pair.pose_b.R.transpose() * v;
    return pair;
}

PosedPair short_coordinates(Random& random) {
    const double unit = std::ldexp(1.0, integer(random, -20, 20));
    PosedPair pair;
    pair.a = to_vecs(integer_triangle(random, 3), unit);
    pair.b = to_vecs(integer_triangle(random, 3), unit);
    for (int k = 0; k < 3; ++k) {
        pair.pose_a.t[k] = integer(random, -1000, 1000) * unit;
        pair.pose_b.t[k] = pair.pose_a.t[k] + integer(random, -3, 3) * unit;
    }
    return pair;
}

PosedPair far_from_origin(Random& random) {
    PosedPair pair = lattice(random);
    double distance = 1;
    for (int i = integer(random, 0, 12); i > 0; --i) distance *= 10;
    for (int k = 0; k < 3; ++k) pair.pose_a.t[k] = pair.pose_b.t[k] = full(random, -1, 1) * distance;
    if (coin(random)) nudge_one(pair, random);
    return pair;
}

// Each triangle has its third corner a small fraction beside the edge of the other two.
PosedPair slivers(Random& random) {
    PosedPair pair = lattice(random);
    for (auto* t : {&pair.a, &pair.b}) {
        const double thickness = std::ldexp(1.0, -integer(random, 0, 40));
        (*t)[2] = 0.5 * ((*t)[0] + (*t)[1]) + thickness * ((*t)[2] - (*t)[0]);
    }
    if (coin(random)) pair.b[0] = pair.a[2];
    return pair;
}

PosedPair wide_exponents(Random& random) {
    PosedPair pair = lattice(random);
    const bool both = coin(random);
    for (int i = 0; i < 9; ++i) {
        if (random.below(4) != 0) continue;
        const double x = full(random, -1, 1);
        pair.pose_a.R.data()[i] = std::ldexp(x, -integer(random, 0, both ? 200 : 60));
    }
    pair.pose_b.R = pair.pose_a.R;
    if (coin(random)) {
        for (auto* t : {&pair.a, &pair.b}) {
            for (Vec3& corner : *t) {
                for (int k = 0; k < 3; ++k) {
                    if (random.below(8) != 0) continue;
                    const double x = full(random, -1, 1);
                    corner[k] = std::ldexp(x, -integer(random, 0, 300));
                }
            }
        }
    }
    return pair;
}

PosedPair scaled(Random& random, int exponent_min, int exponent_max) {
    PosedPair pair = lattice(random);
    const double scale = std::ldexp(1.0, integer(random, exponent_min, exponent_max));
    pair.pose_a.t.setZero();
    pair.pose_b.t.setZero();
    for (auto* t : {&pair.a, &pair.b}) {
        for (Vec3& corner : *t) corner *= scale;
    }
    if (coin(random)) nudge_one(pair, random);
    return pair;
}

PosedPair singular(Random& random) {
    PosedPair pair = lattice(random);
    for (Pose* pose : {&pair.pose_a, &pair.pose_b}) {
        const int column = integer(random, 0, 2);
        switch (random.below(4)) {
            case 0:
                pose->R.col(column).setZero();
                break;
            case 1:
                pose->R.col(column) = pose->R.col((column + 1) % 3);
                break;
            case 2:
                pose->R = pose->R.col(column) * Vec3(1, 2, 3).transpose();
                break;
            default:
                break;
        }
        if (coin(random)) pair.pose_b = pair.pose_a;
    }
    return pair;
}

PosedPair degenerate(Random& random) {
    const int size = integer(random, 0, 2);
    PosedPair pair;
    for (auto* t : {&pair.a, &pair.b}) {
        for (Vec3& corner : *t) {
            for (int k = 0; k < 3; ++k) corner[k] = integer(random, -size, size);
        }
        switch (random.below(4)) {
            case 0:
                (*t)[2] = (*t)[0];
                break;
            case 1:
                (*t)[2] = 2 * (*t)[1] - (*t)[0];
                break;
            default:
                break;
        }
    }
    if (coin(random)) pair.pose_a = random_pose(random);
    pair.pose_b = pair.pose_a;
    return pair;
}

constexpr std::array families{HardFamily::generic,
                              HardFamily::lattice,
                              HardFamily::lattice_one_ulp,
                              HardFamily::coplanar,
                              HardFamily::edge_on_edge,
                              HardFamily::vertex_on_face,
                              HardFamily::vertex_near_face,
                              HardFamily::integer_rotations,
                              HardFamily::vertex_on_face_integer,
                              HardFamily::vertex_near_face_integer,
                              HardFamily::permutations,
                              HardFamily::equal_poses,
                              HardFamily::short_coordinates,
                              HardFamily::far_from_origin,
                              HardFamily::slivers,
                              HardFamily::wide_exponents,
                              HardFamily::scaled,
                              HardFamily::extreme_scales,
                              HardFamily::singular,
                              HardFamily::degenerate};

}  // namespace

std::span<const HardFamily> hard_families() {
    return families;
}

std::string_view name(HardFamily family) {
    switch (family) {
        case HardFamily::generic:
            return "generic";
        case HardFamily::lattice:
            return "lattice";
        case HardFamily::lattice_one_ulp:
            return "lattice, one ulp";
        case HardFamily::coplanar:
            return "coplanar";
        case HardFamily::edge_on_edge:
            return "edge on edge";
        case HardFamily::vertex_on_face:
            return "vertex on face";
        case HardFamily::vertex_near_face:
            return "vertex near face";
        case HardFamily::integer_rotations:
            return "integer rotations";
        case HardFamily::vertex_on_face_integer:
            return "vertex on face, integer rotations";
        case HardFamily::vertex_near_face_integer:
            return "vertex near face, integer rotations";
        case HardFamily::permutations:
            return "permutation matrices";
        case HardFamily::equal_poses:
            return "equal poses";
        case HardFamily::short_coordinates:
            return "short coordinates";
        case HardFamily::far_from_origin:
            return "far from origin";
        case HardFamily::slivers:
            return "slivers";
        case HardFamily::wide_exponents:
            return "wide exponents";
        case HardFamily::scaled:
            return "scaled";
        case HardFamily::extreme_scales:
            return "extreme scales";
        case HardFamily::singular:
            return "singular";
        case HardFamily::degenerate:
            return "degenerate";
    }
    return "unknown";
}

PosedPair make_pair(HardFamily family, Random& random) {
    switch (family) {
        case HardFamily::generic:
            return generic(random);
        case HardFamily::lattice:
            return lattice(random);
        case HardFamily::lattice_one_ulp: {
            PosedPair pair = lattice(random);
            nudge_one(pair, random);
            return pair;
        }
        case HardFamily::coplanar:
            return coplanar(random);
        case HardFamily::edge_on_edge:
            return edge_on_edge(random);
        case HardFamily::vertex_on_face:
            return vertex_on_face(random, 0);
        case HardFamily::vertex_near_face:
            return vertex_on_face(random, integer(random, 1, 2));
        case HardFamily::integer_rotations:
            return integer_rotations(random);
        case HardFamily::vertex_on_face_integer:
            return vertex_on_face_integer(random, 0);
        case HardFamily::vertex_near_face_integer:
            return vertex_on_face_integer(random, integer(random, 1, 2));
        case HardFamily::permutations:
            return permutations(random);
        case HardFamily::equal_poses:
            return lattice(random);
        case HardFamily::short_coordinates:
            return short_coordinates(random);
        case HardFamily::far_from_origin:
            return far_from_origin(random);
        case HardFamily::slivers:
            return slivers(random);
        case HardFamily::wide_exponents:
            return wide_exponents(random);
        case HardFamily::scaled:
            return scaled(random, -300, 300);
        case HardFamily::extreme_scales:
            return coin(random) ? scaled(random, -1060, -1000) : scaled(random, 900, 1000);
        case HardFamily::singular:
            return singular(random);
        case HardFamily::degenerate:
            return degenerate(random);
    }
    return generic(random);
}

}  // namespace ecods::scenes
