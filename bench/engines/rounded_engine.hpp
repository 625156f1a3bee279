// Do two bodies of spheres, capsules and boxes touch, how far are they from each other, and where?
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "ecods/pose.hpp"
#include "engines/engine.hpp"

namespace ecods::bench {

// A sphere around the origin, a capsule whose axis is the z axis from -size to size, or a solid cube from -size to size
// on each axis.
enum class RoundKind : std::uint8_t { sphere, capsule, box };
struct RoundBody {
    RoundKind kind = RoundKind::sphere;
    double radius = 0;  // not of a box
    double size = 0;    // not of a sphere

    double reach() const { return kind == RoundKind::box ? 2 * size : size + radius; }  // all of it is within
};

struct BodyAt {
    std::size_t body_index = 0;
    Pose pose;
};
struct RoundQuery {
    BodyAt a, b;
};

enum class RoundQuestion : std::uint8_t { intersects, distance, signed_distance, closest };

struct RoundWorkload {
    std::string name;
    RoundQuestion question;
    std::vector<RoundBody> bodies;
    std::vector<RoundQuery> queries;
};

// The number is 1 or 0 if the question is whether two bodies touch. Points are those of closest(); others are zero.
struct RoundAnswer {
    double number = 0;
    std::array<double, 6> points = {};

    friend bool operator==(const RoundAnswer&, const RoundAnswer&) = default;
};

struct Round {
    using Workload = RoundWorkload;
    using Answer = RoundAnswer;
    using Engine = QueryEngine<Round>;
    struct Traits {};
};

using RoundMaker = Maker<Round>;

std::vector<RoundMaker> ecods_round();
std::vector<RoundMaker> fcl_round();
std::vector<RoundMaker> bullet_round();

// All of the above. Ratios are taken to the last two.
std::vector<RoundMaker> round_engines();
constexpr const char* round_fcl = "FCL shapes";
constexpr const char* round_bullet = "Bullet shapes";

}  // namespace ecods::bench
