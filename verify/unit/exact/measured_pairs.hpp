// Pairs of triangles whose distances are hard to find, and the environments to find them in.
#pragma once

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "ecods/mesh.hpp"
#include "environment/float_mode.hpp"
#include "exact/point/frame.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::exact {

using scenes::PosedPair;
using scenes::Random;

// Rounding to nearest, up, down and to zero; and to nearest with subnormals flushed, in operands and results.
inline constexpr int flushing = -1;
inline constexpr std::array environments{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO, flushing};

template <class Evaluate>
[[gnu::noinline]] auto in_environment(int which, Evaluate evaluate) {
    const bool flushes = which == flushing;
    const environment::InFloatMode in_mode({"", flushes ? FE_TONEAREST : which, flushes});
    return evaluate();
}

// Two meshes of one triangle each, posed.
class OnePair {
  public:
    explicit OnePair(const PosedPair& pair) : pair_(pair) {
        a_ = scenes::one_triangle(pair.a);
        b_ = scenes::one_triangle(pair.b);
        extent_a_ = measure(*a_);
        extent_b_ = measure(*b_);
    }
    BodyRef a() const { return {a_.get(), &extent_a_, &pair_.pose_a}; }
    BodyRef b() const { return {b_.get(), &extent_b_, &pair_.pose_b}; }

  private:
    PosedPair pair_;
    std::shared_ptr<const Mesh> a_, b_;
    MeshExtent extent_a_, extent_b_;
};

inline Vec3 random_point(Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// Random triangles of size 1, of which `needle` makes the third corner one near the first.
inline PosedPair random_pair(Random& random, double needle = 1) {
    PosedPair pair{};
    for (auto* corners : {&pair.a, &pair.b}) {
        for (Vec3& v : *corners) v = random_point(random);
        if (needle < 1) (*corners)[2] = (*corners)[0] + needle * random_point(random);
    }
    pair.pose_a.R = random.rotation().toRotationMatrix();
    pair.pose_b.R = random.rotation().toRotationMatrix();
    return pair;
}

// Moves the second body so that a point of its triangle is about `gap` from one of the first, along a direction. The
// points are corners, on edges or inside.
inline PosedPair at_gap(Random& random, PosedPair pair, double gap) {
    const auto point = [&](const Pose& pose, const std::array<Vec3, 3>& corners) {
        double s = random.uniform(0, 1), t = random.uniform(0, 1);
        const std::uint32_t kind = random.below(4);
        if (kind == 0) s = t = 0;
        if (kind == 1) t = 0;
        if (s + t > 1) s = 1 - s, t = 1 - t;
        return Vec3(pose.R * (corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0])) + pose.t);
    };
    const Vec3 p = point(pair.pose_a, pair.a), q = point(pair.pose_b, pair.b);
    const auto normal = [](const Pose& pose, const std::array<Vec3, 3>& c) {
        return Vec3((pose.R * (c[1] - c[0])).cross(pose.R * (c[2] - c[0])).normalized());
    };
    Vec3 n = random.below(2) == 0 ? normal(pair.pose_a, pair.a) : normal(pair.pose_b, pair.b);
    if (random.below(3) == 0) {
        n = (pair.pose_a.R * (pair.a[1] - pair.a[0])).cross(pair.pose_b.R * (pair.b[1] - pair.b[0])).normalized();
    }
    pair.pose_b.t += p - q + gap * n;
    return pair;
}

// Two faces in parallel planes, of coordinates on a grid, in one rotation for both or in the axes.
inline PosedPair parallel_pair(Random& random, bool rotated, double gap) {
    PosedPair pair{};
    const auto grid = [&] { return 0.1 * random.below(11); };
    for (Vec3& v : pair.a) v = {grid(), grid(), 0};
    for (Vec3& v : pair.b) v = {grid(), grid(), gap};
    if (rotated) pair.pose_a.R = pair.pose_b.R = random.rotation().toRotationMatrix();
    pair.pose_a.t = pair.pose_b.t = random_point(random);
    return pair;
}

inline PosedPair scaled_by(PosedPair pair, int exponent) {
    for (auto* corners : {&pair.a, &pair.b}) {
        for (Vec3& v : *corners) {
            for (int k = 0; k < 3; ++k) v[k] = std::ldexp(v[k], exponent);
        }
    }
    for (Pose* pose : {&pair.pose_a, &pair.pose_b}) {
        for (int k = 0; k < 3; ++k) pose->t[k] = std::ldexp(pose->t[k], exponent);
    }
    return pair;
}

