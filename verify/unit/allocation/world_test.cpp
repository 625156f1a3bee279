// Every call of World but update(): out of memory at any point, it changes nothing.
#include <array>
#include <bit>

#include "allocation/new_thread.hpp"
#include "base/hash.hpp"
#include "ecods/trace.hpp"
#include "unit/allocation/scene.hpp"

namespace ecods::allocation::world_test {
namespace {

template <class List>
std::string text_of(const List& list) {
    std::string text;
    for (const auto& each : list) text += std::to_string(each) + " ";
    return text;
}

std::string slots_of(const std::vector<BodyId>& bodies) {
    std::vector<std::uint32_t> slots;
    for (const BodyId body : bodies) slots.push_back(body.slot);
    return text_of(slots);
}

std::string text_of(const std::optional<NearestBody>& nearest) {
    return nearest ? std::to_string(nearest->body.slot) + " at " + std::to_string(nearest->distance) : "none";
}

std::string text_of(const std::optional<BodyContact>& met) {
    return met ? std::to_string(met->body.slot) + " at " + std::to_string(met->contact.time) : "none";
}

// How many there are, and a digest: the text of each would have allocations of its own, most of those that fail.
template <class Answer, class Add>
std::string count_of(const std::vector<Answer>& answers, const Add& add) {
    std::uint64_t digest = 0;
    for (const Answer& each : answers) add(each, digest);
    return std::to_string(answers.size()) + " of digest " + std::to_string(digest);
}

std::string text_of(const std::vector<BodyHit>& hits) {
    return count_of(hits, [](const BodyHit& each, std::uint64_t& digest) {
        digest = combine(combine(digest, each.body.slot), std::bit_cast<std::uint64_t>(each.hit.parameter));
    });
}

std::string text_of(const std::optional<BodyHit>& hit) {
    return hit ? std::to_string(hit->body.slot) + " at " + std::to_string(hit->hit.parameter) : "none";
}

std::string text_of(const std::vector<Meeting>& meetings) {
    return count_of(meetings, [](const Meeting& each, std::uint64_t& digest) {
        digest = combine(combine(digest, each.bodies.a.slot), each.bodies.b.slot);
        digest = combine(digest, std::bit_cast<std::uint64_t>(each.contact.time));
    });
}

std::string text_of(const std::vector<BodyDepth>& depths) {
    return count_of(depths, [](const BodyDepth& each, std::uint64_t& digest) {
        digest = combine(combine(digest, each.bodies.b.slot), std::bit_cast<std::uint64_t>(each.depth.depth));
    });
}

std::string text_of(const std::vector<PairDistance>& distances) {
    return count_of(distances, [](const PairDistance& each, std::uint64_t& digest) {
        digest = combine(combine(digest, each.bodies.b.slot), std::bit_cast<std::uint64_t>(each.distance));
    });
}

std::string text_of(const std::vector<ClosestPair>& pairs) {
    return count_of(pairs, [](const ClosestPair& each, std::uint64_t& digest) {
        digest = combine(combine(digest, each.bodies.b.slot), std::bit_cast<std::uint64_t>(each.distance));
    });
}

// Each body touches the next one at most: lists of all hits and meetings are short, and fail that much less often.
constexpr double apart = 1.25;

const Segment through{Vec3(-1, 0.125, 0.125), Vec3(20, 0.25, 0.25)};

struct WorldCall {
    const char* name;
    void (*make)(Scene&);
    double spacing = 0.45;  // of the bodies
};

const std::array calls = {
    WorldCall{"create_body of a mesh", [](Scene& s) { s.ids.push_back(s.world.create_body(s.mesh, at(2))); }},
    WorldCall{"create_body of a new mesh",
              [](Scene& s) { s.ids.push_back(s.world.create_body(tetrahedron(), at(2))); }},
    WorldCall{"create_body of a shape",
              [](Scene& s) { s.ids.push_back(s.world.create_body(std::make_shared<Ball>(1), at(2))); }},
    WorldCall{"destroy_body", [](Scene& s) { s.world.destroy_body(s.ids[10]); }},
    WorldCall{"set_pose", [](Scene& s) { s.move(9, 0.25); }},
    WorldCall{"set_poses",
              [](Scene& s) {
                  // At one stage the first is in the lists of changes already, and the next one makes them grow.
                  const std::vector<BodyId> bodies = {s.ids[30], s.ids[0], s.ids[1], s.ids[9], s.ids[0]};
                  s.world.set_poses(bodies, std::vector<Pose>{at(0.5), at(1), at(2), at(3), at(4)});
              }},
    WorldCall{"set_shape to a mesh", [](Scene& s) { s.world.set_shape(s.ids[1], tetrahedron()); }},
    WorldCall{"set_shape to another kind", [](Scene& s) { s.world.set_shape(s.ids[1], std::make_shared<Ball>(0.75)); }},
    WorldCall{"set_filter", [](Scene& s) { s.world.set_filter(s.ids[1], {.groups = 4}); }},
    WorldCall{"set_pair_enabled, off", [](Scene& s) { s.world.set_pair_enabled(s.ids[0], s.ids[1], false); }},
    WorldCall{"set_pair_enabled, off, of a body with others",
              [](Scene& s) { s.world.set_pair_enabled(s.ids[9], s.ids[31], false); }},
    WorldCall{"set_pair_enabled, on", [](Scene& s) { s.world.set_pair_enabled(s.ids[9], s.ids[10], true); }},
    WorldCall{"set_test", [](Scene& s) { s.world.set_test(ball_kind, ball_kind, std::make_shared<BoxTest>()); }},
    WorldCall{"set_test of new kinds",
              [](Scene& s) { s.world.set_test(ShapeKind{8}, ball_kind, std::make_shared<BoxTest>()); }},
    WorldCall{"set_user_data", [](Scene& s) { s.world.set_user_data(s.ids[0], 77); }},
    WorldCall{"reserve", [](Scene& s) { s.world.reserve(500); }},
    WorldCall{"overlapping_pairs", [](Scene& s) { s.answer = std::to_string(s.world.overlapping_pairs().size()); }},
    WorldCall{"intersects",
              [](Scene& s) { s.answer = s.world.intersects(s.ids[0], s.ids[1], s.memory) ? "yes" : "no"; }},
    WorldCall{"relation",
              [](Scene& s) {
                  s.answer = std::to_string(static_cast<int>(s.world.relation(s.ids[0], s.ids[1], s.memory)));
              }},
    WorldCall{"intersecting_triangles",
              [](Scene& s) {
                  s.answer = std::to_string(s.world.intersecting_triangles(s.ids[0], s.ids[1], s.memory).size());
              }},
    WorldCall{"overlapping_bodies",
              [](Scene& s) {
                  s.answer = slots_of(s.world.overlapping_bodies({.min = Vec3(0, 0, 0), .max = Vec3(4, 4, 4)}));
              }},
    WorldCall{"intersecting_bodies, mesh",
              [](Scene& s) { s.answer = slots_of(s.world.intersecting_bodies({s.mesh, at(1)}, s.memory)); }},
    WorldCall{"intersecting_bodies, new mesh",
              [](Scene& s) { s.answer = slots_of(s.world.intersecting_bodies({tetrahedron(), at(1)}, s.memory)); }},
    WorldCall{"intersecting_bodies, shape",
              [](Scene& s) { s.answer = slots_of(s.world.intersecting_bodies({Ball(1), at(1)}, s.memory)); }},
    WorldCall{"intersects, of a shape and a mesh",
              [](Scene& s) {
                  s.answer = s.world.intersects({Ball(1), at(1)}, {tetrahedron(), at(1.5)}, s.memory) ? "yes" : "no";
              }},
    WorldCall{"distance, of a body and a mesh",
              [](Scene& s) {
                  s.answer = std::to_string(s.world.distance(s.ids[0], {tetrahedron(), at(40)}, s.memory));
              }},
    WorldCall{"set_clearance", [](Scene& s) { s.world.set_clearance(0.5); }},
    WorldCall{"set_clearance to none", [](Scene& s) { s.world.set_clearance({}); }},
    WorldCall{"set_relations", [](Scene& s) { s.world.set_relations(false); }},
    WorldCall{
        "relation of solids",
        [](Scene& s) {
            s.answer = std::to_string(static_cast<int>(s.world.relation(s.ids[0], s.ids[10], s.memory)));
        }},
    WorldCall{"distance of convex solids",
              [](Scene& s) { s.answer = std::to_string(s.world.distance(s.ids[0], s.ids[10], s.memory)); }},
    WorldCall{"closest of convex solids",
              [](Scene& s) {
                  s.answer = std::to_string(s.world.closest(s.ids[0], s.ids[10], s.memory).point_a[0]);
              }},
    WorldCall{"depth",
              [](Scene& s) { s.answer = std::to_string(s.world.depth(s.ids[0], s.ids[10], s.memory)->depth); },
              0.03125},
    WorldCall{"signed_distance",
              [](Scene& s) {
                  s.answer = std::to_string(s.world.signed_distance(s.ids[0], s.ids[10], s.memory).distance);
              },
              0.0625},
    WorldCall{"depth_bounds",
              [](Scene& s) { s.answer = std::to_string(s.world.depth_bounds(s.ids[0], s.ids[10], s.memory)->upper); },
              0.03125},
    WorldCall{"depths", [](Scene& s) { s.answer = text_of(s.world.depths(s.memory)); }},
    WorldCall{"depths, in a new thread's own memory",
              [](Scene& s) { in_a_new_thread([&] { s.answer = text_of(s.world.depths()); }); }},
    WorldCall{"signed_distances", [](Scene& s) { s.answer = text_of(s.world.signed_distances(0.5, s.memory)); }},
    WorldCall{"bodies_containing",
              [](Scene& s) {
                  const BodiesContaining found = s.world.bodies_containing(Vec3(1, 0.125, 0.25), s.memory);
                  s.answer = std::to_string(found.bodies.size()) + " of " + std::to_string(found.skipped_count);
              }},
    WorldCall{"distance", [](Scene& s) { s.answer = std::to_string(s.world.distance(s.ids[0], s.ids[10], s.memory)); }},
    WorldCall{"within", [](Scene& s) { s.answer = s.world.within(s.ids[0], s.ids[10], 1, s.memory) ? "yes" : "no"; }},
    WorldCall{"closest",
              [](Scene& s) { s.answer = std::to_string(s.world.closest(s.ids[0], s.ids[10], s.memory).point_a[0]); }},
    WorldCall{"nearest", [](Scene& s) { s.answer = text_of(s.world.nearest(s.ids[9], World::no_limit, s.memory)); }},
    WorldCall{"nearest, new mesh",
              [](Scene& s) {
                  s.answer = text_of(s.world.nearest({tetrahedron(), at(40)}, World::no_limit, s.memory));
              }},
    WorldCall{"nearest, shape",
              [](Scene& s) { s.answer = text_of(s.world.nearest({Ball(1), at(-3)}, World::no_limit, s.memory)); }},
    WorldCall{"nearest, in a new thread's own memory",
              [](Scene& s) { in_a_new_thread([&] { s.answer = text_of(s.world.nearest(s.ids[9])); }); }},
    WorldCall{"closest_pair",
              [](Scene& s) {
                  const auto pair = s.world.closest_pair(World::no_limit, s.memory);
                  s.answer = std::to_string(pair->bodies.a.slot) + " " + std::to_string(pair->bodies.b.slot);
              }},
    WorldCall{"closest_pair of groups",
              [](Scene& s) {
                  const auto pair = s.world.closest_pair(World::no_limit, 1, 1, s.memory);
                  s.answer = std::to_string(pair->bodies.a.slot) + " " + std::to_string(pair->bodies.b.slot);
              }},
    WorldCall{"closest_pairs", [](Scene& s) { s.answer = text_of(s.world.closest_pairs(0.5, s.memory)); }},
    WorldCall{"closest_pairs of groups, in a new thread's own memory",
              [](Scene& s) { in_a_new_thread([&] { s.answer = text_of(s.world.closest_pairs(0.5, 1, 1)); }); }},
    WorldCall{"intersections",
              [](Scene& s) { s.answer = std::to_string(s.world.intersections(s.ids[0], s.ids[1], s.memory).size()); }},
    WorldCall{"close_features",
              [](Scene& s) {
                  s.answer = std::to_string(s.world.close_features(s.ids[0], s.ids[1], 0.25, s.memory).size());
              }},
    WorldCall{"first_hit, segment", [](Scene& s) { s.answer = text_of(s.world.first_hit(through, {}, s.memory)); }},
    WorldCall{"first_hit, ray",
              [](Scene& s) {
                  s.answer = text_of(s.world.first_hit(Ray{through.a, through.b - through.a}, {}, s.memory));
              }},
    WorldCall{"all_hits, segment",
              [](Scene& s) { s.answer = text_of(s.world.all_hits(through, {}, s.memory)); },
              apart},
    WorldCall{"all_hits, ray",
              [](Scene& s) {
                  s.answer = text_of(s.world.all_hits(Ray{through.a, through.b - through.a}, {}, s.memory));
              },
              apart},
    WorldCall{"cast", [](Scene& s) { s.answer = text_of(s.world.cast(s.ids[9], Vec3(-8, 0, 0), 1, s.memory)); }},
    WorldCall{"cast, in a new thread's own memory",
              [](Scene& s) { in_a_new_thread([&] { s.answer = text_of(s.world.cast(s.ids[9], Vec3(-8, 0, 0))); }); }},
    WorldCall{"cast, new mesh",
              [](Scene& s) {
                  s.answer = text_of(s.world.cast({tetrahedron(), at(40)}, Vec3(-30, 0, 0), 1, s.memory));
              }},
    WorldCall{"cast, shape",
              [](Scene& s) { s.answer = text_of(s.world.cast({Ball(1), at(-3)}, Vec3(8, 0, 0), 1, s.memory)); }},
    WorldCall{"meetings",
              [](Scene& s) {
                  // Short ways: each one meets its neighbor.
                  const std::vector<BodyId> bodies = {s.ids[30], s.ids[0], s.ids[1], s.ids[9], s.ids[0]};
                  const std::vector<Pose> poses = {at(37), at(0.5), at(1), at(10), at(0.75)};
                  s.answer = text_of(s.world.meetings(bodies, poses, s.memory));
              },
              apart},
    WorldCall{"cast, turn",
              [](Scene& s) {
                  const Turn turn{{1, 0, 0, 0.0625}, Vec3(0, 40, 0), Vec3(0, 40, 0)};
                  s.answer = text_of(s.world.cast(s.ids[0], turn, 1, s.memory));
              }},
    WorldCall{"meetings of motions",
              [](Scene& s) {
                  const std::vector<BodyId> bodies = {s.ids[30], s.ids[0], s.ids[1], s.ids[9], s.ids[0]};
                  const Translation by{Vec3(0.5, 0, 0)};
                  const Turn turn{{1, 0, 0, 0.03125}, Vec3(0, 20, 0), Vec3(0, 20, 0)};
                  const std::vector<Motion> motions = {by, by, turn, Straight{at(10)}, by};
                  s.answer = text_of(s.world.meetings(bodies, motions, s.memory));
              },
              apart},
    WorldCall{"bodies", [](Scene& s) { s.answer = slots_of(s.world.bodies()); }},
    WorldCall{"next_ids", [](Scene& s) { s.answer = slots_of(s.world.next_ids()); }},
    WorldCall{"disabled_pairs", [](Scene& s) { s.answer = std::to_string(s.world.disabled_pairs().size()); }},
    WorldCall{"statistics", [](Scene& s) { s.answer = std::to_string(s.world.statistics().body_count); }},
    WorldCall{"digest", [](Scene& s) { s.answer = std::to_string(s.world.digest()); }},
};

class WorldOutOfMemory : public testing::TestWithParam<BroadPhaseKind> {
  protected:
    Trial<Scene> trial_of(void (*call)(Scene&), Stage stage, std::size_t body_count = 32, double spacing = 0.45) const {
        return {.make = [=, this] { return Scene({.broad_phase = GetParam()}, stage, body_count, spacing); },
                .call = call,
                .difference = [](Scene& a, Scene& b) { return difference(a, b); },
                .go_on = [](Scene& scene) { scene.go_on(); }};
    }

