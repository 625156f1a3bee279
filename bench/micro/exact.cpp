// The exact layer, one call at a time: each stage by an input that it alone decides.
#include <benchmark/benchmark.h>

#include <array>
#include <vector>

#include "ecods/primitives.hpp"
#include "query/intersection/triangle_relations.hpp"
#include "scenes/random.hpp"
#include "scenes/ship.hpp"

namespace {

using namespace ecods;

Vec3 random_point(scenes::Random& random) {
    return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

// Points anywhere: the filter decides.
void orient3d_by_filter(benchmark::State& state) {
    scenes::Random random(1);
    std::vector<std::array<Vec3, 4>> inputs(256);
    for (std::array<Vec3, 4>& input : inputs)
        for (Vec3& point : input) point = random_point(random);
    std::size_t i = 0;
    for (auto _ : state) {
        const auto& [a, b, c, d] = inputs[i++ % inputs.size()];
        benchmark::DoNotOptimize(orient3d(a, b, c, d));
    }
}
BENCHMARK(orient3d_by_filter);

// Four points of one plane, with coordinates of 24 bits: integers decide.
void orient3d_by_integers(benchmark::State& state) {
    scenes::Random random(2);
    std::vector<std::array<Vec3, 4>> inputs(256);
    const auto short_number = [&] { return static_cast<double>(random.below(1u << 20)) * 0x1p-20; };
    for (std::array<Vec3, 4>& input : inputs) {
        for (Vec3& point : input) {
            const double x = short_number(), y = short_number();
            point = {x, y, x + y};
        }
    }
    std::size_t i = 0;
    for (auto _ : state) {
        const auto& [a, b, c, d] = inputs[i++ % inputs.size()];
        benchmark::DoNotOptimize(orient3d(a, b, c, d));
    }
}
BENCHMARK(orient3d_by_integers);

// All pairs of a ship's triangles with those of another one; near is as far as the second is moved along x.
void triangle_pairs(benchmark::State& state, double moved_by, bool is_turned) {
    const std::shared_ptr<const Mesh> ship = scenes::ship();
    const exact::MeshExtent extent = exact::measure(*ship);
    Pose a, b;
    b.t = {moved_by, 0, 0};
    if (is_turned) b.R = scenes::Random(3).rotation();
    TriangleRelations pair;
    pair.bind({ship.get(), &extent, &a}, {ship.get(), &extent, &b});
    const auto count = static_cast<std::uint32_t>(ship->triangles().size());
    std::uint32_t i = 0, j = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(pair.relation(i, j));
        if (++j == count) {
            j = 0;
            i = (i + 1) % count;
        }
    }
}
BENCHMARK_CAPTURE(triangle_pairs, generic, 0.3, true);
// Of the ship with itself in place, many share vertices, edges or all of their points.
BENCHMARK_CAPTURE(triangle_pairs, touching, 0.0, false);

}  // namespace
