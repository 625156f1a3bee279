// Points of four, five and seven bodies in one frame: every sign of them is that of the rational numbers, whatever the
// poses, in every rounding mode.

#include "exact/point/frame.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cfenv>
#include <cmath>
#include <map>
#include <memory>

#include "ecods/mesh.hpp"
#include "ecods/primitives.hpp"
#include "exact/sign/frame_signs.hpp"
#include "oracle_pair.hpp"

namespace ecods::exact::frame_test {
namespace {

constexpr std::array rounding_modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

int minor_sign(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, int axis) {
    const auto i = static_cast<std::size_t>((axis + 1) % 3), j = static_cast<std::size_t>((axis + 2) % 3);
    return sgn(mpq_class((b[i] - a[i]) * (c[j] - a[j]) - (b[j] - a[j]) * (c[i] - a[i])));
}

int determinant_sign(const RationalPoint& a, const RationalPoint& b, const RationalPoint& c, const RationalPoint& d) {
    return sgn(dot(b - a, cross(c - a, d - a)));
}

Mat3 signed_permutation(Random& random) {
    Mat3 R = Mat3::Zero();
    const auto shift = random.below(3);
    for (std::uint32_t i = 0; i < 3; ++i) R(i, (shift + i) % 3) = random.below(2) == 0 ? 1 : -1;
    return R;
}

Vec3 lattice_point(Random& random, std::uint32_t size) {
    Vec3 v;
    for (int k = 0; k < 3; ++k) v[k] = static_cast<double>(random.below(size)) - (size - 1) / 2;
    return v;
}

// Poses from short to as long as doubles can be, sheared and singular ones among them.
Pose make_pose(Random& random, std::uint32_t kind) {
    Pose pose;
    const double power = std::ldexp(1.0, static_cast<int>(random.below(600)) - 300);
    switch (kind) {
        case 0:  // short, and the same unit everywhere
            pose.R = signed_permutation(random);
            pose.t = lattice_point(random, 9);
            break;
        case 1:  // sheared by integers
            pose.R = signed_permutation(random);
            pose.R(0, 1) += static_cast<double>(random.below(1000));
            pose.t = lattice_point(random, 1001);
            break;
        case 2:  // coordinates that are doubles, of nearly all their bits
            pose.R = signed_permutation(random) * (1 + std::floor(random.uniform(0, 0x1p40)));
            pose.t = lattice_point(random, 5) * 0x1p40;
            break;
        case 3:
            pose.R = random.rotation().toRotationMatrix();
            pose.t = random.direction();
            break;
        case 4:  // far from each other
            pose.R = random.rotation().toRotationMatrix();
            pose.t = 0x1p40 * random.direction();
            break;
        case 5:  // huge or tiny
            pose.R = power * random.rotation().toRotationMatrix();
            pose.t = power * random.direction();
            break;
        case 6:  // one column of another size: many limbs
            pose.R = random.rotation().toRotationMatrix();
            pose.R.col(random.below(3)) *= power;
            pose.t = random.direction();
            break;
        case 7:  // singular
            pose.R = random.rotation().toRotationMatrix();
            pose.R.row(random.below(3)).setZero();
            break;
        default:  // subnormal products, and the largest numbers
            pose.R = std::ldexp(1.0, random.below(2) == 0 ? -1070 : 1015) * signed_permutation(random);
            pose.t = lattice_point(random, 3) * 0x1p-1074;
    }
    return pose;
}
constexpr std::uint32_t pose_kind_count = 9;

// N bodies, of which some have one pose in common, with vertices of which many are in one plane or on one line.
template <std::size_t N>
struct Scene {
    std::array<std::shared_ptr<const Mesh>, N> meshes;
    std::array<MeshExtent, N> extents;
    std::array<Pose, N> poses;
    std::array<VertexRef, N> vertices;
    std::array<RationalPoint, N> points;

