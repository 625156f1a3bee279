#include "suites/stability_families.hpp"

#include <fmt/core.h>

#include <cmath>

namespace ecods::bench {
namespace {

using scenes::PosedPair;
using scenes::Random;

// With a full mantissa, unlike Random::uniform.
double coordinate(Random& random) {
    const double high = random.uniform(-1, 1);
    return high + random.uniform(0, 1) * 0x1p-32;
}

PosedPair make_pair(const char* hard_family, Random& random) {
    return scenes::family_named(scenes::hard_families(), hard_family).make(random);
}

// Every other pair is exact contact by construction, as far as it is contact; in the rest one coordinate is one ulp
// off.
PosedPair lattice(Random& random) {
    return make_pair(random.below(2) == 0 ? "lattice" : "lattice, one ulp", random);
}

PosedPair far_from_origin(Random& random, double distance) {
    PosedPair pair = lattice(random);
    for (int k = 0; k < 3; ++k) pair.pose_a.t[k] = coordinate(random) * distance;
    pair.pose_b.t = pair.pose_a.t;
    return pair;
}

// The third corner is this fraction beside the middle of the edge of the other two; every other pair shares a corner.
PosedPair sliver(Random& random, double thickness) {
    PosedPair pair = make_pair("lattice", random);
    for (auto* t : {&pair.a, &pair.b}) {
        (*t)[2] = 0.5 * ((*t)[0] + (*t)[1]) + thickness * ((*t)[2] - (*t)[0]);
    }
    if (random.below(2) == 0) pair.b[0] = pair.a[2];
    return pair;
}

PosedPair scaled(Random& random, double exponent) {
    PosedPair pair = lattice(random);
    const double scale = std::ldexp(1.0, static_cast<int>(exponent));
    for (auto* t : {&pair.a, &pair.b}) {
        for (Vec3& corner : *t) corner *= scale;
    }
    pair.pose_a.t *= scale;
    pair.pose_b.t *= scale;
    return pair;
}

template <class Make>
StabilityFamily family(std::string name, Parameter parameter, double value, std::size_t pair_count, Make&& make) {
    StabilityFamily result{std::move(name), parameter, value, {}};
    Random random(static_cast<std::uint32_t>(1 + static_cast<int>(parameter)));
    result.pairs.reserve(pair_count);
    for (std::size_t i = 0; i < pair_count; ++i) result.pairs.push_back(make(random));
    return result;
}

}  // namespace

std::vector<StabilityFamily> stability_families(std::size_t pair_count) {
    std::vector<StabilityFamily> families;
    const auto add = [&](std::string name, Parameter parameter, double value, auto&& make) {
        families.push_back(family(std::move(name), parameter, value, pair_count, make));
    };
    const std::pair<const char*, const char*> plain[] = {
        {"generic", "generic (control)"},
        {"coplanar", "coplanar"},
        {"vertex on face", "vertex on face"},
        {"vertex near face", "vertex near face, 1 or 2 ulp"},
        {"edge on edge", "edge on edge"},
        {"lattice, one ulp", "lattice, one ulp"},
        {"vertex on face, integer rotations", "vertex on face, own rotations"},
    };
    for (const auto& [hard, name] : plain) {
        add(name, Parameter::none, 0, [hard = hard](Random& random) { return make_pair(hard, random); });
    }
    for (const double distance : {1e0, 1e3, 1e6, 1e9, 1e12}) {
        add(fmt::format("10^{:.0f} from the origin", std::log10(distance)), Parameter::distance, distance,
            [=](Random& random) { return far_from_origin(random, distance); });
    }
    for (const double exponent : {0., -10., -20., -30., -40.}) {
        add(fmt::format("slivers, thickness 2^{:.0f}", exponent), Parameter::thickness_exponent, exponent,
            [=](Random& random) { return sliver(random, std::ldexp(1.0, static_cast<int>(exponent))); });
    }
    for (const double exponent : {-300., -200., -100., 0., 100., 200., 300.}) {
        add(fmt::format("scale 2^{:.0f}", exponent), Parameter::scale_exponent, exponent,
            [=](Random& random) { return scaled(random, exponent); });
    }
    return families;
}

}  // namespace ecods::bench
