#include <algorithm>
#include <string>

#include "world/world_impl.hpp"

namespace ecods {
namespace {

std::string text(const BodyPair& pair) {
    const auto one = [](BodyId body) { return std::to_string(body.slot) + "." + std::to_string(body.generation); };
    return "bodies " + one(pair.a) + " and " + one(pair.b);
}

void require(bool holds, const std::string& what) {
    if (!holds) throw BrokenInvariant(what);
}

}  // namespace

void World::validate() const {
    const Impl& w = *impl_;
    w.broad_phase->validate();

    std::size_t alive_count = 0;
    for (ProxyIndex proxy = 0; proxy < w.slots.size(); ++proxy) {
        const Slot& slot = w.slots[proxy];
        if (!slot.is_alive()) continue;
        ++alive_count;
        require(slot.box == w.broad_phase->box(proxy), "the broad phase has another box than its body");
    }
    require(alive_count == w.broad_phase->size(), "the broad phase has another number of bodies");

    const auto& pairs = w.broad_phase->pairs();
    require(w.verdicts.size() == pairs.size(), "the cache has another number of pairs than the broad phase");
    require(w.overlapping.size() == pairs.size(), "the list of overlapping pairs has another size");
    QueryMemory memory;
    std::vector<BodyPair> colliding;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        const BodyPair bodies = w.ids_of(pairs[i]);
        require(w.overlapping[i] == bodies, text(bodies) + " are not listed as overlapping");
        const Verdict* verdict = w.verdicts.find(pairs[i]);
        require(verdict != nullptr && verdict->bodies == bodies, text(bodies) + " have no verdict of their own");
        require(verdict->colliding == w.test(pairs[i], memory), text(bodies) + " have a stale verdict");
        require(std::ranges::count(w.verdicts.partners(pairs[i].a), pairs[i].b) == 1 &&
                    std::ranges::count(w.verdicts.partners(pairs[i].b), pairs[i].a) == 1,
                text(bodies) + " are not partners");
        if (verdict->colliding) colliding.push_back(bodies);
    }
    require(colliding == w.colliding, "the list of colliding pairs is not that of the verdicts");
}

}  // namespace ecods
