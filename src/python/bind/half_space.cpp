// Binds solid.hpp: a ground or a wall, and the questions about a body and a half space.
#include "ecods/solid.hpp"

#include <sstream>
#include <utility>

#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

std::string half_space_text(const HalfSpace& self) {
    std::ostringstream text;
    text << "<ecods.HalfSpace of normal " << std::string(py::repr(py::cast(self.normal()).attr("tolist")()))
         << " and offset " << std::string(py::repr(py::float_(self.offset()))) << ">";
    return text.str();
}

void add_half_space_class(py::module_& m) {
    py::class_<PosedHalfSpace> posed(m, "PosedHalfSpace", "A HalfSpace at a pose: HalfSpace.at().");
    py::class_<HalfSpace, std::shared_ptr<HalfSpace>> type(
        m, "HalfSpace",
        "The points x with normal . x <= offset: a ground, a wall. The normal "
        "points out of it, and may have any length "
        "but 0. Immutable.");
    type.def(py::init<const Vec3&, double>(), py::arg("normal"), py::arg("offset"),
             "Raises InvalidArgument if a number is NaN or infinite, or the normal is zero.");
    type.def_property_readonly("normal", &HalfSpace::normal, "(3,) float64, as given.");
    type.def_property_readonly("offset", &HalfSpace::offset, "As given.");
    type.def_property_readonly("digest", &HalfSpace::digest, "A hash of the numbers, the same on every machine.");
    type.def(
        "box", &HalfSpace::box, py::arg("pose") = py::none(),
        "A box (2, 3) with infinite ends, but for a side on which the plane is across an axis. Raises SingularPose.");
    type.def(py::pickle([](const HalfSpace& self) { return py::make_tuple(self.normal(), self.offset()); },
                        [](const py::tuple& state) {
                            return std::make_shared<HalfSpace>(state[0].cast<Vec3>(), state[1].cast<double>());
                        }));
    add_posed(posed, type, "HalfSpace", &half_space_text);
}

// Binds the questions that bodies of all kinds have with a half space.
template <class Body>
void add_half_space_questions(py::module_& m) {
    const py::arg a("a"), b("b");
    m.def("intersects", asked<Body, PosedHalfSpace>(ECODS_QUESTION(intersects)), a, b);
    m.def("relation", asked<Body, PosedHalfSpace>(ECODS_QUESTION(relation)), a, b);
    m.def("distance", asked<Body, PosedHalfSpace>(ECODS_QUESTION(distance)), a, b);
    m.def("within", asked<Body, PosedHalfSpace, double>(ECODS_QUESTION(within)), a, b, py::arg("max_distance"));
}

template <class Body>
void add_half_space_numbers(py::module_& m) {
    const py::arg a("a"), b("b");
    m.def("signed_distance", asked<Body, PosedHalfSpace>(ECODS_QUESTION(signed_distance)), a, b,
          "SignedDistance of the body's lowest point from the plane, negative inside: then how far the body must go to "
          "leave the half space. Raises SingularPose.");
    m.def("closest", asked<Body, PosedHalfSpace>(ECODS_QUESTION(closest)), a, b,
          "ClosestPoints: the lowest vertex, and its foot on the plane. Raises SingularPose.");
}

}  // namespace

void bind_half_spaces(py::module_& m) {
    const py::arg a("a"), b("b");
    const auto max_time = py::arg("max_time") = 1.0;
    add_half_space_class(m);
    add_half_space_questions<PosedMesh>(m);
    add_half_space_questions<PosedRounded>(m);
    add_half_space_questions<PosedHalfSpace>(m);
    add_half_space_numbers<PosedMesh>(m);
    add_half_space_numbers<PosedRounded>(m);
    m.def("cast", asked<PosedMesh, Vec3, PosedHalfSpace, double>(ECODS_QUESTION(cast)), a, py::arg("motion"), b,
          max_time, "FirstContact of a body that is translated with a half space. Raises InvalidArgument.");
    m.def("cast", asked<PosedRounded, Vec3, PosedHalfSpace, double>(ECODS_QUESTION(cast)), a, py::arg("motion"), b,
          max_time, "FirstContact of a rounded body that is translated with a half space. Raises InvalidArgument.");
}

}  // namespace ecods::python
