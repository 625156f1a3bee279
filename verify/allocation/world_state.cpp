#include "allocation/world_state.hpp"

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
    return "";
}

std::string difference(const char* list, const std::vector<BodyPair>& expected, const std::vector<BodyPair>& got) {
    if (expected == got) return "";
    return std::string(list) + ": " + std::to_string(got.size()) + " pairs in place of " +
           std::to_string(expected.size());
}

// A call that failed may have made the slot that its body would have had: the ids to come are the same, and one more of
// them is listed.
std::vector<BodyId> next_ids_of(const World& world) {
    std::vector<BodyId> ids = numbers_of(world.next_ids());
    const auto is_new = [&](std::size_t i) { return ids[i].generation == 0 && ids[i].slot == ids[i - 1].slot + 1; };
    while (ids.size() > 1 && ids[ids.size() - 2].generation == 0 && is_new(ids.size() - 1)) ids.pop_back();
    return ids;
}

}  // namespace

WorldState state_of(World& world) {
    const auto list = [](std::span<const BodyPair> pairs) { return numbers_of(pairs); };
    WorldState state{.bodies = {},
                     .next_ids = next_ids_of(world),
                     .disabled = list(world.disabled_pairs()),
                     .overlapping = list(world.overlapping_pairs()),
                     .colliding = list(world.colliding_pairs()),
                     .began = list(world.began()),
                     .ended = list(world.ended()),
                     .clearance = world.clearance(),
                     .close = list(world.close_pairs()),
                     .close_began = list(world.close_began()),
                     .close_ended = list(world.close_ended()),
                     .are_relations_listed = world.are_relations_listed(),
                     .relations = {},
                     .digest = world.digest(),
                     .overlapping_count = world.statistics().overlapping_count,
                     .filtered_count = world.statistics().filtered_count};
    for (const PairRelation& pair : world.relations()) {
        state.relations.push_back({{numbers_of(pair.bodies.a), numbers_of(pair.bodies.b)}, pair.relation});
    }
    for (const BodyId body : world.bodies()) {
        const Shape& shape = *world.shape(body);
        state.bodies.push_back({.id = numbers_of(body),
                                .pose = world.pose(body),
                                .kind = shape.kind(),
                                .shape_digest = shape.digest(),
                                .box = world.box(body),
                                .filter = world.filter(body),
                                .user_data = world.user_data(body)});
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
    if (expected.next_ids != got.next_ids) return "the ids to come";
    for (const auto& [name, list] : {std::pair("colliding", &WorldState::colliding),
                                     {"disabled", &WorldState::disabled},
                                     {"began", &WorldState::began},
                                     {"ended", &WorldState::ended},
                                     {"close", &WorldState::close},
                                     {"close began", &WorldState::close_began},
                                     {"close ended", &WorldState::close_ended},
                                     {"overlapping", &WorldState::overlapping}}) {
        if (auto found = difference(name, expected.*list, got.*list); !found.empty()) return found;
    }
    if (expected.relations != got.relations) return "the relations";
    return expected == got ? "" : "the clearance, the digest, or the counts of pairs";
}

}  // namespace ecods::allocation
