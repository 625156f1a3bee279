// The manager's promise: the two-body test is called only for candidate pairs that moved.
#include <fmt/core.h>

#include <set>

#include "engines/world_bodies.hpp"
#include "harness/judge.hpp"
#include "process/progress.hpp"
#include "scenes/room.hpp"
#include "suites/comparison.hpp"
#include "suites/suite.hpp"

namespace ecods::bench {

namespace {

struct Counts {
    std::uint64_t candidates = 0;        // summed over frames
    std::uint64_t moved_candidates = 0;  // of these, pairs with a body that moved, counted here and not by the world
    Statistics statistics;
    std::vector<std::vector<IndexPair>> hits;
};

Counts count_work(const scenes::Scene& scene) {
    WorldBodies bodies(scene);
    Counts counts;
    std::set<BodyId> moved(bodies.ids().begin(), bodies.ids().end());  // at rest, all are new
    for (std::size_t frame = 0; frame <= scene.frames.size(); ++frame) {
        if (frame > 0) {
            moved.clear();
            for (const scenes::Move& move : scene.frames[frame - 1].moves) moved.insert(bodies[move.body_index]);
            bodies.move(scene.frames[frame - 1].moves);
        }
        bodies.world.update();
        for (const BodyPair& pair : bodies.world.overlapping_pairs()) {
            ++counts.candidates;
            if (moved.contains(pair.a) || moved.contains(pair.b)) ++counts.moved_candidates;
        }
        counts.hits.push_back(bodies.hits());
    }
    counts.statistics = bodies.world.statistics();
    return counts;
}

}  // namespace

SuiteResult run_hover(const SuiteOptions& options) {
    SuiteResult result;
    Table table{.title = "What the manager spares: some ships move, the others hover"};
    table.header = {"scene",          "moved bodies", "candidate pairs", "of these, with a moved ship",
                    "two-body tests", "cache hits",   "false -",         "false +"};
    for (const std::size_t ship_count : {32, 256}) {
        for (const double share : {1.0, 0.25, 0.0}) {
            const scenes::Scene scene = scenes::room({.ship_count = ship_count,
                                                      .frame_count = options.frame_count,
                                                      .side = scenes::calibrated_side(),
                                                      .moving_share = share,
                                                      .seed = 10});
            const std::string name = fmt::format("{} ships, {} move", ship_count,
                                                 share == 1   ? "all"
                                                 : share == 0 ? "none"
                                                              : "a quarter");
            const Counts counts = count_work(scene);
            const Errors errors = compare(counts.hits, ask_oracle(scene, Detail::hits_only, name));
            const Statistics& s = counts.statistics;
            result.is_right &= s.two_body_tests == counts.moved_candidates &&
                               s.two_body_tests + s.cache_hits == counts.candidates && errors.count() == 0;
            std::vector<std::string> row = {name};
            for (const std::uint64_t count :
                 {s.moved_bodies, counts.candidates, counts.moved_candidates, s.two_body_tests, s.cache_hits,
                  std::uint64_t{errors.false_negatives}, std::uint64_t{errors.false_positives}})
                row.push_back(fmt::format("{}", count));
            table.rows.push_back(std::move(row));
        }
    }
    table.notes = {
        fmt::format("Sums over {} frames, the first of which has all bodies new. The run fails unless the "
                    "two-body tests are the candidate pairs with a moved ship (counted by the benchmark "
                    "itself), and the cache answers all others.",
                    options.frame_count + 1)};
    print(table);
    result.sections.push_back(
        {"What the manager spares",
         {"In the report's experiment every ship moves in every frame. Here some hover: the manager calls the two-body "
          "test only for candidate pairs of which a ship moved, and keeps the verdict of the rest. All in the room of "
          "the "
          "32 ships."},
         {table},
         {}});
    return result;
}

}  // namespace ecods::bench
