// Binds the questions of cast.hpp and contact.hpp about when a body enters another one, and where it first touches it.
#include <pybind11/stl.h>

#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

template <class A, class B>
void add_rounded_contact_point(py::module_& m) {
    m.def("contact_point", asked<A, Vec3, B, FirstContact>(ECODS_QUESTION(contact_point)), py::arg("a"),
          py::arg("motion"), py::arg("b"), py::arg("contact"),
          "The same of rounded bodies: the point that both share, and the unit vector from one core to the other.");
}

}  // namespace

void bind_entering(py::module_& m) {
    add_record(m, "FirstEntry", "When a body first goes into another one.",
               Field{"time", &FirstEntry::time, "From 0 to less than 1: the true time, rounded once."},
               Field{"a", &FirstEntry::a, "The face of a; none if inner points meet at the start."},
               Field{"b", &FirstEntry::b, "The face of b; none if inner points meet at the start."});
    add_record(m, "BodyEntry", "When something first goes into a body of a world.",
               Field{"body", &BodyEntry::body, "The body's id."}, Field{"entry", &BodyEntry::entry, "The FirstEntry."});
    add_record(m, "ContactPoint", "The point and the normal of a FirstContact.",
               Field{"point", &ContactPoint::point, "(3,) float64, each coordinate rounded once."},
               Field{"normal", &ContactPoint::normal,
                     "Unit vector (3,) from a to b; None for a contact at time 0, and where contact_point() says so."});
    const py::arg a("a"), motion("motion"), b("b");
    m.def(
        "entering", asked<PosedMesh, Vec3, PosedMesh, double>(ECODS_QUESTION(entering)), a, motion, b,
        py::arg("max_time") = 1.0,
        "FirstEntry of a, translated by time times motion (3,), into b, which stays; None if it does not enter before "
        "max_time. Touching does not count: two Solids enter when their interiors meet, two Meshes when a triangle "
        "goes "
        "properly into another one. Exact. Raises NotSupported for a Solid and a Mesh, InvalidArgument.");
    m.def("pose_before", asked<PosedMesh, Vec3, PosedMesh, double>(ECODS_QUESTION(pose_before)), a, motion, b,
          py::arg("time"),
          "Pose (4, 4) of a on its way, at the time or somewhat before, at which it is proven that a is not in b; None "
          "if it is in b at the start. Raises InvalidArgument.");
    m.def("contact_point", asked<PosedMesh, Vec3, PosedMesh, FirstContact>(ECODS_QUESTION(contact_point)), a, motion, b,
          py::arg("contact"),
          "ContactPoint of a FirstContact that cast(a, motion, b) returned. Raises NotSupported for another contact.");
    const py::arg contact("contact");
    add_rounded_contact_point<PosedRounded, PosedRounded>(m);
    add_rounded_contact_point<PosedRounded, PosedMesh>(m);
    add_rounded_contact_point<PosedMesh, PosedRounded>(m);
    m.def("contact_point", asked<Turning<MeshShape>, PosedMesh, FirstContact>(ECODS_QUESTION(contact_point)), a, b,
          contact,
          "The same of a body that turns and b, which stays. The normal is that at the exact time; None unless the "
          "features are a vertex and a face, or two edges.");
    m.def("contact_point", asked<Turning<MeshShape>, Vec3, PosedMesh, FirstContact>(ECODS_QUESTION(contact_point)), a,
          py::arg("motion_of_b"), b, contact, "The same, where b is translated by time times motion_of_b (3,).");
    m.def("contact_point", asked<Way<MeshShape>, PosedMesh, WayContact>(ECODS_QUESTION(contact_point)), py::arg("way"),
          b, contact, "The same of a body on a Way, and the WayContact of its cast.");
    m.def("contact_point", asked<MovingMesh, MovingMesh, FirstContact>(ECODS_QUESTION(contact_point)), a, b, contact,
          "The same of two bodies that each go from one pose to another.");
}

}  // namespace ecods::python
