// Segments, rays and balls, and what lines meet of a body: hit.hpp.
#include "ecods/ball.hpp"
#include "ecods/hit.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

template <class Line>
void add_questions(py::module_& m) {
    m.def(
        "first_hit",
        [](const Line& line, const PosedMesh& body, PairWitness* known) {
            return ask(known, [&](auto& memory, auto& w) { return first_hit(line, body, memory, w); });
        },
        py::arg("line"), py::arg("body"), py::arg("witness") = py::none(),
        "The Hit of least parameter of a Segment or Ray, of several the least triangle; None if there is none. Exact.");
    m.def(
        "all_hits",
        [](const Line& line, const PosedMesh& body) {
            return ask([&](auto& memory) { return all_hits(line, body, memory); });
        },
        py::arg("line"), py::arg("body"),
        "Every triangle that is hit, as a list of Hit in the order of real parameters.");
}

}  // namespace

void bind_line_questions(py::module_& m) {
    py::class_<Segment>(m, "Segment", "The closed segment between two points (3,).")
        .def(py::init([](const Vec3& a, const Vec3& b) {
                 const Segment segment{.a = a, .b = b};
                 validate(segment);
                 return segment;
             }),
             py::arg("a"), py::arg("b"), "Raises InvalidSegment unless the ends are finite.")
        .def_property_readonly("a", [](const Segment& self) { return self.a; })
        .def_property_readonly("b", [](const Segment& self) { return self.b; });
    py::class_<Ray>(m, "Ray", "The points origin + s * direction for s from 0 to parameter_max.")
        .def(py::init([](const Vec3& origin, const Vec3& direction, double parameter_max) {
                 const Ray ray{.origin = origin, .direction = direction, .parameter_max = parameter_max};
                 validate(ray);
                 return ray;
             }),
             py::arg("origin"), py::arg("direction"),
             py::arg("parameter_max") = std::numeric_limits<double>::infinity(),
             "Origin and direction are (3,); parameters are in units of the direction. Raises InvalidRay.")
        .def_property_readonly("origin", [](const Ray& self) { return self.origin; })
        .def_property_readonly("direction", [](const Ray& self) { return self.direction; })
        .def_readonly("parameter_max", &Ray::parameter_max);
    py::class_<Ball>(m, "Ball", "The points at a distance of at most the radius from the center (3,).")
        .def(py::init([](const Vec3& center, double radius) {
                 const Ball ball{.center = center, .radius = radius};
                 validate(ball);
                 return ball;
             }),
             py::arg("center"), py::arg("radius"), "Raises InvalidBall.")
        .def_property_readonly("center", [](const Ball& self) { return self.center; })
        .def_readonly("radius", &Ball::radius);
    add_questions<Segment>(m);
    add_questions<Ray>(m);
}

}  // namespace ecods::python
