#include <utility>

#include "fuzz/base/failure.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/text.hpp"

namespace ecods::fuzz {

void check_boxes(const World& world, const Truth& truth, Counters& counters) {
    for (const TrueBody& body : truth.bodies()) {
        if (!body.is_changed) continue;
        ++counters["checked: box contains body"];
        if (oracle::box_contains(world.box(body.id), body.exact)) continue;
        throw CheckFailed("box contains body", "all points of body " + text(body.id) + " in its box", "one outside");
    }
}

void check_candidates(World& world, Counters& counters) {
    const auto bodies = world.bodies();
    std::vector<Aabb> boxes;
    for (const BodyId body : bodies) boxes.push_back(world.box(body));
    std::vector<BodyPair> expected;
    std::size_t filtered_count = 0;
    for (const auto& [i, j] : oracle::overlapping_boxes(boxes)) {
        if (may_meet(world, bodies[i], bodies[j])) {
            expected.push_back({bodies[i], bodies[j]});
        } else {
            ++filtered_count;
        }
    }
    ++counters["checked: candidate lists"];
    counters["checked: candidate pairs"] += expected.size();
    const auto got = world.overlapping_pairs();
    if (!std::ranges::equal(got, expected)) {
        throw CheckFailed("candidate pairs", text(std::span<const BodyPair>(expected)), text(got));
    }
    const Statistics statistics = world.statistics();
    const auto counts = std::pair(statistics.overlapping_count, statistics.filtered_count);
    if (counts != std::pair(expected.size(), filtered_count)) {
        throw CheckFailed("candidate counts", fmt::format("{} and {} filtered out", expected.size(), filtered_count),
                          fmt::format("{} and {}", counts.first, counts.second));
    }
}

}  // namespace ecods::fuzz
