#include <algorithm>
#include <string>

#include "geometry/key_box.hpp"
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

// Returns all pairs of living bodies whose boxes overlap. Does not use the broad phase: sorts the boxes along one axis
// and sweeps.
std::vector<ProxyPair> pairs_of_boxes(const Bodies& bodies, const OverlapTracker& boxes) {
    struct Box {
        KeyBox keys;
        ProxyIndex proxy;
    };
    std::vector<Box> sorted;
    for (ProxyIndex proxy = 0; proxy < bodies.end(); ++proxy) {
        if (bodies[proxy].is_alive()) sorted.push_back({key_box(boxes.box(proxy)), proxy});
    }
    std::ranges::sort(sorted, {}, [](const Box& box) { return box.keys.min[0]; });
    std::vector<ProxyPair> pairs;
    for (auto a = sorted.begin(); a != sorted.end(); ++a) {
        for (auto b = a + 1; b != sorted.end() && b->keys.min[0] <= a->keys.max[0]; ++b) {
            if (!overlap(a->keys, b->keys)) continue;
            pairs.push_back({std::min(a->proxy, b->proxy), std::max(a->proxy, b->proxy)});
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

// Throws ShapeChanged if a caller's shape no longer answers as it did when the body got it. Meshes are skipped: they
// cannot change, and their boxes depend on the rounding mode.
void require_unchanged(const Slot& slot, const Aabb& box, BodyId body) {
    if (slot.kind == ShapeKind::mesh()) return;
    if (slot.shape->kind() != slot.kind) throw ShapeChanged(body, slot.kind, "kind");
    if (slot.shape->digest() != slot.shape_digest) throw ShapeChanged(body, slot.kind, "digest");
    if (!(slot.shape->box(slot.pose) == box)) throw ShapeChanged(body, slot.kind, "box");
}

// Throws unless exactly the pairs of boxes that overlap have a verdict, and a new test of each pair gives the same
// answer.
template <class Test>
void validate_verdicts(const VerdictCache& verdicts, const OverlapTracker& boxes, const Bodies& all, Test test) {
    const std::vector<ProxyPair> pairs = pairs_of_boxes(all, boxes);
    require(verdicts.size() == pairs.size(), "the cache has another number of pairs than boxes overlap");
    for (const ProxyPair pair : pairs) {
        const BodyPair bodies = all.ids_of(pair);
        const VerdictIndex index = verdicts.find(pair);
        require(index != no_verdict && verdicts[index].bodies == bodies, text(bodies) + " have no verdict");
        const Verdict& verdict = verdicts[index];
        require(verdict.is_enabled == all.is_enabled(pair), text(bodies) + " are filtered wrongly");
        require(!verdict.is_enabled || verdict.is_positive == test(pair), text(bodies) + " have a stale verdict");
    }
}

}  // namespace

// Relates all pairs from scratch. Throws unless the list has exactly the pairs that are not apart.
void World::Impl::validate_relations(QueryMemory& memory) const {
    std::vector<PairRelation> expected;
    for (const ProxyPair pair : pairs_of_boxes(bodies, broad_phase)) {
        const bool are_solids = bodies[pair.a].solid() != nullptr && bodies[pair.b].solid() != nullptr;
        if (!bodies.is_enabled(pair) || (relations.is_of_solids() && !are_solids)) continue;
        const Relation relation = relate(pair, memory);
        if (relation != Relation::apart) expected.push_back({bodies.ids_of(pair), relation});
    }
    require(expected == relations.list(), "the list of relations is wrong");
}

void World::check_invariants() const {
    const Impl& w = impl();
    w.bodies.validate();
    for (ProxyIndex proxy = 0; proxy < w.bodies.end(); ++proxy) {
        const bool is_alive = w.bodies[proxy].is_alive();
        require(is_alive == w.broad_phase.table().is_present(proxy),
                "a box is there without its body, or a body without");
        if (is_alive) require_unchanged(w.bodies[proxy], w.broad_phase.box(proxy), w.bodies.id_of(proxy));
    }
    require(w.bodies.alive_count() == w.broad_phase.size(), "the broad phase has another number of bodies");
    w.broad_phase.validate();
    w.collisions.validate();

    QueryMemory memory;
    validate_verdicts(w.collisions.verdicts(), w.broad_phase, w.bodies,
                      [&](ProxyPair pair) { return w.ask(pair, &TwoBodyTest::intersects, Ask(memory)); });
    w.closeness.validate(w.bodies, w.broad_phase);
    if (w.relations.are_listed()) w.validate_relations(memory);
    if (!w.closeness.listed()) return;
    validate_verdicts(w.closeness.pairs().verdicts(), w.closeness.tracker(), w.bodies, [&](ProxyPair pair) {
        return w.ask(pair, &TwoBodyTest::within, *w.closeness.listed(), Ask(memory));
    });
}

}  // namespace ecods
