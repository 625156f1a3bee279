// No bound of a time is above the time at which two triangles first share a point, however hard it is tried; most pairs
// that never do are left out.
#include "bvh/axes/swept_axes.hpp"

#include <gtest/gtest.h>

#include "environment/float_mode.hpp"
#include "oracle/first_contact.hpp"
#include "scenes/cast_cases.hpp"
#include "scenes/shapes.hpp"
#include "unit/bvh/tree_body.hpp"

namespace ecods::swept_axes_test {
namespace {

// Two bodies, their bounds in the environment that is set, and what is true.
struct Pair {
    Body a, b;
    Vec3 motion;
    std::optional<oracle::ExactContact> truth;
    SweptAxes axes;

    explicit Pair(const scenes::CastCase& c)
        : a(c.a, c.pose_a),
          b(c.b, c.pose_b),
          motion(c.motion),
          truth(oracle::first_contact(a.soup(), c.motion, b.soup())) {}

    bool bind(double latest) { return axes.bind(a.posed(), b.posed(), b.pose.t - a.pose.t, motion, latest); }
};

// swept_mask() of every instruction set.
template <class X, class Y>
std::uint64_t swept_mask_of(const Pair& pair, float limit, const X& x, const Y& y, LaneBounds& times) {
    return mask_of_all(times, [&](LaneBounds& numbers) { return swept_mask(pair.axes.sets(), limit, x, y, numbers); });
}

// Whether the trees let triangles i and j through to the leaves, from the roots down, where nothing after the limit
// matters.
bool let_through(const Pair& pair, float limit, std::uint32_t i, std::uint32_t j) {
    alignas(32) LaneBounds times;
    const auto mask = [&](const auto& x, const auto& y) { return swept_mask_of(pair, limit, x, y, times); };
    return let_through(pair.a, pair.b, mask, i, j);
}

// Rounded first times of all triangles of both, by the oracle; or -1.
std::vector<double> first_times(const Pair& pair) {
    std::vector<double> times;
    for (std::uint32_t i = 0; i < pair.a.mesh->triangles().size(); ++i) {
        for (std::uint32_t j = 0; j < pair.b.mesh->triangles().size(); ++j) {
            const auto contact = oracle::first_contact(pair.a.soup_of(i), pair.motion, pair.b.soup_of(j));
            times.push_back(contact ? contact->rounded : -1);
        }
    }
    return times;
}

struct Tally {
    int missing = 0, excluded = 0;  // pairs without contact; of these, the ones that the leaves leave out
    int late = 0, narrow = 0;       // times above 0; of these, those with a bound above half of it
};

void check_leaves(Pair& pair, const std::vector<double>& truth, Tally& tally) {
    alignas(32) LaneBounds times;
    for (const TreeLeaf& x : pair.a.tree.leaves) {
        for (const TreeLeaf& y : pair.b.tree.leaves) {
            const std::uint64_t mask = swept_mask_of(pair, pair.axes.window_above(1), x, y, times);
            for (std::size_t i = 0; i < x.count; ++i) {
                for (std::size_t j = 0; j < y.count; ++j) {
                    const double time = truth[x.triangle[i] * pair.b.mesh->triangles().size() + y.triangle[j]];
                    const bool is_in = mask >> (tree_width * j + i) & 1;
                    const float bound = times[tree_width * i + j];
                    tally.missing += time < 0;
                    tally.excluded += time < 0 && !is_in;
                    if (time < 0) continue;
                    ASSERT_TRUE(is_in) << "time " << time;
                    ASSERT_LE(bound, pair.axes.window_above(time)) << "time " << time;
                    tally.late += time > 0;
                    tally.narrow += time > 0 && bound >= pair.axes.window_above(0.5 * time);
                }
            }
        }
    }
}

void check(Pair& pair, Tally& tally) {
    const std::vector<double> truth = first_times(pair);
    for (const environment::FloatMode& mode : environment::float_modes) {
        SCOPED_TRACE(mode.name);
        const environment::InFloatMode in_mode(mode);
        // The first pair is let through, at once and from the least limit on that says so.
        for (const double latest : {1.0, pair.truth ? pair.truth->rounded : 1.0}) {
            if (!pair.bind(latest)) {
                ASSERT_FALSE(pair.truth) << latest;
                continue;
            }
            if (!pair.truth) continue;
            const float limit = pair.axes.window_above(pair.truth->rounded);
            ASSERT_TRUE(let_through(pair, limit, pair.truth->a.triangle, pair.truth->b.triangle)) << latest;
        }
        if (pair.bind(1)) {
            check_leaves(pair, truth, tally);
        } else {
            tally.missing += static_cast<int>(truth.size());
            tally.excluded += static_cast<int>(truth.size());
        }
        if (testing::Test::HasFailure()) return;
    }
}

bool is_zero(const Vec3& v) {
    return v == Vec3::Zero();
}

TEST(SweptAxes, AreBounds) {
    for (const auto& family : scenes::cast_families()) {
        SCOPED_TRACE(family.name);
        scenes::Random random(11);
        Tally tally;
        for (int k = 0, pairs = 0; pairs < 2000; ++k) {
            const scenes::CastCase c = family.make(random);
            ++pairs;
            if (is_zero(c.motion) || c.a->triangles().size() * c.b->triangles().size() > 150) continue;
            pairs += static_cast<int>(c.a->triangles().size() * c.b->triangles().size());
            Pair pair(c);
            check(pair, tally);
            if (testing::Test::HasFailure()) FAIL() << "case " << k;
        }
        EXPECT_GT(tally.missing + tally.late, 0);
    }
}

// Balls that go past each other, or meet: nearly all triangles are left out, and the bounds of the others are close.
TEST(SweptAxes, AreNarrow) {
    scenes::Random random(12);
    Tally tally;
    for (int k = 0; k < 3; ++k) {
        scenes::CastCase c{scenes::sphere(6, 4), scenes::sphere(6, 4), {}, {}, {}};
        c.pose_a.R = random.rotation().toRotationMatrix();
        c.pose_b.R = random.rotation().toRotationMatrix();
        c.pose_a.t = 10 * random.direction();
        c.motion = -2 * c.pose_a.t + random.direction();
        Pair pair(c);
        const std::vector<double> truth = first_times(pair);
        ASSERT_TRUE(pair.bind(1));
        ASSERT_NO_FATAL_FAILURE(check_leaves(pair, truth, tally));
    }
    EXPECT_GT(tally.excluded, tally.missing * 8 / 10);
    EXPECT_GT(tally.narrow, tally.late * 6 / 10);
}

}  // namespace
}  // namespace ecods::swept_axes_test
