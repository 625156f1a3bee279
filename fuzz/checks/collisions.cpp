#include <algorithm>
#include <iterator>

#include "fuzz/base/failure.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/text.hpp"
#include "scenes/numbers_of.hpp"

namespace ecods::fuzz {
namespace {

using Pairs = std::vector<BodyPair>;

void require_pairs(std::span<const BodyPair> got, std::span<const BodyPair> expected, const char* check) {
    if (!std::ranges::equal(got, expected)) throw CheckFailed(check, text(expected), text(got));
}

Pairs only_in_first(std::span<const BodyPair> first, std::span<const BodyPair> second) {
    Pairs result;
    std::ranges::set_difference(first, second, std::back_inserter(result));
    return result;
}

}  // namespace

Pairs true_collisions(const World& world, const Truth& truth) {
    Pairs result;
    for (const TruePair& pair : truth.pairs()) {
        if (!pair.do_meet()) continue;
        if (may_meet(world, pair.ids.a, pair.ids.b)) result.push_back(pair.ids);
    }
    return result;
}

void check_collisions(const World& world, const Pairs& expected, const Truth& truth) {
    Pairs got;
    std::ranges::copy_if(numbers_of(world.colliding_pairs()), std::back_inserter(got),
                         [&](const BodyPair& pair) { return truth.knows(pair.a) && truth.knows(pair.b); });
    require_pairs(got, expected, "colliding pairs");
    if (world.statistics().colliding_count != world.colliding_pairs().size()) {
        throw CheckFailed("colliding count", fmt::format("{}", world.colliding_pairs().size()),
                          fmt::format("{}", world.statistics().colliding_count));
    }
}

void check_events(const World& world, const Pairs& before) {
    const Pairs now = numbers_of(world.colliding_pairs());
    const Pairs then = numbers_of(before);
    require_pairs(numbers_of(world.began()), only_in_first(now, then), "pairs that began");
    require_pairs(numbers_of(world.ended()), only_in_first(then, now), "pairs that ended");
}

void check_invariants(const World& world) {
    try {
        world.check_invariants();
    } catch (const Error& error) {
        throw CheckFailed("invariants", "nothing to complain of", error.what());
    }
}

}  // namespace ecods::fuzz
