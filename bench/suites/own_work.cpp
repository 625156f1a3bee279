#include "suites/own_work.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <cstdio>
#include <functional>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "ecods/intersection.hpp"
#include "engines/broad_phase_kinds.hpp"
#include "engines/scene_engine.hpp"
#include "harness/differences.hpp"
#include "harness/stopwatch.hpp"
#include "process/contained.hpp"
#include "scenes/fitted_parts.hpp"
#include "scenes/moving_boxes.hpp"
#include "scenes/narrow_workloads.hpp"
#include "scenes/room.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"
#include "suites/own_questions.hpp"

namespace ecods::bench {

namespace {

using Turn = std::function<OwnSample()>;

struct OwnWorkload {
    std::string name;
    std::function<Turn()> set_up;  // at the first turn
};

void add_counts(std::map<std::string, std::uint64_t>& counts, const QueryCounts& of) {
    counts["witness hits"] = of.witness_hits;
    counts["node tests"] = of.box_tests;
    counts["triangle pairs"] = of.stages.triangle_tests;
    for (const Stage& stage : stages) counts[stage.name] = of.stages.*stage.count;
    counts["triangles bounded"] = of.distances.triangle_bounds;
    counts["triangles enclosed"] = of.distances.enclosures;
    counts["triangles measured"] = of.distances.exact;
}

void add_counts(std::map<std::string, std::uint64_t>& counts, const BroadPhaseCounts& of) {
    counts["box tests"] = of.box_tests;
    counts["swaps"] = of.swaps;
    counts["candidates filtered"] = of.candidates_filtered;
    counts["escaped"] = of.escaped;
    counts["rebuilds"] = of.rebuilds;
    counts["switches"] = of.switches;
}

// All queries with their work counted, then timed passes, for long enough to rise above noise.
Turn start_queries(scenes::MeshPairs pairs, const OwnQuestion& question = touch_question) {
    auto workload = std::make_shared<scenes::MeshPairs>(std::move(pairs));
    auto shapes = std::make_shared<std::vector<std::unique_ptr<MeshShape>>>();
    for (const scenes::NamedMesh& named : workload->meshes) shapes->push_back(question.make(named.mesh));
    auto memory = std::make_shared<QueryMemory>();
    return [workload, shapes, memory, answer = question.answer] {
        const auto answer_to = [&](const scenes::MeshQuery& query, const Ask& ask) {
            return answer({*(*shapes)[query.a.mesh_index], query.a.pose},
                          {*(*shapes)[query.b.mesh_index], query.b.pose}, ask);
        };
        OwnSample sample;
        Hash hash;
        QueryCounts counts;
        for (const scenes::MeshQuery& query : workload->queries) hash.add(answer_to(query, {*memory, counts}));
        add_counts(sample.counts, counts);
        sample.answers = hash.text();
        std::size_t passes = 0;
        double ns = 0;
        for (const Stopwatch watch; ns < 2e7; ns = watch.nanoseconds(), ++passes)
            for (const scenes::MeshQuery& query : workload->queries) answer_to(query, *memory);
        sample.ns = ns / static_cast<double>(passes * workload->queries.size());
        return sample;
    };
}

// All frames from the start; those after the first third are timed.
Turn start_boxes(const scenes::MovingBoxesOptions& options, BroadPhaseKind kind) {
    auto boxes = std::make_shared<scenes::MovingBoxes>(scenes::moving_boxes(options));
    return [boxes, kind] {
        const std::unique_ptr<BroadPhase> broad_phase = make_broad_phase(kind);
        for (std::size_t i = 0; i < boxes->boxes.size(); ++i)
            broad_phase->add(static_cast<ProxyIndex>(i), boxes->boxes[i]);
        broad_phase->update();
        OwnSample sample;
        Hash hash;
        const std::size_t untimed = boxes->frames.size() / 3;
        for (std::size_t frame = 0; frame < boxes->frames.size(); ++frame) {
            const Stopwatch watch;
            for (const scenes::BoxMove& move : boxes->frames[frame]) broad_phase->move(move.index, move.box);
            broad_phase->update();
            const std::span<const ProxyPair> pairs = broad_phase->pairs();
            if (frame >= untimed) sample.ns += watch.nanoseconds();
            for (const ProxyPair& pair : pairs) hash.add(std::uint64_t{pair.a} << 32 | pair.b);
        }
        sample.ns /= static_cast<double>((boxes->frames.size() - untimed) * boxes->boxes.size());
        add_counts(sample.counts, broad_phase->counts());
        sample.answers = hash.text();
        return sample;
    };
}

// The report's room; frames after the first are timed.
Turn start_room(const scenes::RoomOptions& options) {
    auto scene = std::make_shared<scenes::Scene>(scenes::room(options));
    return [scene] {
        const std::unique_ptr<SceneEngine> engine = set_up_world(*scene, BroadPhaseKind::automatic);
        OwnSample sample;
        Hash hash;
        engine->run_frame({});
        for (const scenes::Frame& frame : scene->frames) {
            const Stopwatch watch;
            engine->run_frame(frame.moves);
            sample.ns += watch.nanoseconds();
            for (const IndexPair& hit : ascending(engine->pairs())) hash.add(std::uint64_t{hit.a} << 32 | hit.b);
        }
        sample.ns /= static_cast<double>(scene->frames.size());
        const Statistics statistics = engine->statistics().value();
        add_counts(sample.counts, statistics.broad_phase);
        add_counts(sample.counts, statistics.queries);
        sample.counts["two-body tests"] = statistics.two_body_tests;
        sample.counts["cache hits"] = statistics.cache_hits;
        sample.counts["visited pairs"] = statistics.visited_pairs;
        sample.answers = hash.text();
        return sample;
    };
}

std::vector<OwnWorkload> mesh_workloads(bool is_quick) {
    std::vector<OwnWorkload> list;
    const std::size_t some = is_quick ? 4 : 100;
    const auto add_mesh = [&](const std::string& name, const std::shared_ptr<const Mesh>& mesh) {
        list.push_back({name + ", near", [=] { return start_queries(scenes::near_pairs(name, mesh, some, 1)); }});
        list.push_back(
            {name + ", random", [=] { return start_queries(scenes::random_pairs(name, mesh, 2 * some, 2)); }});
        list.push_back({name + ", distances",
                        [=] { return start_queries(scenes::random_pairs(name, mesh, some, 6), distance_question); }});
    };
    // Half of the near pairs touch; the others are apart by 1e-4 to 1e-2 of their size.
    const auto add_questions = [&](const std::string& name, const std::shared_ptr<const Mesh>& mesh,
                                   std::span<const OwnQuestion> questions) {
        for (const OwnQuestion& question : questions)
            list.push_back({name + ", near" + question.name, [=, &question] {
                                return start_queries(scenes::near_pairs(name, mesh, some, 8), question);
                            }});
    };
    add_mesh("ship", scenes::ship());
    add_mesh("torus 10k", scenes::torus(100, 50, 0.4));
    add_questions("ship", scenes::ship(), surface_questions());
    add_questions("torus 10k", scenes::torus(100, 50, 0.4), surface_questions());
    add_questions("torus 10k", scenes::torus(100, 50, 0.4), solid_questions());
    list.push_back({"stacked bricks", [=] { return start_queries(scenes::stacked_bricks(some, 3)); }});
    list.push_back({"stacked bricks, distances",
                    [=] { return start_queries(scenes::stacked_bricks(some, 3), distance_question); }});
    list.push_back(
        {"stacked bricks, closest", [=] { return start_queries(scenes::stacked_bricks(some, 3), closest_question); }});
    list.push_back({"splined shafts", [=] { return start_queries(scenes::splined_shafts(is_quick ? 2 : 20, 4)); }});
    return list;
}

std::vector<OwnWorkload> own_workloads(bool is_quick) {
    std::vector<OwnWorkload> list = mesh_workloads(is_quick);
    using scenes::BoxLayout;
    using scenes::BoxMotion;
    const std::size_t large = is_quick ? 2000 : 10'000, frame_count = is_quick ? 3 : 60;
    const scenes::MovingBoxesOptions scenes_of_boxes[] = {
        {BoxLayout::dense, BoxMotion::all, 1000, frame_count, 1},
        {BoxLayout::dense, BoxMotion::all, large, frame_count, 1},
        {BoxLayout::dense, BoxMotion::tenth, large, frame_count, 1},
        {BoxLayout::dense, BoxMotion::teleport, large, frame_count, 1},
        {BoxLayout::decades, BoxMotion::all, large, frame_count, 1}};
    for (const scenes::MovingBoxesOptions& options : scenes_of_boxes) {
        // Named by the scene with no frames, which costs little to make.
        scenes::MovingBoxesOptions still = options;
        still.frame_count = 0;
        for (const NamedBroadPhase& named : broad_phase_kinds) {
            const bool is_too_slow = named.kind == BroadPhaseKind::brute_force ||
                                     (named.kind == BroadPhaseKind::sweep_and_prune && options.count > 1000 &&
                                      options.motion == BoxMotion::teleport);
            if (is_too_slow) continue;
            list.push_back({scenes::moving_boxes(still).name + ", " + named.name,
                            [options, kind = named.kind] { return start_boxes(options, kind); }});
        }
    }
    for (const std::size_t ships : {std::size_t{32}, std::size_t{256}}) {
        list.push_back({fmt::format("{} ships", ships), [ships, is_quick] {
                            return start_room({.ship_count = ships,
                                               .frame_count = is_quick ? 3u : 60u,
                                               .side = scenes::calibrated_side_by_density(ships),
                                               .seed = 10});
                        }});
    }
    return list;
}

}  // namespace

void serve_own_work(bool is_quick) {
    process::pin_to_one_processor();
    const std::vector<OwnWorkload> workloads = own_workloads(is_quick);
    nlohmann::json names = nlohmann::json::array();
    for (const OwnWorkload& workload : workloads) names.push_back(workload.name);
    fmt::print("{}\n", names.dump());
    std::fflush(stdout);
    std::vector<Turn> turns(workloads.size());
    for (std::size_t index = 0; std::cin >> index && index < workloads.size();) {
        if (!turns[index]) turns[index] = workloads[index].set_up();
        fmt::print("{}\n", to_line(turns[index]()));
        std::fflush(stdout);
    }
}

}  // namespace ecods::bench
