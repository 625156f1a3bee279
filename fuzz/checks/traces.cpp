#include <sstream>
#include <utility>

#include "fuzz/base/failure.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/text.hpp"

namespace ecods::fuzz {

void check_trace(World& world, const TraceOptions& writing, const ReplayOptions& reading) {
    std::stringstream trace;
    world.trace_to(trace, writing);
    world.update();
    world.end_trace();
    const ReplayReport report = replay(trace, reading);
    if (report.difference) throw CheckFailed("trace and replay", "no difference", report.difference->what);
    const auto got = std::pair(report.body_count, report.colliding_count);
    const auto expected = std::pair(world.statistics().body_count, world.colliding_pairs().size());
    if (got != expected) {
        throw CheckFailed("trace and replay", fmt::format("{} bodies, {} collisions", expected.first, expected.second),
                          fmt::format("{} bodies, {} collisions", got.first, got.second));
    }
}

}  // namespace ecods::fuzz