    Scene(Random& random, std::uint32_t kind) {
        const auto distinct = 1 + random.below(N);
        // A length that all share has few bits counted in itself; an odd number of 31 bits is not short.
        const double length = random.below(2) == 0 ? 1 : 2.0 * random.below(1u << 30) + 1;
        for (std::size_t i = 0; i < N; ++i) {
            const std::size_t like = i < distinct ? i : random.below(distinct);
            // One body of a generic kind can be among short ones.
            const std::uint32_t own_kind = random.below(8) == 0 ? random.below(pose_kind_count) : kind;
            poses[i] = like < i ? poses[like] : make_pose(random, own_kind);
            if (like == i && length != 1 && own_kind == 0) poses[i].t *= length;
            std::vector<Vec3> corners;
            for (int corner = 0; corner < 4; ++corner) corners.push_back(length * lattice_point(random, 5));
            const std::uint32_t vertex = random.below(4);
            vertices[i] = {i, vertex};
            points[i] = rational(poses[i], corners[vertex]);
            meshes[i] = Mesh::create(std::move(corners), {{0, 1, 2}, {1, 2, 3}});
            extents[i] = measure(*meshes[i]);
        }
    }
    std::array<BodyRef, N> bodies() const {
        std::array<BodyRef, N> result;
        for (std::size_t i = 0; i < N; ++i) result[i] = {meshes[i].get(), &extents[i], &poses[i]};
        return result;
    }
    const Vec3& vertex(std::size_t i) const { return meshes[i]->vertices()[vertices[i].vertex]; }
};

// All signs of N points: of every four, of every three in each projection, of every two, and the rest once.
template <std::size_t N, class Signs>
std::vector<int> all_signs(Signs& signs) {
    std::vector<int> result;
    const int count = static_cast<int>(N);
    for (int a = 0; a < count; ++a) {
        for (int b = a + 1; b < count; ++b) {
            for (int axis = 0; axis < 3; ++axis) result.push_back(signs.compare(a, b, axis));
            for (int c = b + 1; c < count; ++c) {
                for (int axis = 0; axis < 3; ++axis) result.push_back(signs.orient2d(b, c, a, axis));
                for (int d = c + 1; d < count; ++d) result.push_back(signs.orient3d(d, b, a, c));
            }
        }
    }
    for (const int side : signs.sides(count - 3, 0)) result.push_back(side);
    const int axis = signs.normal_axis(0);
    result.push_back(axis < 0 ? 0 : std::abs(signs.orient2d(0, 1, 2, axis)));
    return result;
}

// The same of rational numbers.
template <std::size_t N>
struct RationalSigns {
    const std::array<RationalPoint, N>& points;

    const RationalPoint& at(int i) const { return points[static_cast<std::size_t>(i)]; }
    int compare(int a, int b, int axis) const {
        const auto k = static_cast<std::size_t>(axis);
        return sgn(mpq_class(at(a)[k] - at(b)[k]));
    }
    int orient2d(int a, int b, int c, int axis) const { return minor_sign(at(a), at(b), at(c), axis); }
    int orient3d(int a, int b, int c, int d) const { return determinant_sign(at(a), at(b), at(c), at(d)); }
    Sides sides(int plane, int p) const {
        return {orient3d(plane, plane + 1, plane + 2, p), orient3d(plane, plane + 1, plane + 2, p + 1),
                orient3d(plane, plane + 1, plane + 2, p + 2)};
    }
    int normal_axis(int plane) const {
        for (int axis = 0; axis < 3; ++axis) {
            if (orient2d(plane, plane + 1, plane + 2, axis) != 0) return axis;
        }
        return -1;
    }
};

// One frame for all scenes of any number of bodies: nothing of the bodies before is left in it.
struct Checked {
    Frame frame;
    std::map<Arithmetic, int> arithmetics;
    std::array<int, 3> sign_counts{};

    template <std::size_t N>
    void check(const Scene<N>& scene) {
        RationalSigns<N> rational{scene.points};
        const std::vector<int> expected = all_signs<N>(rational);
        for (const int sign : expected) ++sign_counts[static_cast<std::size_t>(sign + 1)];
        for (const int mode : rounding_modes) {
            const auto of_frame = in_environment(mode, [&] {
                const auto bodies = scene.bodies();
                frame.bind(bodies);
                return with_signs(frame, scene.vertices, [](auto& signs) { return all_signs<N>(signs); });
            });
            ASSERT_EQ(of_frame, expected) << mode;
            const auto of_points = in_environment(mode, [&] { return signs_without_meshes(scene); });
            ASSERT_EQ(of_points, expected) << mode;
        }
        ++arithmetics[frame.arithmetic()];
    }

