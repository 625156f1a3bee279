// Segments, rays and balls, and what lines meet of a body: hit.hpp.
#include "ecods/ball.hpp"
#include "ecods/hit.hpp"
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
        "The Hit of least parameter of a Segment or Ray, of several the least triangle; None if there is none. Exact.");
    m.def("all_hits", asked<Line, PosedMesh>(ECODS_QUESTION(all_hits)), py::arg("line"), py::arg("body"),
          "Every triangle that is hit, as a list of Hit in the order of real parameters.");
}

}  // namespace

void bind_line_questions(py::module_& m) {
    add_record(m, "Segment", "The closed segment between two points (3,).",
               Field{"a", &Segment::a, "Where it begins, (3,) float64."},
               Field{"b", &Segment::b, "Where it ends, (3,) float64."})
        .def(py::init([](const Vec3& a, const Vec3& b) { return checked(Segment{.a = a, .b = b}); }), py::arg("a"),
             py::arg("b"), "Raises InvalidArgument unless the ends are finite.");
    add_record(m, "Ray", "The points origin + s * direction for s from 0 to parameter_max.",
               Field{"origin", &Ray::origin, "(3,) float64."},
               Field{"direction", &Ray::direction, "(3,) float64, as it was given."},
               Field{"parameter_max", &Ray::parameter_max, "Infinity unless it was given."})
        .def(py::init([](const Vec3& origin, const Vec3& direction, double parameter_max) {
                 return checked(Ray{.origin = origin, .direction = direction, .parameter_max = parameter_max});
             }),
             py::arg("origin"), py::arg("direction"),
             py::arg("parameter_max") = std::numeric_limits<double>::infinity(),
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