inline double some_gap(Random& random) {
    return std::ldexp(1.0, -static_cast<int>(random.below(45)));
}

// Up to 2^2047 and down to 2^-2148: integers of all widths, and distances beyond the largest double.
inline PosedPair any_exponents(Random& r) {
    const int range = std::min(1023, 1 + static_cast<int>(r.below(8)) * 150);
    const auto any = [&] {
        const int exponent = static_cast<int>(r.below(static_cast<std::uint32_t>(2 * range))) - range;
        return r.below(5) == 0 ? 0.0 : std::ldexp(r.uniform(-1, 1), exponent);
    };
    PosedPair pair{};
    for (auto* corners : {&pair.a, &pair.b}) {
        for (Vec3& v : *corners) v = {any(), any(), any()};
    }
    for (Pose* pose : {&pair.pose_a, &pair.pose_b}) {
        for (int k = 0; k < 9; ++k) pose->R.data()[k] = any();
        pose->t = {any(), any(), any()};
    }
    return pair;
}

// Small integers, under translations with more digits than what they move.
inline PosedPair short_pair(Random& r) {
    PosedPair pair{};
    for (auto* corners : {&pair.a, &pair.b}) {
        for (Vec3& v : *corners) v = {r.below(5) - 2.0, r.below(5) - 2.0, r.below(5) - 2.0};
    }
    pair.pose_a.t = random_point(r);
    pair.pose_b.t = std::ldexp(1.0, static_cast<int>(r.below(60)) - 30) * random_point(r);
    return pair;
}

inline PosedPair short_and_flat(Random& r) {
    PosedPair pair{};
    for (auto* corners : {&pair.a, &pair.b}) {
        for (Vec3& v : *corners) v = {r.below(3) - 1.0, r.below(3) - 1.0, r.below(2) * 1.0};
    }
    pair.pose_b.t = {0, 0, r.below(3) - 1.0};
    return pair;
}

inline PosedPair far_pair(Random& r) {
    PosedPair pair = at_gap(r, random_pair(r), some_gap(r));
    const Vec3 shift = 0x1p50 * random_point(r);
    pair.pose_a.t += shift;
    pair.pose_b.t += shift;
    return pair;
}

inline PosedPair modelled_far_off(Random& r) {
    PosedPair pair = random_pair(r);
    for (Vec3& v : pair.b) v += 1e8 * random_point(r);
    return at_gap(r, pair, some_gap(r));
}

inline scenes::Families<PosedPair> measured_families() {
    static const auto below = [](Random& r, std::uint32_t count) { return static_cast<int>(r.below(count)); };
    static const scenes::Family<PosedPair> families[] = {
        {"random", [](Random& r) { return random_pair(r); }},
        {"gap", [](Random& r) { return at_gap(r, random_pair(r), some_gap(r)); }},
        {"needles", [](Random& r) { return at_gap(r, random_pair(r, std::ldexp(1.0, -below(r, 50))), some_gap(r)); }},
        {"parallel on a grid", [](Random& r) { return parallel_pair(r, false, 0.1 * (1 + r.below(3))); }},
        {"parallel, rotated", [](Random& r) { return parallel_pair(r, true, some_gap(r)); }},
        {"far", far_pair},
        {"modelled far off", modelled_far_off},
        {"scaled", [](Random& r) { return scaled_by(at_gap(r, random_pair(r), some_gap(r)), below(r, 1801) - 900); }},
        {"subnormal", [](Random& r) { return scaled_by(at_gap(r, random_pair(r), 1), -1040 - below(r, 34)); }},
        {"any exponents", any_exponents},
        {"short, moved", short_pair},
        {"short and flat", short_and_flat},
    };
    return families;
}

// Calls check(name, pair) for `count` pairs of every family, those of scenes/hard_pairs.hpp included.
template <class Check>
void for_each_pair(int count, Check check) {
    Random random(14);
    for (const scenes::Families<PosedPair> families : {measured_families(), scenes::hard_families()}) {
        for (const auto& family : families) {
            for (int i = 0; i < count; ++i) check(std::string(family.name), family.make(random));
        }
    }
}

}  // namespace ecods::exact
