#include "allocation/world_state.hpp"

#include <algorithm>

#include "scenes/numbers_of.hpp"

namespace ecods::allocation {
namespace {

std::string text(BodyId body) {
    return std::to_string(body.slot) + "." + std::to_string(body.generation);
}

std::string difference(const BodyState& expected, const BodyState& got) {
    if (expected.id != got.id) return "body " + text(got.id) + " in place of " + text(expected.id);
    const std::string of = " of body " + text(got.id);
    if (!(expected.pose == got.pose)) return "the pose" + of;
    if (expected.kind != got.kind || expected.shape_digest != got.shape_digest) return "the shape" + of;
    if (!(expected.box == got.box)) return "the box" + of;
    if (!(expected.filter == got.filter)) return "the filter" + of;
    if (expected.user_data != got.user_data) return "the user data" + of;
    if (expected.switched_off_with != got.switched_off_with) return "the pairs that are switched off" + of;
    return "";
}

std::string difference(const char* list, const std::vector<BodyPair>& expected, const std::vector<BodyPair>& got) {
    if (expected == got) return "";
    return std::string(list) + ": " + std::to_string(got.size()) + " pairs in place of " +
           std::to_string(expected.size());
}

}  // namespace

WorldState state_of(World& world, std::size_t switches_max) {
    const auto list = [](std::span<const BodyPair> pairs) { return numbers_of(pairs); };
    WorldState state{.bodies = {},
                     .overlapping = list(world.overlapping_pairs()),
                     .colliding = list(world.colliding_pairs()),
                     .began = list(world.began()),
                     .ended = list(world.ended()),
                     .clearance = world.clearance(),
                     .close = list(world.close_pairs()),
                     .close_began = list(world.close_began()),
                     .close_ended = list(world.close_ended()),
                     .are_solids_related = world.are_solids_related(),
                     .solids = {},
                     .digest = world.digest(),
                     .overlapping_count = world.statistics().overlapping_count,
                     .filtered_count = world.statistics().filtered_count};
    for (const SolidPair& pair : world.solid_pairs()) {
        state.solids.push_back({{numbers_of(pair.bodies.a), numbers_of(pair.bodies.b)}, pair.relation});
    }
    const auto bodies = world.bodies();
    for (const BodyId body : bodies) {
        const Shape& shape = *world.shape(body);
        BodyState& made = state.bodies.emplace_back(BodyState{.id = numbers_of(body),
                                                              .pose = world.pose(body),
                                                              .kind = shape.kind(),
                                                              .shape_digest = shape.digest(),
                                                              .box = world.box(body),
                                                              .filter = world.filter(body),
                                                              .user_data = world.user_data(body),
                                                              .switched_off_with = {}});
        if (bodies.size() > switches_max) continue;
        for (const BodyId other : bodies) {
            if (other != body && !world.is_pair_enabled(body, other))
                made.switched_off_with.push_back(numbers_of(other));
        }
    }
    return state;
}

std::string difference(const WorldState& expected, const WorldState& got) {
    if (expected.bodies.size() != got.bodies.size()) {
        return std::to_string(got.bodies.size()) + " bodies in place of " + std::to_string(expected.bodies.size());
    }
    for (std::size_t i = 0; i < got.bodies.size(); ++i) {
        if (auto found = difference(expected.bodies[i], got.bodies[i]); !found.empty()) return found;
    }
    for (const auto& [name, list] : {std::pair("colliding", &WorldState::colliding),
                                     {"began", &WorldState::began},
                                     {"ended", &WorldState::ended},
                                     {"close", &WorldState::close},
                                     {"close began", &WorldState::close_began},
                                     {"close ended", &WorldState::close_ended},
                                     {"overlapping", &WorldState::overlapping}}) {
        if (auto found = difference(name, expected.*list, got.*list); !found.empty()) return found;
    }
    if (expected.solids != got.solids) return "the pairs of solids";
    return expected == got ? "" : "the clearance, the digest, or the counts of pairs";
}

}  // namespace ecods::allocation
