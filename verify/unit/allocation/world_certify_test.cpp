// World::certify, out of memory at any point: the world is as it was, and the next call gives the same text.
#include "ecods/certificate.hpp"
#include "unit/allocation/scene.hpp"

namespace ecods::allocation::world_certify_test {
namespace {

// Meshes only, some that touch, some that cross, some that are close; up to date.
struct Certified {
    explicit Certified(BroadPhaseKind kind) : world(std::make_unique<World>(WorldOptions{.broad_phase = kind})) {
        world->set_clearance(0.25);
        for (const double x : {0.0, 0.5, 1.5, 2.625, 8.0}) ids.push_back(world->create_body(mesh, at(x)));
        world->set_pair_enabled(ids[1], ids[2], false);
        world->update();
    }

    std::shared_ptr<const Mesh> mesh = tetrahedron();
    std::unique_ptr<World> world;
    std::vector<BodyId> ids;
    QueryMemory memory;
    std::size_t colliding = 0, close = 0, apart = 0;
};

std::string text_of(const Certified& scene) {
    QueryMemory memory;
    return scene.world->certify(memory).to_string();
}

class WorldCertifyOutOfMemory : public testing::TestWithParam<BroadPhaseKind> {};

INSTANTIATE_TEST_SUITE_P(BroadPhases, WorldCertifyOutOfMemory,
                         testing::Values(BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                         BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic));

TEST_P(WorldCertifyOutOfMemory, ChangesNothing) {
    Failures failures;
    fail_each_allocation<Certified>(
        {.make = [kind = GetParam()] { return Certified(kind); },
         .call =
             [](Certified& s) {
                 const WorldCertificate certificate = s.world->certify(s.memory);
                 s.colliding = certificate.colliding_count();
                 s.close = certificate.close_count();
                 s.apart = certificate.apart_count();
             },
         .difference =
             [](Certified& expected, Certified& got) {
                 if (text_of(expected) != text_of(got)) return std::string("another text");
                 if (expected.colliding != got.colliding || expected.close != got.close || expected.apart != got.apart)
                     return std::string("another certificate");
                 return difference(state_of(*expected.world), state_of(*got.world));
             },
         .go_on =
             [](Certified& s) {
                 s.world->set_pose(s.ids[4], at(2.75));
                 s.world->update();
                 s.world->check_invariants();
             }},
        failures);
    expect_none(failures, "certify");
    EXPECT_GE(failures.allocations, 20u);
    Certified scene(GetParam());
    const WorldCertificate certificate = scene.world->certify(scene.memory);
    EXPECT_GE(certificate.colliding_count(), 1u);
    EXPECT_GT(certificate.close_count(), certificate.colliding_count());
}

}  // namespace
}  // namespace ecods::allocation::world_certify_test
