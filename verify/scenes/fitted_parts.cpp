#include "scenes/fitted_parts.hpp"

#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "scenes/mesh_builder.hpp"
#include "scenes/random.hpp"

namespace ecods::scenes {

namespace {

// The box [0, 2] x [0, 1] x [0, 1/2] moved by `offset`; each face is cut in 4 x 4 rectangles.
std::shared_ptr<const Mesh> brick(const Vec3& offset) {
    constexpr int cells = 4;
    const Vec3 cell = Vec3(2, 1, 0.5) / cells;
    MeshBuilder mesh;
    std::map<std::array<int, 3>, std::uint32_t> known;
    const auto corner = [&](const std::array<int, 3>& at) {
        const auto [place, is_new] = known.try_emplace(at, 0);
        if (is_new) place->second = mesh.add(offset + Vec3(at[0] * cell[0], at[1] * cell[1], at[2] * cell[2]));
        return place->second;
    };
    for (std::size_t axis = 0; axis < 3; ++axis) {
        for (const bool is_upper : {false, true}) {
            for (int i = 0; i < cells; ++i) {
                for (int k = 0; k < cells; ++k) {
                    const auto at = [&](int di, int dk) {
                        std::array<int, 3> place{};
                        place[axis] = is_upper ? cells : 0;
                        place[(axis + 1) % 3] = i + di;
                        place[(axis + 2) % 3] = k + dk;
                        return corner(place);
                    };
                    if (is_upper) {
                        mesh.add_quad(at(0, 0), at(1, 0), at(1, 1), at(0, 1));
                    } else {
                        mesh.add_quad(at(0, 0), at(0, 1), at(1, 1), at(1, 0));
                    }
                }
            }
        }
    }
    return mesh.finish();
}

// Where a neighbour in the wall lies: above by half a length, beside, behind. The gap parts it.
std::array<Vec3, 3> neighbours(double gap) {
    return {Vec3(1, 0, 0.5 + gap), Vec3(2 + gap, 0.25, 0), Vec3(0.5, 1 + gap, 0.125)};
}

constexpr std::uint32_t tooth_count = 24;

// Four vertices a tooth, shrunk towards the axis by `scale`.
std::vector<Vec3> profile(double z, double scale) {
    std::vector<Vec3> points;
    for (std::uint32_t i = 0; i < 4 * tooth_count; ++i) {
        const double angle = 2 * std::numbers::pi * (i + (i % 2 == 0 ? 0.15 : -0.15)) / (4 * tooth_count);
        const double radius = (i % 4 < 2 ? 1.0 : 0.875) * scale;
        points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), z);
    }
    return points;
}

std::shared_ptr<const Mesh> shaft(double scale) {
    constexpr int bands = 7;
    MeshBuilder mesh;
    const std::uint32_t start = mesh.add({0, 0, -1.75});
    Ring last;
    for (int band = 0; band <= bands; ++band) {
        const Ring ring = mesh.add_ring(profile(-1.75 + 0.5 * band, scale));
        if (band == 0) {
            mesh.fan_from(start, ring);
        } else {
            mesh.bridge(last, ring);
        }
        last = ring;
    }
    mesh.fan_to(last, mesh.add({0, 0, 1.75}));
    return mesh.finish();
}

std::shared_ptr<const Mesh> hub() {
    constexpr int bands = 3;
    MeshBuilder mesh;
    std::vector<Ring> bore, rim;
    for (int band = 0; band <= bands; ++band) {
        const double z = -1 + 2.0 * band / bands;
        bore.push_back(mesh.add_ring(profile(z, 1)));
        std::vector<Vec3> circle;
        for (std::uint32_t i = 0; i < 4 * tooth_count; ++i) {
            const double angle = 2 * std::numbers::pi * i / (4 * tooth_count);
            circle.emplace_back(1.5 * std::cos(angle), 1.5 * std::sin(angle), z);
        }
        rim.push_back(mesh.add_ring(circle));
    }
    for (std::size_t band = 0; band < bands; ++band) {
        mesh.bridge(bore[band + 1], bore[band]);
        mesh.bridge(rim[band], rim[band + 1]);
    }
    mesh.bridge(bore.front(), rim.front());
    mesh.bridge(rim.back(), bore.back());
    return mesh.finish();
}

Pose random_pose(Random& random) {
    Pose pose{random.rotation().toRotationMatrix(), {}};
    for (int axis = 0; axis < 3; ++axis) pose.t[axis] = random.uniform(-4, 4);
    return pose;
}

}  // namespace

MeshPairs stacked_bricks(std::size_t count, std::uint32_t seed) {
    constexpr double gap = 0x1p-19;  // 2^-20 of the length, which is 2
    MeshPairs pairs{"stacked bricks", {{"brick", brick(Vec3::Zero())}}, {}};
    for (const double parted : {0.0, gap})
        for (const Vec3& place : neighbours(parted)) pairs.meshes.push_back({"neighbour", brick(place)});

    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        const bool is_parted = i % 2 == 1, is_aligned = i / 2 % 2 == 0;
        const std::size_t place = random.below(3);
        if (is_aligned) {
            Vec3 corner;
            for (int axis = 0; axis < 3; ++axis) corner[axis] = 0.5 * random.below(64);
            pairs.queries.push_back({{0, {Mat3::Identity(), corner}},
                                     {0, {Mat3::Identity(), corner + neighbours(is_parted ? gap : 0)[place]}}});
        } else {
            const Pose pose = random_pose(random);
            pairs.queries.push_back({{0, pose}, {1 + place + (is_parted ? 3 : 0), pose}});
        }
    }
    return pairs;
}

MeshPairs splined_shafts(std::size_t count, std::uint32_t seed) {
    MeshPairs pairs{
        "splined shaft in its hub", {{"hub", hub()}, {"shaft", shaft(1)}, {"thin shaft", shaft(1 - 0x1p-12)}}, {}};
    Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        Pose hub_pose, shaft_pose;
        if (i / 2 % 2 == 0) {
            shaft_pose.t.z() = (random.below(129) - 64.0) / 128;
        } else {
            hub_pose = shaft_pose = random_pose(random);
        }
        pairs.queries.push_back({{0, hub_pose}, {i % 2 == 0 ? 1u : 2u, shaft_pose}});
    }
    return pairs;
}

}  // namespace ecods::scenes
