// Traces, out of memory at any point: the world goes on, and a trace that is not whole says so.
#include "ecods/trace.hpp"
#include "unit/allocation/scene.hpp"

namespace ecods::allocation::trace_test {
namespace {

const TraceOptions writing{.write_shape = [](const Shape& shape) {
    return "a ball of a radius of so many 1024ths, which is " + std::to_string(shape.digest());
}};

ReplayOptions reading() {
    return {.set_up =
                [](World& world) {
                    world.set_test(ball_kind, ball_kind, std::make_shared<BoxTest>());
                    world.set_test(ball_kind, ShapeKind::mesh(), std::make_shared<BoxTest>());
                },
            .read_shape =
                [](ShapeKind, std::string_view text) {
                    const std::string number(text.substr(text.find_last_of(' ') + 1));
                    return std::make_shared<Ball>(std::stod(number) / 1024);
                }};
}

// Whole or not: a trace that says that it is must run again.
void end_trace(Scene& scene) {
    try {
        scene.world.end_trace();
    } catch (const TraceFailed&) {
        return;
    }
    if (scene.trace->str().empty()) return;  // none was under way
    std::istringstream in(scene.trace->str());
    const ReplayReport report = replay(in, reading());
    if (report.difference) throw Error("a trace that does not run again: " + report.difference->what);
}

Trial<Scene> trial_of(void (*call)(Scene&), bool traces) {
    return {.make =
                [traces] {
                    Scene scene({}, Stage::running);
                    if (traces) scene.world.trace_to(*scene.trace, writing);
                    return scene;
                },
            .call = call,
            .difference = [](Scene& a, Scene& b) { return difference(a, b); },
            .go_on =
                [](Scene& scene) {
                    scene.go_on();
                    end_trace(scene);
                }};
}

TEST(TraceOutOfMemory, OneThatIsBegun) {
    Failures failures;
    fail_each_allocation(trial_of(
                             [](Scene& s) {
                                 s.trace = std::make_unique<std::ostringstream>();
                                 try {
                                     s.world.trace_to(*s.trace, writing);
                                 } catch (...) {
                                     s.trace->str("");  // what is there of a trace that was not begun
                                     throw;
                                 }
                             },
                             false),
                         failures);
    expect_none(failures, "trace_to");
}

TEST(TraceOutOfMemory, OneThatIsUnderWay) {
    struct Traced {
        const char* name;
        void (*call)(Scene&);
    };
    for (const Traced& traced : {
             Traced{"create_body", [](Scene& s) { s.ids.push_back(s.world.create_body(tetrahedron(), at(2))); }},
             Traced{"set_shape", [](Scene& s) { s.world.set_shape(s.ids[1], std::make_shared<Ball>(0.75)); }},
             Traced{"set_poses",
                    [](Scene& s) {
                        s.world.set_poses(std::vector<BodyId>{s.ids[0], s.ids[1]}, std::vector<Pose>{at(1), at(2)});
                    }},
         }) {
        Failures failures;
        fail_each_allocation(trial_of(traced.call, true), failures);
        expect_none(failures, traced.name);
    }
}

TEST(TraceOutOfMemory, OneThatIsRunAgain) {
    Scene traced({}, Stage::running);
    traced.world.trace_to(*traced.trace, writing);
    traced.go_on();
    traced.world.end_trace();
    struct Replay {
        std::string text;
        std::string got = {};
    };
    Failures failures;
    fail_each_allocation<Replay>({.make = [&] { return Replay{traced.trace->str()}; },
                                  .call =
                                      [](Replay& r) {
                                          std::istringstream in(r.text);
                                          const ReplayReport report = replay(in, reading());
                                          r.got = report.difference ? report.difference->what
                                                                    : std::to_string(report.call_count);
                                      },
                                  .difference = [](Replay& a, Replay& b) { return a.got == b.got ? "" : b.got; }},
                                 failures);
    expect_none(failures, "replay", 100);
}

}  // namespace
}  // namespace ecods::allocation::trace_test
