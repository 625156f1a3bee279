// Questions about two bodies: intersection.hpp, distance.hpp, contact.hpp.
#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

using Body = const PosedMesh&;
const double infinity = std::numeric_limits<double>::infinity();

void add_intersections(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    m.def(
        "intersects",
        [](Body x, Body y, PairWitness* known) {
            return ask(known, [&](auto& memory, auto& w) { return intersects(x, y, memory, w); });
        },
        a, b, witness, "Whether two bodies share a point. Exact. A body is a Mesh, or Mesh.at(pose).");
    m.def(
        "relation", [](Body x, Body y) { return ask([&](auto& memory) { return relation(x, y, memory); }); }, a, b,
        "Relation: disjoint, touching or crossing, the strongest of any two of their triangles. Exact.");
    m.def(
        "intersecting_triangles",
        [](Body x, Body y) {
            return from_triangles(ask([&](auto& memory) { return intersecting_triangles(x, y, memory); }));
        },
        a, b, "Every pair of triangles that share a point, ascending: (k, 2) uint32, indices of faces of a and of b.");
    m.def(
        "intersections", [](Body x, Body y) { return ask([&](auto& memory) { return intersections(x, y, memory); }); },
        a, b,
        "The same, as a list of TriangleIntersection: with what they share, and the normal where one is defined.");
}

void add_distances(py::module_& m, const py::arg& a, const py::arg& b, const py::arg_v& witness) {
    m.def(
        "distance",
        [](Body x, Body y, PairWitness* known) {
            return ask(known, [&](auto& memory, auto& w) { return distance(x, y, memory, w); });
        },
        a, b, witness,
        "The distance in the unit of the coordinates: the true number, rounded once; 0 exactly when they intersect.");
    m.def(
        "within",
        [](Body x, Body y, double d, PairWitness* known) {
            return ask(known, [&](auto& memory, auto& w) { return within(x, y, d, memory, w); });
        },
        a, b, py::arg("d"), witness,
        "Whether the distance is at most d, decided for the real number. Raises InvalidDistance if d is negative or "
        "NaN.");
    m.def(
        "closest",
        [](Body x, Body y, PairWitness* known) {
            return ask(known, [&](auto& memory, auto& w) { return closest(x, y, memory, w); });
        },
        a, b, witness, "ClosestPoints: where they are closest to each other, and on which features.");
    m.def(
        "distance_bounds",
        [](Body x, Body y, double relative, double absolute, double at_most, PairWitness* known) {
            const DistanceTolerance tolerance{.relative = relative, .absolute = absolute, .at_most = at_most};
            return ask(known, [&](auto& memory, auto& w) { return distance_bounds(x, y, tolerance, memory, w); });
        },
        a, b, py::arg("relative") = 0.0, py::arg("absolute") = 0.0, py::arg("at_most") = infinity, witness,
        "An interval with the distance in it: upper - lower <= max(absolute, relative * lower), or both are adjacent "
        "doubles. Once lower is above at_most, upper may be infinity. Raises InvalidDistance.");
    m.def(
        "close_triangles",
        [](Body x, Body y, double d) { return ask([&](auto& memory) { return close_triangles(x, y, d, memory); }); }, a,
        b, py::arg("d"), "Every pair of triangles within d, as a list of ClosestPoints. Raises InvalidDistance.");
    m.def(
        "close_features",
        [](Body x, Body y, double d) { return ask([&](auto& memory) { return close_features(x, y, d, memory); }); }, a,
        b, py::arg("d"),
        "The pairs of features within d that hold closest points of triangles: a list of CloseFeatures.");
}

}  // namespace

void bind_pair_questions(py::module_& m) {
    using Known = PairWitness;
    add_record(m, "Witness",
               "What decided a pair the last time: given again for a pair that has moved little, it saves time. It is "
               "tried first and never believed; no answer depends on it. Questions change it.",
               Field<Known, std::uint32_t>{"a", &Known::a, "The library's own; 2**32 - 1 at first."},
               Field<Known, std::uint32_t>{"b", &Known::b, "The library's own; 2**32 - 1 at first."})
        .def(py::init<>());
    const py::arg a("a");
    const py::arg b("b");
    const auto witness = py::arg("witness") = py::none();
    add_intersections(m, a, b, witness);
    add_distances(m, a, b, witness);
}

}  // namespace ecods::python
