// Boxes and their trees, one call at a time.
#include <benchmark/benchmark.h>

#include <vector>

#include "bounds/support_table.hpp"
#include "bvh/axes/separating_axes.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace {

using namespace ecods;

struct PosedTorus {
    std::shared_ptr<const Mesh> mesh = scenes::torus(100, 50, 0.4);
    MeshBvh tree = build_mesh_bvh(*mesh, fit_frame(*mesh));
};

const PosedTorus& posed_torus() {
    static const PosedTorus made;
    return made;
}

std::vector<Pose> poses(std::size_t count) {
    scenes::Random random(1);
    std::vector<Pose> list(count);
    for (Pose& pose : list) {
        pose.R = random.rotation();
        pose.t = random.direction();
    }
    return list;
}

// Tori whose root boxes overlap, so that all fifteen axes are tried and both sets are made.
void box_axes_bind(benchmark::State& state) {
    const MeshBvh& tree = posed_torus().tree;
    const std::vector<Pose> list = poses(256);
    SeparatingAxes axes;
    std::size_t i = 0;
    for (auto _ : state) {
        const Pose &a = list[i % list.size()], &b = list[(i + 1) % list.size()];
        benchmark::DoNotOptimize(axes.bind({tree, a.R}, {tree, b.R}, 0.1 * (b.t - a.t)));
        ++i;
    }
}
BENCHMARK(box_axes_bind);

template <class List>
void near_lanes_of_all(benchmark::State& state, const MeshBvh& tree, const List& parts) {
    const std::vector<Pose> list = poses(2);
    SeparatingAxes axes;
    benchmark::DoNotOptimize(axes.bind({tree, list[0].R}, {tree, list[1].R}, 0.1 * list[1].t));
    std::size_t i = 0, j = 0;
    for (auto _ : state) {
        benchmark::DoNotOptimize(overlap_mask(axes.sets(), parts[i], parts[j]));
        if (++i == parts.size()) {
            i = 0;
            j = (j + 1) % parts.size();
        }
    }
}

// Eight boxes against eight, of any two nodes.
void near_lanes_of_nodes(benchmark::State& state) {
    near_lanes_of_all(state, posed_torus().tree, posed_torus().tree.nodes);
}
BENCHMARK(near_lanes_of_nodes);

// Eight triangles against eight.
void near_lanes_of_leaves(benchmark::State& state) {
    near_lanes_of_all(state, posed_torus().tree, posed_torus().tree.leaves);
}
BENCHMARK(near_lanes_of_leaves);

// The box of a body at a pose.
void outline_box(benchmark::State& state) {
    const PosedTorus& torus = posed_torus();
    const SupportTable support_table(*torus.mesh, torus.tree.frame);
    const std::vector<Pose> list = poses(256);
    std::size_t i = 0;
    for (auto _ : state) benchmark::DoNotOptimize(support_table.box(list[i++ % list.size()]));
}
BENCHMARK(outline_box);

}  // namespace