    // As the public predicates do it, for any number of points.
    template <std::size_t N>
    static std::vector<int> signs_without_meshes(const Scene<N>& scene) {
        PosedPoints<N> exact;
        for (std::size_t i = 0; i < N; ++i) exact[i] = {&scene.poses[i], &scene.vertex(i)};
        const RoundedPoints<N> rounded = round_points(exact);
        const DeterminantBounds bounds = determinant_bounds(rounded.points, rounded.delta);
        return with_integers(exact, [&](const auto& integers) {
            FilteredSigns signs(rounded.points, bounds, integers);
            return all_signs<N>(signs);
        });
    }
};

TEST(Frame, SignsOfFourFiveAndSevenBodies) {
    Random random(61);
    Checked checked;
    for (int i = 0; i < 900; ++i) {
        SCOPED_TRACE(i);
        const auto kind = static_cast<std::uint32_t>(i) % pose_kind_count;
        checked.check(Scene<7>(random, kind));
        checked.check(Scene<4>(random, kind));
        checked.check(Scene<5>(random, kind));
        if (HasFatalFailure()) return;
    }
    for (const Arithmetic arithmetic : {Arithmetic::plain, Arithmetic::differences, Arithmetic::one_limb,
                                        Arithmetic::two_limbs, Arithmetic::many_limbs}) {
        EXPECT_GT(checked.arithmetics[arithmetic], 20) << static_cast<int>(arithmetic);
    }
    EXPECT_EQ(checked.arithmetics[Arithmetic::unknown], 0);
    for (const int count : checked.sign_counts) EXPECT_GT(count, 10000);
}

// The bound for all points of a frame holds for each of its signs, before anything is known of digits.
TEST(Frame, OneBoundForAllBodies) {
    Random random(62);
    Frame frame;
    int certain = 0;
    for (int i = 0; i < 2000; ++i) {
        const Scene<5> scene(random, 3 + random.below(5));
        const RationalSigns<5> expected{scene.points};
        const auto bodies = scene.bodies();
        for (const int mode : rounding_modes) {
            const auto found = in_environment(mode, [&] {
                frame.bind(bodies);
                const Points<5> w = frame.rounded(scene.vertices);
                const double bound = orient3d_bound(frame);
                return std::array{certain_sign(plain_orient3d(w[4], w[1], w[2], w[3]), bound),
                                  certain_sign(plain_orient3d(w[0], w[4], w[3], w[2]), bound)};
            });
            certain += found[0] != 0;
            ASSERT_TRUE(found[0] == 0 || found[0] == expected.orient3d(4, 1, 2, 3)) << i;
            ASSERT_TRUE(found[1] == 0 || found[1] == expected.orient3d(0, 4, 3, 2)) << i;
        }
    }
    EXPECT_GT(certain, 500);
}

// The public predicates, with points of up to four bodies.
TEST(Frame, PredicatesOfFourBodies) {
    Random random(63);
    for (int i = 0; i < 4000; ++i) {
        const Scene<4> scene(random, static_cast<std::uint32_t>(i) % pose_kind_count);
        const auto at = [&](std::size_t k) { return PosedPoint{scene.poses[k], scene.vertex(k)}; };
        const auto& p = scene.points;
        for (const int mode : rounding_modes) {
            const Sign side = in_environment(mode, [&] { return orient3d(at(0), at(1), at(2), at(3)); });
            ASSERT_EQ(static_cast<int>(side), determinant_sign(p[0], p[1], p[2], p[3])) << i;
            for (int axis = 0; axis < 3; ++axis) {
                const Sign turn = in_environment(mode, [&] { return orient2d(at(1), at(2), at(3), axis); });
                ASSERT_EQ(static_cast<int>(turn), minor_sign(p[1], p[2], p[3], axis)) << i;
            }
        }
    }
}

}  // namespace
}  // namespace ecods::exact::frame_test
