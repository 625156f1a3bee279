// World: questions about two of its bodies, as of now.
#include "python/bind/world.hpp"

namespace ecods::python {
namespace {

// A question of two bodies and some numbers.
template <class Question, class... Extra>
void add(WorldClass& type, const char* name, const char* doc, Question question, const Extra&... extra) {
    if constexpr (sizeof...(extra) == 0) {
        type.def(
            name,
            [question](SharedWorld& self, BodyId a, BodyId b) {
                return self.ask([&](auto& world, auto&... memory) { return question(world, a, b, memory...); });
            },
            py::arg("a"), py::arg("b"), doc);
    } else {
        type.def(
            name,
            [question](SharedWorld& self, BodyId a, BodyId b, double d) {
                return self.ask([&](auto& world, auto&... memory) { return question(world, a, b, d, memory...); });
            },
            py::arg("a"), py::arg("b"), extra..., doc);
    }
}

// Calls the World's function of that name, which has a form with a memory and one without.
#define ECODS_CALL(name) [](auto& world, auto&... given) { return world.name(given...); }

void add_surfaces(WorldClass& type) {
    const py::arg d("d");
    add(type, "intersects",
        "Whether two bodies share a point, as of now. Raises StaleBody, SameBody, as all of these do.",
        ECODS_CALL(intersects));
    add(type, "relation", "Relation of two bodies.", ECODS_CALL(relation));
    type.def(
        "intersecting_triangles",
        [](SharedWorld& self, BodyId a, BodyId b) {
            return from_triangles(
                self.ask([&](auto& world, auto&... memory) { return world.intersecting_triangles(a, b, memory...); }));
        },
        py::arg("a"), py::arg("b"), "Every pair of triangles that share a point, ascending: (k, 2) uint32.");
    add(type, "distance", "The distance of two bodies, rounded once.", ECODS_CALL(distance));
    add(type, "within", "Whether the distance is at most d, decided for the real number. Raises InvalidDistance.",
        ECODS_CALL(within), d);
    add(type, "closest", "ClosestPoints of two bodies.", ECODS_CALL(closest));
    add(type, "intersections", "What intersecting triangles share: a list of TriangleIntersection.",
        ECODS_CALL(intersections));
    add(type, "close_features", "Pairs of features within d: a list of CloseFeatures. Raises InvalidDistance.",
        ECODS_CALL(close_features), d);
}

}  // namespace

void add_pair_questions(WorldClass& type) {
    add_surfaces(type);
    add(type, "solid_relation", "SolidRelation of two bodies. Raises NotSupported if one is no Solid.",
        ECODS_CALL(solid_relation));
    add(type, "solid_distance",
        "The distance of two ConvexSolids, interiors included. Raises NotSupported, SingularPose.",
        ECODS_CALL(solid_distance));
    add(type, "solid_closest", "ClosestPoints of two ConvexSolids; None where they meet.", ECODS_CALL(solid_closest));
    add(type, "depth", "Depth of two ConvexSolids in each other. Raises SolidsApart.", ECODS_CALL(depth));
    add(type, "depth_bounds", "DepthBounds of two Solids. Raises SolidsApart.", ECODS_CALL(depth_bounds));
}

#undef ECODS_CALL

}  // namespace ecods::python
