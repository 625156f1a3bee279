#include <algorithm>
#include <map>
#include <utility>

#include "fuzz/base/failure.hpp"
#include "fuzz/base/mesh_form.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/text.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {
namespace {

template <class Number>
void require_number(const char* check, Number got, Number expected) {
    if (got != expected) throw CheckFailed(check, fmt::format("{:x}", expected), fmt::format("{:x}", got));
}

std::vector<BodyId> shuffled(std::vector<BodyId> bodies, std::uint32_t order) {
    scenes::Random random(order);
    for (std::size_t i = bodies.size(); i > 1; --i) {
        std::swap(bodies[i - 1], bodies[random.below(static_cast<std::uint32_t>(i))]);
    }
    return bodies;
}

}  // namespace

void check_fresh_world(const World& world, const FreshWorld& fresh) {
    World made(fresh.options);
    fresh.set_up(made);
    std::map<BodyId, BodyId> ids;
    for (const BodyId body : shuffled(world.bodies(), fresh.order)) {
        const auto shape = world.shape(body);
        const auto mesh = mesh_of_mesh_shape(*shape);
        const MeshForm form = form_of(*shape);
        // A mesh that was refitted gets a new tree.
        const BodyId id = !mesh                       ? made.create_body(shape, world.pose(body))
                          : form == MeshForm::surface ? made.create_body(mesh, world.pose(body))
                                                      : made.create_body(make_shape(mesh, form), world.pose(body));
        made.set_filter(id, world.filter(body));
        ids[body] = id;
    }
    for (const BodyPair& pair : world.disabled_pairs()) made.set_pair_enabled(ids.at(pair.a), ids.at(pair.b), false);
    made.set_clearance(world.clearance());
    made.set_relations(world.are_relations_listed());
    made.update();

    const auto require_pairs = [&](const char* check, std::span<const BodyPair> pairs,
                                   std::span<const BodyPair> of_made) {
        std::vector<BodyPair> expected;
        for (const BodyPair& pair : pairs) {
            const auto [a, b] = std::minmax(ids.at(pair.a), ids.at(pair.b));
            expected.push_back({a, b});
        }
        std::ranges::sort(expected);
        if (std::ranges::equal(of_made, expected)) return;
        throw CheckFailed(check, text(of_made), text(std::span<const BodyPair>(expected)));
    };
    require_pairs("fresh world, collisions", world.colliding_pairs(), made.colliding_pairs());
    require_pairs("fresh world, close pairs", world.close_pairs(), made.close_pairs());
    require_number("fresh world, digest", world.digest(), made.digest());
    // How tight boxes are depends on the rounding.
    if (fresh.has_own_environment) return;
    const Statistics got = world.statistics();
    const Statistics of_made = made.statistics();
    require_number("fresh world, candidates", got.overlapping_count, of_made.overlapping_count);
    require_number("fresh world, candidates filtered out", got.filtered_count, of_made.filtered_count);
    require_number("fresh world, candidates of the clearance", got.clearance.candidate_count,
                   of_made.clearance.candidate_count);
}

void check_same(World& world, World& other, Counters& counters) {
    ++counters["checked: worlds against one another"];
    const auto require = [](bool holds, const char* what) {
        if (!holds) throw CheckFailed("worlds given the same calls", std::string("the same ") + what, "another");
    };
    require(world.digest() == other.digest(), "digest");
    require(numbers_of(world.overlapping_pairs()) == numbers_of(other.overlapping_pairs()), "candidates");
    require(numbers_of(world.colliding_pairs()) == numbers_of(other.colliding_pairs()), "collisions");
    require(numbers_of(world.began()) == numbers_of(other.began()), "began");
    require(numbers_of(world.ended()) == numbers_of(other.ended()), "ended");
    require(numbers_of(world.close_pairs()) == numbers_of(other.close_pairs()), "close pairs");
    require(numbers_of(world.close_began()) == numbers_of(other.close_began()), "close pairs that began");
    require(numbers_of(world.close_ended()) == numbers_of(other.close_ended()), "close pairs that ended");
    const auto bodies = world.bodies();
    require(numbers_of(bodies) == numbers_of(other.bodies()), "bodies");
    for (const BodyId body : bodies) require(world.box(body) == other.box(numbers_of(body)), "boxes");
    const Statistics a = world.statistics();
    const Statistics b = other.statistics();
    require(a.moved_bodies == b.moved_bodies, "count of moved bodies");
    require(a.two_body_tests == b.two_body_tests, "count of two-body tests");
    require(a.cache_hits == b.cache_hits, "count of verdicts that were kept");
    require(a.filtered_count == b.filtered_count, "count of pairs filtered out");
    require(a.clearance.two_body_tests == b.clearance.two_body_tests, "count of tests of the clearance");
    require(a.clearance.cache_hits == b.clearance.cache_hits, "count of verdicts of the clearance that were kept");
    require(a.clearance.candidate_count == b.clearance.candidate_count, "count of candidates of the clearance");
}

}  // namespace ecods::fuzz
