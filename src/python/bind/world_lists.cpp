// Binds the updates of World, the lists that updates make, and statistics.
#include "python/bind/world.hpp"

namespace ecods::python {
namespace {

// Binds a method that returns a list of pairs as an array of ids (k, 2). The array is a copy, because the world's own
// list changes with the world.
template <class List>
void add_list(WorldClass& type, const char* name, List list, const char* doc) {
    type.def(
        name,
        [list](SharedWorld& self) {
            return from_pairs(self.change([list](World& world) {
                const std::span<const BodyPair> pairs = (world.*list)();
                return std::vector<BodyPair>(pairs.begin(), pairs.end());
            }));
        },
        doc);
}

py::dict counts_of(const QueryCounts& counts) {
    py::dict by_stage;
    for (const Stage& stage : ecods::stages) by_stage[stage.name] = counts.stages.*stage.count;
    py::dict made;
    made["queries"] = counts.queries;
    made["witness_hits"] = counts.witness_hits;
    made["box_tests"] = counts.box_tests;
    made["triangle_tests"] = counts.stages.triangle_tests;
    made["stages"] = by_stage;
    return made;
}

py::dict dict_of(const Statistics& s) {
    py::dict made;
    made["updates"] = s.updates;
    made["moved_bodies"] = s.moved_bodies;
    made["two_body_tests"] = s.two_body_tests;
    made["cache_hits"] = s.cache_hits;
    made["visited_pairs"] = s.visited_pairs;
    made["body_count"] = s.body_count;
    made["overlapping_count"] = s.overlapping_count;
    made["filtered_count"] = s.filtered_count;
    made["colliding_count"] = s.colliding_count;
    made["close_count"] = s.clearance.close_count;
    made["memory_bytes"] = s.memory_bytes;
    made["queries"] = counts_of(s.queries);
    return made;
}

void add_settings(WorldClass& type) {
    type.def("set_clearance", changing(&World::set_clearance), py::arg("clearance"),
             "Sets the clearance: from the next update on, close_pairs() has the pairs at a distance of at most the "
             "clearance, decided for the real number. None switches this off. Raises InvalidArgument.");
    type.def("clearance", reading(&World::clearance), "The clearance that was set last, or None.");
    type.def("set_relations", changing(&World::set_relations), py::arg("are_listed"),
             "If True, updates compute relations(), from the next update on.");
    type.def("are_relations_listed", reading(&World::are_relations_listed),
             "True if updates compute relations(); False at first.");
}

}  // namespace

void add_lists(WorldClass& type) {
    add_settings(type);
    type.def("update", changing(&World::update), "Brings the lists up to date. The cost depends on how much changed.");
    add_list(type, "overlapping_pairs", &World::overlapping_pairs,
             "Pairs whose boxes overlap and that are not filtered out: (k, 2) uint64.");
    add_list(type, "colliding_pairs", &World::colliding_pairs,
             "Pairs that share a point as of the last update, ascending: (k, 2) uint64. Exact.");
    add_list(type, "began", &World::began, "Pairs that began to collide with the last update: (k, 2) uint64.");
    add_list(type, "ended", &World::ended, "Pairs that ceased to collide with the last update: (k, 2) uint64.");
    add_list(type, "close_pairs", &World::close_pairs, "Pairs within the clearance, colliding ones included. Exact.");
    add_list(type, "close_began", &World::close_began, "Pairs that came within the clearance with the last update.");
    add_list(type, "close_ended", &World::close_ended,
             "Pairs that ceased to be within the clearance with the last update.");
    type.def(
        "relations",
        [](SharedWorld& self) {
            return self.read([](const World& world) {
                return std::vector<PairRelation>(world.relations().begin(), world.relations().end());
            });
        },
        "colliding_pairs(), each with its Relation: a list of PairRelation; empty unless set_relations(True) came "
        "before the update. Exact.");
    type.def(
        "statistics", [](SharedWorld& self) { return dict_of(reading(&World::statistics)(self)); },
        "Counts of the world's work.");
    type.def("check_invariants", reading(&World::check_invariants),
             "Checks every invariant. Slow: for tests. Raises BrokenInvariant.");
    type.def("digest", reading(&World::digest),
             "A hash of the bodies and their collisions as of the last update. Equal scenes have equal digests.");
}

}  // namespace ecods::python
