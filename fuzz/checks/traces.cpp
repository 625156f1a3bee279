#include <algorithm>
#include <sstream>
#include <tuple>
#include <utility>

#include "fuzz/base/failure.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/text.hpp"

namespace ecods::fuzz {

void check_trace(World& world, const TraceOptions& writing, const ReplayOptions& reading) {
    std::stringstream trace;
    world.trace_to(trace, writing);
    world.update();
    // Questions are asked again, too.
    const auto bodies = world.bodies();
    std::size_t question_count = 0;
    if (writing.questions && !bodies.empty()) {
        const Aabb box = world.box(bodies.front());
        const bool has_lines =
            std::ranges::all_of(bodies, [&](BodyId body) { return world.shape(body)->answers(Question::hits); });
        if (has_lines && box.min.allFinite() && box.max.allFinite()) {
            std::ignore = world.first_hit(Segment{box.min, box.max});
            std::ignore = world.all_hits(Segment{box.min, box.max});
            question_count = 2;
        }
        std::ignore = world.nearest(bodies.front());
        ++question_count;
        if (has_lines) {
            std::ignore = world.cast(bodies.front(), Vec3(1, 0, 0));
            ++question_count;
        }
    }
    world.end_trace();
    const ReplayReport report = replay(trace, reading);
    if (report.difference) throw CheckFailed("trace and replay", "no difference", report.difference->what);
    if (report.question_count != question_count) {
        throw CheckFailed("trace and replay", fmt::format("{} questions", question_count),
                          fmt::format("{} questions", report.question_count));
    }
    const auto got = std::pair(report.body_count, report.colliding_count);
    const auto expected = std::pair(world.statistics().body_count, world.colliding_pairs().size());
    if (got != expected) {
        throw CheckFailed("trace and replay", fmt::format("{} bodies, {} collisions", expected.first, expected.second),
                          fmt::format("{} bodies, {} collisions", got.first, got.second));
    }
}

}  // namespace ecods::fuzz
