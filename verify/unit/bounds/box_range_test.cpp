// Boxes at the ends of the range of doubles contain the exact body, and are as tight as elsewhere: judged in rationals.
#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>
#include <vector>

#include "bounds/support_table.hpp"
#include "ecods/primitives.hpp"
#include "environment/each_environment.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::box_range_test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity(), largest = std::numeric_limits<double>::max();

// The least box of the real points, and the largest of |R| v_max + |t|.
struct Truth {
    mpq_class min[3], max[3], sum;

    Truth(const Mesh& mesh, const Pose& pose) {
        Vec3 v_max = Vec3::Zero();
        bool is_first = true;
        for (const Vec3& v : mesh.vertices()) {
            v_max = v_max.cwiseMax(v.cwiseAbs());
            for (int i = 0; i < 3; ++i) {
                mpq_class x(pose.t[i]);
                for (int j = 0; j < 3; ++j) x += mpq_class(pose.R(i, j)) * mpq_class(v[j]);
                if (is_first || x < min[i]) min[i] = x;
                if (is_first || x > max[i]) max[i] = x;
            }
            is_first = false;
        }
        for (int i = 0; i < 3; ++i) {
            mpq_class s(std::abs(pose.t[i]));
            for (int j = 0; j < 3; ++j) s += mpq_class(std::abs(pose.R(i, j))) * mpq_class(v_max[j]);
            sum = std::max(sum, s);
        }
    }

    // Each end is outside the exact one by no more than `excess`, and by as little as there are doubles.
    testing::AssertionResult are_right(const Aabb& box, const mpq_class& excess) const {
        for (int k = 0; k < 3; ++k) {
            for (const bool is_max : {false, true}) {
                const double end = is_max ? box.max[k] : -box.min[k];
                const mpq_class exact = is_max ? max[k] : mpq_class(-min[k]);
                if (std::isnan(end)) return testing::AssertionFailure() << "NaN on axis " << k;
                if (end == -infinity) return testing::AssertionFailure() << "an empty box on axis " << k;
                if (end > -largest && exact + excess < (end < infinity ? mpq_class(end) : mpq_class(largest))) {
                    return testing::AssertionFailure() << "too large on axis " << k << ": " << end;
                }
                if (end < infinity && mpq_class(end) < exact) {
                    return testing::AssertionFailure() << "too small on axis " << k << ": " << end;
                }
            }
        }
        return testing::AssertionSuccess();
    }

    // 18 u (|R| v_max + |t|), less than primitives.hpp promises, and the distance of two doubles, where these end.
    mpq_class promised_excess() const { return sum * mpq_class(18 * 0x1p-53) + mpq_class(0x1p-1073); }
};

// Any finite double of about this exponent; or none that is so small.
double number(scenes::Random& random, int exponent) {
    const double x = std::ldexp(random.uniform(-1, 1), std::min(exponent, 1024));
    return std::isfinite(x) ? x : std::copysign(largest, x);
}

std::shared_ptr<const Mesh> mesh_of_size(scenes::Random& random, int exponent) {
    std::vector<Vec3> vertices;
    for (int i = 0; i < 4; ++i) {
        vertices.emplace_back(number(random, exponent), number(random, exponent), number(random, exponent));
    }
    return Mesh::create(std::move(vertices), {{0, 1, 2}, {1, 2, 3}});
}

// From all numbers near an end of the range to sums that are beyond it, on one axis or on all.
TEST(BoxRange, BoxesOfVerticesAreTightToTheEnds) {
    scenes::Random random(41);
    std::vector<int> exponents{-1074, -1060, -1022, -1010, -1000, -990, -960, -930, -900, 0, 900, 960, 1000};
    for (int e = 1006; e <= 1026; ++e) exponents.push_back(e);
    int infinite_count = 0, half_infinite_count = 0;
    for (const int size : exponents) {
        for (int i = 0; i < 24; ++i) {
            const int of_vertices = i % 3 == 0 ? size : i % 3 == 1 ? 0 : size / 2;
            const auto mesh = mesh_of_size(random, std::min(of_vertices, 1024));
            Pose pose = random.turned();
            if (i % 3 == 2) pose.R = Mat3::Identity();
            for (int k = 0; k < 9; ++k)
                pose.R.data()[k] = std::ldexp(pose.R.data()[k], std::min(size - of_vertices, 1023));
            for (int k = 0; k < 3; ++k) pose.t[k] = k > 0 && i % 4 == 1 ? number(random, 0) : number(random, size);
            if (i % 4 == 3) pose.t.setZero();
            const Truth truth(*mesh, pose);
            environment::in_each_environment(
                [&] { return box_of(*mesh, pose); },
                [&](const Aabb& box, const std::string& where) {
                    EXPECT_TRUE(truth.are_right(box, truth.promised_excess())) << where << ' ' << size << ' ' << i;
                    const bool ends[] = {std::isfinite(box.min[0]), std::isfinite(box.max[0])};
                    infinite_count += !ends[0] || !ends[1];
                    half_infinite_count += ends[0] != ends[1];
                });
        }
    }
    EXPECT_GT(infinite_count, 100);
    EXPECT_GT(half_infinite_count, 100);
}

