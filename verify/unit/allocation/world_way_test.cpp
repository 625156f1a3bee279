// Casts of World along ways and to a distance: out of memory at any point, they change nothing, and a trace of them
// ends.
#include <string>
#include <vector>

#include "allocation/new_thread.hpp"
#include "unit/allocation/scene.hpp"

namespace ecods::allocation::world_way_test {
namespace {

const Vec3 far_pivot(0, 40, 0), pivot(0, 20, 0);
const Along there_and_back{{{{}, far_pivot}, {{1, 0, 0, -0.0625}, far_pivot}, {{1, 0, 0, 0.0625}, far_pivot}}};

std::string text_of(const std::optional<BodyContact>& met) {
    return met ? std::to_string(met->body.slot) + " at " + std::to_string(met->contact.time) : "none";
}

struct WayCall {
    const char* name;
    void (*make)(Scene&);
    double spacing = 0.45;  // of the bodies
    bool is_traced = false;

    Scene scene(const WorldOptions& options, Stage stage) const {
        Scene scene(options, stage, 32, spacing);
        scene.world.set_filter(scene.ids[3], {.groups = 2});
        const auto write_shape = [](const Shape&) { return std::string(); };
        if (is_traced) scene.world.trace_to(*scene.trace, {.write_shape = write_shape, .questions = true});
        return scene;
    }
};

constexpr double apart = 1.2;  // so that few bodies meet

const std::array calls = {
    WayCall{"cast, way", [](Scene& s) { s.answer = text_of(s.world.cast(s.ids[0], there_and_back, 1, s.memory)); }},
    WayCall{"cast, way, with a trace",
            [](Scene& s) { in_a_new_thread([&] { s.answer = text_of(s.world.cast(s.ids[0], there_and_back)); }); },
            0.45, true},
    WayCall{"cast_to_distance",
            [](Scene& s) {
                const Asked moved({tetrahedron(), at(40)}, CollisionFilter{.mask = 2});  // one mesh is in its way
                s.answer = text_of(s.world.cast_to_distance(moved, Vec3(-60, 0, 0), 0.25, 1, s.memory));
            }},
    WayCall{"meetings of a way",
            [](Scene& s) {
                const Along nodes{{{{}, pivot}, {{1, 0, 0, 0}, pivot}, {{1, 0, 0, 0.03125}, pivot}}};
                const std::vector<BodyId> bodies = {s.ids[1], s.ids[0]};
                const auto met = s.world.meetings(bodies, std::vector<Motion>{Translation(), nodes}, s.memory);
                s.answer = std::to_string(met.size());
            },
            apart},
};

// Calls are the same code in every broad phase.
TEST(WaysOutOfMemory, EveryCallThenChangesNothing) {
    for (const WayCall& call : calls) {
        Failures failures;
        fail_each_allocation<Scene>(
            {.make = [&] { return call.scene({.broad_phase = BroadPhaseKind::brute_force}, Stage::running); },
             .call = call.make,
             .difference = [](Scene& a, Scene& b) { return difference(a, b); },
             .go_on = [](Scene& scene) { scene.go_on(); }},
            failures);
        expect_none(failures, call.name, 2);
    }
}

// Every one of these calls finds something; or a failure before it would not be noticed.
TEST(WaysOutOfMemory, TheyFindBodies) {
    for (const WayCall& call : calls) {
        Scene scene = call.scene({}, Stage::running);
        call.make(scene);
        EXPECT_TRUE(scene.answer != "none" && scene.answer != "0") << call.name << ": " << scene.answer;
    }
}

}  // namespace
}  // namespace ecods::allocation::world_way_test
