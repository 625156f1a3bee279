// Binds turn.hpp: turns, bodies that turn, and their casts.
#include "ecods/turn.hpp"

#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

using TurningMesh = Turning<MeshShape>;

Turn make_turn(const Quaternion& q, const Vec3& from, const Vec3& to) {
    const Turn turn{q, from, to};
    validate(turn);
    return turn;
}

TurningMesh make_turning(std::shared_ptr<MeshShape> mesh, const Pose& start, const Turn& turn) {
    validate(start);
    return TurningMesh(std::move(mesh), start, turn);
}

std::shared_ptr<MeshShape> turning_mesh(const TurningMesh& turning) {
    return to_python(turning.kept);
}

void add_turn(py::module_& m) {
    add_record(
        m, "Turn",
        "A rigid motion in the time from 0 to 1: a body turns by q about a pivot that goes straight from one point "
        "of the world to another.",
        Field{"q", &Turn::q, "The quaternion (w, x, y, z)."}, Field{"pivot_from", &Turn::pivot_from, "(3,) float64."},
        Field{"pivot_to", &Turn::pivot_to, "(3,) float64."})
        .def(py::init(&make_turn), py::arg("q"), py::arg("pivot_from"), py::arg("pivot_to"),
             "Makes a turn by the quaternion q = (w, x, y, z), of any length. Raises InvalidArgument for numbers that "
             "are not finite, and for whole turns.");
}

void add_turning(py::module_& m) {
    py::class_<TurningMesh> type(m, "Turning",
                                 "A mesh that is at a pose at time 0, and then turns. Mesh.turning() makes one, too.");
    type.def(py::init(&make_turning), py::arg("mesh"), py::arg("start"), py::arg("turn"),
             "Mesh.turning(start, turn). Raises InvalidArgument.");
    type.def_property_readonly("mesh", &turning_mesh);
    type.def_readonly("start", &TurningMesh::pose, "(4, 4) float64.");
    type.def_readonly("turn", &TurningMesh::turn);
    type.def("__repr__", [](const TurningMesh& self) {
        return "Turning(" + std::string(py::repr(py::cast(turning_mesh(self)))) + ", " + pose_text("start", self.pose) +
               ", " + std::string(py::repr(py::cast(self.turn))) + ")";
    });
    type.def(
        py::pickle([](const TurningMesh& self) { return py::make_tuple(turning_mesh(self), self.pose, self.turn); },
                   [](const py::tuple& state) {
                       return make_turning(state[0].cast<std::shared_ptr<MeshShape>>(), state[1].cast<Pose>(),
                                           state[2].cast<Turn>());
                   }));
    py::class_<MeshShape, std::shared_ptr<MeshShape>>(m.attr("Mesh"))
        .def("turning", &make_turning, py::arg("start"), py::arg("turn"),
             "The mesh as it turns from a pose on, in the time from 0 to 1.");
}

}  // namespace

void bind_turns(py::module_& m) {
    add_turn(m);
    add_turning(m);
    const auto max_time = py::arg("max_time") = 1.0;
    const auto witness = py::arg("witness") = py::none();
    m.def("cast", asked_with_witness<TurningMesh, PosedMesh, double>(ECODS_QUESTION(cast)), py::arg("a"), py::arg("b"),
          max_time, witness,
          "FirstContact of a body that turns (Mesh.turning), rigid on its way, with b, which stays; None if there is "
          "none up to max_time. Exact. Raises InvalidArgument.");
    m.def("cast", asked_with_witness<TurningMesh, Vec3, PosedMesh, double>(ECODS_QUESTION(cast)), py::arg("a"),
          py::arg("motion_of_b"), py::arg("b"), max_time, witness,
          "The same, where b is translated by time times motion_of_b (3,).");
    m.def("cast", asked_with_witness<TurningMesh, TurningMesh, double>(ECODS_QUESTION(cast)), py::arg("a"),
          py::arg("b"), max_time, witness, "The same of two bodies that turn, each by a turn of its own.");
    m.def("settle", asked_with_witness<TurningMesh, Pose, PosedMesh>(ECODS_QUESTION(settle)), py::arg("turning"),
          py::arg("to"), py::arg("b"), witness,
          "FirstContact with b on the straight way from the real end of a turn to the pose `to`, from which the body "
          "is to "
          "go on; None if that gap is free. The time is that on this way. Triangles alone are asked. Exact. Raises "
          "InvalidArgument.");
    m.def("about", &about, py::arg("axis"), py::arg("angle"), py::arg("pivot"),
          "Turn by an angle in radians about an axis (3,) through a pivot (3,), which stays: a hinge, or a joint of a "
          "robot. Raises InvalidArgument.");
    m.def("between", &between, py::arg("start"), py::arg("end"), py::arg("pivot_in_body"),
          "Turn, the short way, from one pose to another, in which a point (3,) of the body goes straight. Its end is "
          "rounded: see end_gap(). Raises InvalidArgument.");
    m.def("pose_at", py::overload_cast<const Pose&, const Turn&, double>(&pose_at), py::arg("start"), py::arg("turn"),
          py::arg("time"), "The pose (4, 4) at a time, each entry rounded once. Raises InvalidArgument.");
    m.def("angle_at", &angle_at, py::arg("turn"), py::arg("time"),
          "The angle in radians by which a body has turned at a time, rounded once. Raises InvalidArgument.");
    m.def("time_at", &time_at, py::arg("turn"), py::arg("angle"),
          "The time at which a body has turned by an angle, rounded once; 1 for an angle that it does not reach. "
          "Raises InvalidArgument.");
    m.def(
        "end_gap",
        [](const MeshShape& mesh, const Pose& start, const Turn& turn, const Pose& end) {
            return end_gap(mesh, start, turn, end);
        },
        py::arg("mesh"), py::arg("start"), py::arg("turn"), py::arg("end"),
        "An upper bound of the distance of a vertex at the end of a turn from where it is at the pose `end`. Raises "
        "InvalidArgument.");
}

}  // namespace ecods::python
