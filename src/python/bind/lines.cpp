// Binds hit.hpp: segments, rays and balls, and the triangles of a body that a line hits.
#include "ecods/hit.hpp"
#include "ecods/primitives.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

template <class T>
T checked(T made) {
    validate(made);
    return made;
}

template <class Line>
void add_questions(py::module_& m) {
    m.def(
        "first_hit", asked_with_witness<Line, PosedMesh>(ECODS_QUESTION(first_hit)), py::arg("line"), py::arg("body"),
        py::arg("witness") = py::none(),
        "The Hit of least parameter of a Segment or Ray, and of least triangle among equals; None if nothing is hit. A "
        "line that begins inside a Solid hits it there, at 0. Exact.");
    m.def("all_hits", asked<Line, PosedMesh>(ECODS_QUESTION(all_hits)), py::arg("line"), py::arg("body"),
          "Every triangle that is hit, as a list of Hit in the order of real parameters; first of all the inside of a "
          "Solid, if the line begins there.");
}

}  // namespace

void bind_line_questions(py::module_& m) {
    add_record(m, "Segment", "The closed segment between two points (3,).",
               Field{"a", &Segment::a, "The first end, (3,) float64."},
               Field{"b", &Segment::b, "The second end, (3,) float64."})
        .def(py::init([](const Vec3& a, const Vec3& b) { return checked(Segment{.a = a, .b = b}); }), py::arg("a"),
             py::arg("b"), "Raises InvalidArgument unless the ends are finite.");
    add_record(m, "Ray", "The points origin + s * direction for s from 0 to max_parameter.",
               Field{"origin", &Ray::origin, "(3,) float64."},
               Field{"direction", &Ray::direction, "(3,) float64, as it was given."},
               Field{"max_parameter", &Ray::max_parameter, "Infinity unless it was given."})
        .def(py::init([](const Vec3& origin, const Vec3& direction, double max_parameter) {
                 return checked(Ray{.origin = origin, .direction = direction, .max_parameter = max_parameter});
             }),
             py::arg("origin"), py::arg("direction"),
             py::arg("max_parameter") = std::numeric_limits<double>::infinity(),
             "Origin and direction are (3,); parameters are in units of the direction. Raises InvalidArgument.");
    add_record(m, "Ball", "The points at a distance of at most the radius from the center (3,).",
               Field{"center", &Ball::center, "(3,) float64."}, Field{"radius", &Ball::radius, "Not negative."})
        .def(py::init(
                 [](const Vec3& center, double radius) { return checked(Ball{.center = center, .radius = radius}); }),
             py::arg("center"), py::arg("radius"), "Raises InvalidArgument.");
    add_questions<Segment>(m);
    add_questions<Ray>(m);
}

}  // namespace ecods::python
