// The report's case 2 with a clearance: what close pairs cost beside collisions.
#include <fmt/core.h>

#include <array>

#include "engines/world_bodies.hpp"
#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "scenes/room.hpp"
#include "scenes/ship.hpp"
#include "suites/parts.hpp"

namespace ecods::bench {

namespace {

// A ship is 2 long.
constexpr double ship_length = 2;

// The same scene in two worlds, frame by frame, one of them with a clearance.
class Beside {
  public:
    Beside(const scenes::Scene& scene, double clearance)
        : scene_(scene), worlds_{WorldBodies(scene), WorldBodies(scene)} {
        worlds_[1].world.set_clearance(clearance);
        for (WorldBodies& bodies : worlds_) bodies.world.update();
    }

    void run() {
        for (std::size_t frame = 0; frame < scene_.frames.size(); ++frame) {
            for (std::size_t i = 0; i < worlds_.size(); ++i) {
                const Stopwatch watch;
                worlds_[i].move(scene_.frames[frame].moves);
                worlds_[i].world.update();
                if (frame >= 2) ms_[i].push_back(1e-6 * watch.nanoseconds());
            }
            is_right_ &= worlds_[0].hits() == worlds_[1].hits();
        }
    }

    const std::vector<double>& ms(std::size_t world) const { return ms_[world]; }
    Statistics statistics() const { return worlds_[1].world.statistics(); }
    bool is_right() const { return is_right_; }

  private:
    const scenes::Scene& scene_;
    std::array<WorldBodies, 2> worlds_;
    std::array<std::vector<double>, 2> ms_;
    bool is_right_ = true;
};

}  // namespace

Table clearance_table(const SuiteOptions& options, bool& is_right) {
    Table table{.title = "What a clearance costs: ships as dense as in the report's case 2", .text_columns = 0};
    table.header = {"ships",       "clearance",     "ms/frame without", "with", "ratio", "colliding pairs",
                    "close pairs", "tests a frame", "of the clearance"};
    table.notes = {
        "From the third frame on, medians; poses are set and the world is updated, by turns in both worlds. The "
        "clearance is a tenth of a ship, and a hundredth. Pairs: in the last frame."};
    for (const std::size_t ships : {1000, 10000}) {
        if (options.is_quick() && ships > 1000) continue;
        const scenes::Scene scene = scenes::room({.ship_count = ships,
                                                  .frame_count = options.is_quick() ? std::size_t{5} : 60,
                                                  .side = scenes::calibrated_side_by_density(ships),
                                                  .seed = 10});
        for (const double share : {0.1, 0.01}) {
            Beside beside(scene, share * ship_length);
            beside.run();
            is_right &= beside.is_right();
            const Statistics counts = beside.statistics();
            const auto a_frame = [&](std::uint64_t count) {
                return fmt::format("{:.0f}", static_cast<double>(count) / static_cast<double>(counts.updates));
            };
            table.rows.push_back(
                {fmt::format("{}", ships), fmt::format("{:.2f}", share * ship_length),
                 fmt::format("{:.3f}", median(beside.ms(0))), fmt::format("{:.3f}", median(beside.ms(1))),
                 fmt::format("{:.2f}", median(beside.ms(1)) / median(beside.ms(0))),
                 fmt::format("{}", counts.colliding_count), fmt::format("{}", counts.clearance.close_count),
                 a_frame(counts.two_body_tests), a_frame(counts.clearance.two_body_tests)});
        }
    }
    return table;
}

}  // namespace ecods::bench