// One axis that overflows says nothing about the others.
TEST(BoxRange, AxesOverflowByThemselves) {
    const auto cube = scenes::cube(0.5);
    Pose pose;
    pose.t = {0, 0, -2};
    for (const double x : {1.0, 1e305, 1e308}) {
        pose.t[0] = x;
        const Aabb box = box_of(*cube, pose);
        EXPECT_NEAR(box.min[0], x, 0x1p-48 * x + 1);
        EXPECT_NEAR(box.max[2], -1.5, 0x1p-48 * x);
    }
    pose.R(0, 0) = pose.t[0] = largest;
    const Aabb box = box_of(*cube, pose);
    EXPECT_GT(box.min[0], 0.49 * pose.t[0]);
    EXPECT_EQ(box.max[0], infinity);
    EXPECT_LT(box.max[1], 1e294);
    EXPECT_TRUE(std::isfinite(box.min[1]));
    EXPECT_EQ(box_of(*cube, {Mat3::Zero(), Vec3::Zero()}), Aabb());
}

// By the table: some poses at once are given the bits of each, and no end is further out than half the diagonal.
TEST(BoxRange, BoxesByTheTableAreTightToTheEnds) {
    scenes::Random random(43);
    for (const int of_mesh : {-890, 0, 880}) {
        const auto mesh = scenes::mapped(*scenes::sphere(12, 8), [&](const Vec3& v) {
            return Vec3(std::ldexp(v[0], of_mesh), std::ldexp(v[1], of_mesh), std::ldexp(v[2], of_mesh));
        });
        const LocalFrame frame = fit_frame(*mesh);
        const SupportTable table(*mesh, frame);
        std::vector<Pose> poses;
        for (const int size :
             {-1060, -1022, -1000, -960, -900, 0, 900, 1000, 1010, 1018, 1019, 1020, 1021, 1022, 1023, 1024}) {
            for (int i = 0; i < 6; ++i) {
                Pose& pose = poses.emplace_back(random.turned());
                const int by = std::min(size - of_mesh - (i % 3 == 0 ? 20 : 0), 1023);
                for (int k = 0; k < 9; ++k) pose.R.data()[k] = std::ldexp(pose.R.data()[k], by);
                for (int k = 0; k < 3; ++k) pose.t[k] = k > 0 && i % 2 == 1 ? 1 : number(random, size);
            }
        }
        std::vector<Truth> truths;
        std::vector<mpq_class> excesses;
        for (const Pose& pose : poses) {
            const Truth& truth = truths.emplace_back(*mesh, pose);
            mpq_class size = 0;
            for (int k = 0; k < 3; ++k) size = std::max(size, mpq_class(truth.max[k] - truth.min[k]));
            excesses.push_back(truth.promised_excess() + size / 4);
        }
        const auto boxes_of_all = [&] {
            std::vector<Aabb> boxes(poses.size()), each;
            std::vector<const Pose*> at;
            std::vector<Aabb*> to;
            for (std::size_t i = 0; i < poses.size(); ++i) {
                at.push_back(&poses[i]);
                to.push_back(&boxes[i]);
                each.push_back(table.box(poses[i]));
            }
            table.boxes(at, to);
            EXPECT_EQ(std::memcmp(boxes.data(), each.data(), boxes.size() * sizeof(Aabb)), 0);
            return boxes;
        };
        environment::in_each_environment(boxes_of_all, [&](const std::vector<Aabb>& boxes, const std::string& where) {
            for (std::size_t i = 0; i < poses.size(); ++i) {
                EXPECT_TRUE(truths[i].are_right(boxes[i], excesses[i])) << where << ' ' << of_mesh << ' ' << i;
            }
        });
    }
}

}  // namespace
}  // namespace ecods::box_range_test
