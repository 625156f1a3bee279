// Binds the questions of hit.hpp about normals and sides of hits, and about the parts of lines inside solids.
#include <pybind11/stl.h>

#include <string>

#include "ecods/hit.hpp"
#include "ecods/solid.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace pybind11::detail {

template <>
struct type_caster<ecods::Passage> : ecods_enum_caster<ecods::Passage> {
    static constexpr auto name = const_name("Passage");
};
template <>
struct type_caster<ecods::PartEnd> : ecods_enum_caster<ecods::PartEnd> {
    static constexpr auto name = const_name("PartEnd");
};

}  // namespace pybind11::detail

namespace ecods::python {
namespace {

void add_side_records(py::module_& m) {
    add_record(m, "SidedHit", "A hit with its normal, and where the line is beside it.",
               Field{"hit", &SidedHit::hit, "The Hit."},
               Field{"before", &SidedHit::before, "Side of the line just before the hit's parameter."},
               Field{"after", &SidedHit::after, "Side of the line just after its leave_parameter."},
               Field{"passage", &SidedHit::passage, "Passage"},
               Field{"normal", &SidedHit::normal,
                     "Unit vector (3,); None for triangles without area, and if the line begins inside."});
    add_record(m, "InsidePart", "A part of a segment or a ray that is inside a solid.",
               Field{"from_parameter", &InsidePart::from, "Where it begins, rounded once."},
               Field{"to_parameter", &InsidePart::to, "Where it ends, rounded once."},
               Field{"begin", &InsidePart::begin, "PartEnd"}, Field{"end", &InsidePart::end, "PartEnd"},
               Field{"from_point", &InsidePart::from_point, "(3,) float64, each coordinate rounded once."},
               Field{"to_point", &InsidePart::to_point, "(3,) float64, each coordinate rounded once."});
    add_record(m, "BodySidedHit", "A hit of a body of a world, with its sides.",
               Field{"body", &BodySidedHit::body, "The body's id."},
               Field{"sided", &BodySidedHit::sided, "The SidedHit; its rank counts the hits of all bodies."});
    add_record(m, "BodyInsidePart", "A part of a segment or a ray that is inside a body of a world.",
               Field{"body", &BodyInsidePart::body, "The body's id."},
               Field{"part", &BodyInsidePart::part, "The InsidePart."});
}

template <class Line>
void add_side_questions(py::module_& m) {
    m.def(
        "sided_hits", asked<Line, PosedMesh>(ECODS_QUESTION(sided_hits)), py::arg("line"), py::arg("body"),
        "all_hits() of a Segment or Ray, each with its normal, and with where the line is just before and after it: a "
        "list of SidedHit. Raises InvalidArgument.");
    m.def("hit_normal", asked<Line, PosedMesh, Hit>(ECODS_QUESTION(hit_normal)), py::arg("line"), py::arg("body"),
          py::arg("hit"),
          "Unit normal (3,) at a Hit of this line and body: of its face; at an edge or a vertex that of the triangle "
          "there which is most opposed to the line. None if no triangle there has an area. Raises InvalidArgument.");
    m.def(
        "inside_parts",
        [](const Line& line, const PosedMesh& solid) {
            const auto posed = as<Solid>(solid, "solid");
            return ask([&] { return inside_parts(line, posed); });
        },
        py::arg("line"), py::arg("solid"),
        "The parts of a Segment or Ray that are inside a Solid: a list of InsidePart, ascending. What only touches the "
        "surface is no part. Raises InvalidArgument.");
}

}  // namespace

void bind_hit_sides(py::module_& m) {
    add_side_records(m);
    add_side_questions<Segment>(m);
    add_side_questions<Ray>(m);
}

}  // namespace ecods::python
