#include "fuzz/script/manners.hpp"

#include <algorithm>
#include <array>
#include <new>
#include <string_view>

#include "allocation/failing_allocations.hpp"
#include "allocation/world_state.hpp"
#include "ecods/error.hpp"
#include "fuzz/base/failure.hpp"

namespace ecods::fuzz {
namespace {

using allocation::FailingAllocation;
using allocation::Shortage;

void make_with_own_answers(ScriptedWorld& scripted, const Call& call, std::uint32_t, Counters& counters) {
    scripted.world().use_own_answers(true);
    scripted.apply(call);
    scripted.world().use_own_answers(false);
    ++counters["manners: own answers, " + std::string(name_of(call))];
}

// Candidates are unspecified after an update that failed.
void require_unchanged(allocation::WorldState before, World& world, bool is_update, std::string_view call) {
    allocation::WorldState after = allocation::state_of(world);
    if (is_update) {
        before.overlapping = after.overlapping = {};
        before.overlapping_count = after.overlapping_count = 0;
        before.filtered_count = after.filtered_count = 0;
    }
    const std::string found = difference(before, after);
    if (!found.empty()) {
        throw CheckFailed("out of memory", std::string(call) + " that failed has changed nothing", found);
    }
}

// Each failure is followed by another attempt, in the same world, in which a later allocation fails; the last one
// succeeds. Lists that grew at an earlier attempt may keep their room: which allocations are met depends on the choice.
void make_with_failures(ScriptedWorld& scripted, const Call& call, std::uint32_t choice, Counters& counters) {
    const Shortage shortage = choice % 2 == 0 ? Shortage::once : Shortage::lasting;
    const std::uint64_t step = 1 + choice / 2 % 3;
    const bool is_update = std::holds_alternative<Update>(call);
    const allocation::WorldState before = allocation::state_of(scripted.world());
    for (std::uint64_t number = choice / 6 % 12;; number += step) {
        try {
            const FailingAllocation failing(number, shortage);
            scripted.apply(call);
            break;
        } catch (const std::bad_alloc&) {
        }
        ++counters["failed allocations: " + std::string(name_of(call))];
        require_unchanged(before, scripted.world(), is_update, name_of(call));
    }
}

struct MannerKind {
    const char* name;
    void (*make)(ScriptedWorld&, const Call&, std::uint32_t choice, Counters&);
};

constexpr std::array kinds = {MannerKind{"own answers", make_with_own_answers},
                              MannerKind{"failing allocations", make_with_failures}};

}  // namespace

std::vector<std::string> manner_names() {
    std::vector<std::string> names;
    for (const MannerKind& kind : kinds) names.emplace_back(kind.name);
    return names;
}

void make_in_manner(const Manner& manner, const Call& call, Scene& scene, Counters& counters) {
    const auto* const kind = std::ranges::find(kinds, manner.kind, &MannerKind::name);
    if (kind == kinds.end()) throw Error("there is no manner of the name " + manner.kind);
    const ScriptedWorld* const spared = &scene.worlds[manner.choice % scene.worlds.size()];
    scene.apply(call, [&](ScriptedWorld& scripted) {
        if (&scripted == spared) {
            scripted.apply(call);
            return;
        }
        kind->make(scripted, call, manner.choice / 4, counters);
    });
}

}  // namespace ecods::fuzz