    // Most of a call is the same code in every broad phase: one of them has every allocation fail.
    bool is_first() const { return GetParam() == BroadPhaseKind::brute_force; }

    // Lets every `stride`-th allocation of each call fail.
    void expect_no_change(const std::vector<Stage>& at_stages, std::uint64_t stride = 1) const {
        std::uint64_t allocations = 0;
        for (const WorldCall& call : calls) {
            Failures failures;
            for (const Stage stage : at_stages) {
                fail_each_allocation(trial_of(call.make, stage, 32, call.spacing), failures, stride);
            }
            expect_none(failures, call.name);
            allocations += failures.allocations;
        }
        EXPECT_GE(allocations, 150u);
    }
};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldOutOfMemory,
                         testing::Values(BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                         BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic));

TEST_P(WorldOutOfMemory, EveryCallThenChangesNothing) {
    expect_no_change({Stage::running}, is_first() ? 1 : 2);
}

TEST_P(WorldOutOfMemory, EveryCallAtOtherStagesThenChangesNothing) {
    expect_no_change({Stage::fresh, Stage::ebb, Stage::batches}, is_first() ? 2 : 7);
}

TEST_P(WorldOutOfMemory, CheckInvariantsOnlyLooks) {
    Trial<Scene> trial = trial_of([](Scene& s) { s.world.check_invariants(); }, Stage::running, 20);
    const auto make = trial.make;
    trial.make = [make] {
        Scene scene = make();
        scene.world.update();
        return scene;
    };
    Failures failures;
    fail_each_allocation(trial, failures);
    expect_none(failures, "check_invariants");
}

TEST(WorldOutOfMemory, AWorldThatIsNotMade) {
    Failures failures;
    fail_each_allocation<std::unique_ptr<World>>(
        {.make = [] { return nullptr; },
         .call = [](std::unique_ptr<World>& world) { world = std::make_unique<World>(); },
         .difference = [](auto& a, auto& b) { return (a == nullptr) == (b == nullptr) ? "" : "a world"; }},
        failures);
    expect_none(failures, "World()");
}

// Whose slots are used, free, used up, and new.
TEST(WorldOutOfMemory, AWorldUnderIdsThatIsNotMade) {
    const WorldOptions options{.ids = {{7, 3, 1}, {2, 0, 1}, {40, 1, 1}, {1, 9, 1}, {41, 0, 1}}};
    const auto ids_of = [](const std::unique_ptr<World>& world) {
        return world == nullptr ? std::vector<BodyId>() : world->next_ids();
    };
    Failures failures;
    fail_each_allocation<std::unique_ptr<World>>(
        {.make = [] { return nullptr; },
         .call = [&](std::unique_ptr<World>& world) { world = std::make_unique<World>(options); },
         .difference = [&](auto& a, auto& b) { return ids_of(a) == ids_of(b) ? "" : "other ids"; }},
        failures);
    expect_none(failures, "World(ids)", 4);
}

}  // namespace
}  // namespace ecods::allocation::world_test
