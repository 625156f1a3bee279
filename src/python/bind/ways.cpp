// Binds turn.hpp: paths of several turns, and their casts.
#include "ecods/turn.hpp"

#include <string>
#include <utility>
#include <vector>

#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

using WayOfMesh = Way<MeshShape>;
using WayNodes = std::vector<WayNode>;

WayOfMesh make_way(std::shared_ptr<MeshShape> mesh, const Pose& start, WayNodes nodes) {
    validate(start);
    validate(nodes);
    return WayOfMesh(std::move(mesh), start, std::move(nodes));
}

std::shared_ptr<MeshShape> mesh_on_way(const WayOfMesh& way) {
    return to_python(way.kept);
}

void add_way_records(py::module_& m) {
    add_record(m, "WayContact", "The first contact on a Way.",
               Field{"leg", &WayContact::leg, "The leg; 0 is that from node 0 to node 1."},
               Field{"contact", &WayContact::contact, "The FirstContact, whose time is that in the leg."});
}

void add_way(py::module_& m) {
    py::class_<WayOfMesh> type(m, "Way",
                               "A mesh that is at a pose at the first node, and goes on from node to node, each leg a "
                               "turn that takes a time from 0 to 1. It stays rigid, and there are no gaps.");
    type.def(
        py::init(&make_way), py::arg("mesh"), py::arg("start"), py::arg("nodes"),
        "Takes two or more WayNodes; the first one's q is (w, 0, 0, 0), w positive. Raises InvalidArgument with the "
        "index of the node.");
    type.def_property_readonly("mesh", &mesh_on_way);
    type.def_readonly("start", &WayOfMesh::pose, "(4, 4) float64.");
    type.def_property_readonly(
        "nodes", [](const WayOfMesh& self) { return self.nodes; }, "A list of WayNode, a copy.");
    type.def("__repr__", [](const WayOfMesh& self) {
        return "Way(" + std::string(py::repr(py::cast(mesh_on_way(self)))) + ", " + pose_text("start", self.pose) +
               ", nodes=" + std::string(py::repr(py::cast(self.nodes))) + ")";
    });
    type.def(py::pickle([](const WayOfMesh& self) { return py::make_tuple(mesh_on_way(self), self.pose, self.nodes); },
                        [](const py::tuple& state) {
                            return make_way(state[0].cast<std::shared_ptr<MeshShape>>(), state[1].cast<Pose>(),
                                            state[2].cast<WayNodes>());
                        }));
}

}  // namespace

void bind_ways(py::module_& m) {
    add_way_records(m);
    add_way(m);
    const auto witness = py::arg("witness") = py::none();
    m.def("cast", asked_with_witness<WayOfMesh, PosedMesh>(ECODS_QUESTION(cast)), py::arg("way"), py::arg("b"), witness,
          "WayContact of a body on a Way with b, which stays; None if there is none on any leg. Exact. Raises "
          "InvalidArgument.");
    m.def("settle", asked_with_witness<WayOfMesh, Pose, PosedMesh>(ECODS_QUESTION(settle)), py::arg("way"),
          py::arg("to"), py::arg("b"), witness, "The same from the end of the last leg of a Way.");
    m.def(
        "pose_at",
        [](const Pose& start, const WayNodes& nodes, std::size_t leg, double time) {
            return pose_at(start, nodes, leg, time);
        },
        py::arg("start"), py::arg("nodes"), py::arg("leg"), py::arg("time"),
        "The same at a time of a leg of a Way with these nodes.");
}

}  // namespace ecods::python
