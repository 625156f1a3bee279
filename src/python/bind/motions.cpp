// Binds pose.hpp: how one body moves; and the cast of two bodies that each move in a way of their own.
#include "ecods/pose.hpp"

#include <vector>

#include "ecods/turn.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

template <class OneMotion>
OneMotion valid_motion(const OneMotion& motion) {
    validate(Motion(motion));
    return motion;
}

}  // namespace

void bind_motions(py::module_& m) {
    add_record(m, "Translation", "A motion in the time from 0 to 1: a body is translated by time times a vector.",
               Field{"by", &Translation::by, "(3,) float64."})
        .def(py::init([](const Vec3& by) { return valid_motion(Translation{by}); }),
             py::arg("by") = py::make_tuple(0, 0, 0),
             "Translation() is the motion of a body that stays. Raises InvalidArgument.");
    add_record(m, "Straight",
               "A motion in the time from 0 to 1: each point of a body goes straight to its place at another pose, so "
               "that a body that turns is not rigid on its way. A Turn keeps it rigid.",
               Field{"to", &Straight::to, "(4, 4) float64."})
        .def(py::init([](const Pose& to) { return valid_motion(Straight{to}); }), py::arg("to"),
             "Goes to a pose (4, 4) or (3, 4). Raises InvalidArgument.");
    add_record(m, "WayNode", "A node of a Way: how far a body has turned there since the beginning, and its pivot.",
               Field{"q", &WayNode::q, "The quaternion (w, x, y, z), of any length."},
               Field{"pivot", &WayNode::pivot, "(3,) float64: the place of the pivot in the world."})
        .def(py::init([](const Quaternion& q, const Vec3& pivot) {
                 return WayNode{q, pivot};
             }),
             py::arg("q"), py::arg("pivot") = py::make_tuple(0, 0, 0), "Takes all numbers; a Way checks its nodes.");
    add_record(m, "Along",
               "A motion in the time from 0 to 1: a body goes along the nodes of a Way, each leg in an equal share of "
               "the time. Of n legs, a contact at the time s of leg k is at the time (k + s) / n, rounded once.",
               Field{"nodes", &Along::nodes, "A list of WayNode, a copy."})
        .def(py::init([](const std::vector<WayNode>& nodes) { return valid_motion(Along{nodes}); }), py::arg("nodes"),
             "Takes the nodes of a Way. Raises InvalidArgument with the index of the node.");
    m.def(
        "cast", asked_with_witness<PosedMesh, Motion, PosedMesh, Motion, double>(ECODS_QUESTION(cast)), py::arg("a"),
        py::arg("motion_of_a"), py::arg("b"), py::arg("motion_of_b"), py::arg("max_time") = 1.0,
        py::arg("witness") = py::none(),
        "FirstContact of two bodies that each move by a Translation, a Straight, a Turn or Along nodes; None if there "
        "is none up to max_time. Exact. Raises InvalidArgument; NotSupported where cast() of a turn does, and if one "
        "goes Along nodes and the other one moves.");
}

}  // namespace ecods::python
