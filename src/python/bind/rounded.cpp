// Binds rounded.hpp: spheres, capsules, margins around bodies, and the questions about them.
#include <sstream>
#include <utility>

#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

using SharedRounded = std::shared_ptr<Rounded>;

SharedRounded made(const std::shared_ptr<const Rounded>& shape) {
    return std::const_pointer_cast<Rounded>(shape);
}

SharedRounded make_rounded(const AnyShape& shape, double radius) {
    return made(rounded(to_shape(shape), radius));
}

std::string rounded_text(const Rounded& self) {
    std::ostringstream text;
    text << "<ecods.Rounded of radius " << std::string(py::repr(py::float_(self.radius()))) << " around "
         << std::string(py::repr(py::cast(to_python(self.core_ptr())))) << ">";
    return text.str();
}

void add_class(py::module_& m) {
    py::class_<PosedRounded> posed(m, "PosedRounded", "A Rounded at a pose, which moves the core alone: Rounded.at().");
    py::class_<Rounded, SharedRounded> type(
        m, "Rounded",
        "All points within `radius` of a core, a Mesh, Solid or ConvexSolid. A pose moves the core; it does not scale "
        "the radius. sphere() and capsule() make some. Immutable.");
    type.def(py::init([](const std::shared_ptr<MeshShape>& core, double radius) {
                 return std::make_shared<Rounded>(core, radius);
             }),
             py::arg("core"), py::arg("radius"),
             "Raises InvalidArgument if the radius is negative, NaN or infinite, or the core is None.");
    type.def_property_readonly(
        "core", [](const Rounded& self) { return to_python(self.core_ptr()); }, "The Mesh, Solid or ConvexSolid.");
    type.def_property_readonly("radius", &Rounded::radius, "A length of the world.");
    type.def_property_readonly("digest", &Rounded::digest, "A hash of core and radius, the same on every machine.");
    type.def("box", &Rounded::box, py::arg("pose") = py::none(), "A box (2, 3) that contains the body at the pose.");
    type.def(py::pickle([](const Rounded& self) { return py::make_tuple(to_python(self.core_ptr()), self.radius()); },
                        [](const py::tuple& state) {
                            return std::make_shared<Rounded>(state[0].cast<std::shared_ptr<MeshShape>>(),
                                                             state[1].cast<double>());
                        }));
    add_posed(posed, type, "Rounded", &rounded_text);
}

template <class A, class B>
void add_questions(py::module_& m) {
    const py::arg a("a"), b("b"), max_distance("max_distance");
    const auto witness = py::arg("witness") = py::none();
    const auto infinite = std::numeric_limits<double>::infinity();
    m.def("intersects", asked_with_witness<A, B>(ECODS_QUESTION(intersects)), a, b, witness);
    m.def("relation", asked<A, B>(ECODS_QUESTION(relation)), a, b,
          "Raises NotSupported if a Rounded with a core that is not convex shares inner points with the other body.");
    m.def("distance", asked_with_witness<A, B>(ECODS_QUESTION(distance)), a, b, witness);
    m.def("within", asked_with_witness<A, B, double>(ECODS_QUESTION(within)), a, b, max_distance, witness);
    m.def("closest", asked_with_witness<A, B>(ECODS_QUESTION(closest)), a, b, witness,
          "ClosestPoints on the rounded surfaces, and the features of the cores.");
    m.def("distance_bounds", asked_for_distance_bounds<A, B>(), a, b, py::arg("relative") = 0.0,
          py::arg("absolute") = 0.0, py::arg("max_distance") = infinite, witness);
    m.def(
        "signed_distance", asked_with_witness<A, B>(ECODS_QUESTION(signed_distance)), a, b, witness,
        "SignedDistance: that of the cores less both radii. Raises NotSupported if the cores share a point and one is "
        "not convex, and SingularPose.");
    m.def(
        "depth", asked_with_witness<A, B>(ECODS_QUESTION(depth)), a, b, witness,
        "Depth of two convex bodies in each other; None if they share no point. Raises NotSupported for other bodies, "
        "and SingularPose.");
    m.def("cast", asked<A, Vec3, B, double>(ECODS_QUESTION(cast)), a, py::arg("motion"), b, py::arg("max_time") = 1.0,
          "FirstContact of a, translated by time times `motion` (3,), with b; None if there is none up to max_time. "
          "Exact. Raises InvalidArgument.");
}

template <class Line>
void add_hits(py::module_& m) {
    const py::arg the_line("line"), the_body("body");
    m.def(
        "first_hit",
        [](const Line& line, const PosedRounded& body) {
            return ask([&] { return body.what->first_hit(line, body.pose, {}); });
        },
        the_line, the_body, "The Hit of least parameter of a Segment or Ray; None if nothing is hit. Exact.");
    m.def(
        "all_hits",
        [](const Line& line, const PosedRounded& body) {
            return ask([&] { return body.what->all_hits(line, body.pose, {}); });
        },
        the_line, the_body,
        "A list of Hit: where the line comes into the body (front), leaves it (back), touches it (face), or begins "
        "inside it. Exact.");
}

void add_points(py::module_& m) {
    const py::arg point("point"), body("body");
    m.def("closest_point", asked<Vec3, PosedRounded>(ECODS_QUESTION(closest)), point, body,
          "ClosestPoint of a rounded body to a point (3,); at distance 0 inside. Raises InvalidArgument.");
    m.def("signed_distance", asked<Vec3, PosedRounded>(ECODS_QUESTION(signed_distance)), point, body,
          "The distance of a point (3,) from the core less the radius, rounded once: negative inside. Raises "
          "InvalidArgument.");
    m.def("locate", asked<Vec3, PosedRounded>(ECODS_QUESTION(locate)), point, body,
          "Location of a point (3,): outside, on or inside. Exact. Raises InvalidArgument.");
}

}  // namespace

void bind_rounded(py::module_& m) {
    add_class(m);
    m.def(
        "sphere", [](double radius, const Vec3& center) { return made(sphere(radius, center)); }, py::arg("radius"),
        py::arg("center") = Vec3(Vec3::Zero()), "A ball, as a Rounded. Raises InvalidArgument.");
    m.def(
        "capsule", [](const Vec3& p, const Vec3& q, double radius) { return made(capsule(p, q, radius)); },
        py::arg("p"), py::arg("q"), py::arg("radius"),
        "All points within `radius` of the segment from p (3,) to q (3,), as a Rounded. Raises InvalidArgument.");
    m.def("rounded", &make_rounded, py::arg("shape"), py::arg("radius"),
          "A Mesh, Solid or ConvexSolid with a margin around it, or a Rounded with a greater radius. Raises "
          "InvalidArgument, and NotSupported if the sum of two radii is no double.");
    add_questions<PosedRounded, PosedRounded>(m);
    add_questions<PosedRounded, PosedMesh>(m);
    add_questions<PosedMesh, PosedRounded>(m);
    add_points(m);
    add_hits<Segment>(m);
    add_hits<Ray>(m);
}

}  // namespace ecods::python
