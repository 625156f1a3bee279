// The manager's promise: the two-body test is called only for candidate pairs that moved.
#include <fmt/core.h>

#include <set>

#include "ecods/world.hpp"
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
    World world;
    std::vector<BodyId> ids;
    for (const scenes::SceneBody& body : scene.bodies)
        ids.push_back(world.create_body(scene.meshes[body.mesh_index].mesh, body.pose));
    const auto index_of = [&](BodyId id) {  // ids are given in ascending order
        return static_cast<std::size_t>(std::lower_bound(ids.begin(), ids.end(), id) - ids.begin());
    };

    Counts counts;
    std::set<BodyId> moved(ids.begin(), ids.end());  // at rest, all are new
    for (std::size_t frame = 0; frame <= scene.frames.size(); ++frame) {
        if (frame > 0) {
            moved.clear();
            for (const scenes::Move& move : scene.frames[frame - 1].moves) {
                world.set_pose(ids[move.body_index], move.pose);
                moved.insert(ids[move.body_index]);
            }
        }
        world.update();
        for (const BodyPair& pair : world.overlapping_pairs()) {
            ++counts.candidates;
            if (moved.contains(pair.a) || moved.contains(pair.b)) ++counts.moved_candidates;
        }
        std::vector<IndexPair>& hits = counts.hits.emplace_back();
        for (const BodyPair& pair : world.colliding_pairs()) hits.push_back({index_of(pair.a), index_of(pair.b)});
    }
    counts.statistics = world.statistics();
    return counts;
}

}  // namespace

SuiteResult run_hover(const SuiteOptions& options) {
    SuiteResult result;
    Table table;
    table.title = "What the manager spares: some ships move, the others hover";
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
                               s.two_body_tests + s.cache_hits == counts.candidates && errors.false_negatives == 0 &&
                               errors.false_positives == 0;
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
