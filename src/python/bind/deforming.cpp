// Binds the casts of deforming meshes and to a distance (cast.hpp).
#include "ecods/cast.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "python/bind/arrays.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

Deforming make_deforming(std::shared_ptr<MeshShape> mesh, const py::object& vertices) {
    const Doubles points = exact_points(vertices, "vertices");
    std::vector<Vec3> at_end(static_cast<std::size_t>(points.shape(0)));
    std::copy_n(points.data(), points.size(), at_end.empty() ? nullptr : at_end.front().data());
    const py::gil_scoped_release release;
    return Deforming(std::move(mesh), std::move(at_end));
}

std::shared_ptr<MeshShape> deforming_mesh(const Deforming& self) {
    return to_python(self.shape());
}
py::array_t<double> vertices_at_end(const Deforming& self) {
    return from_points(self.mesh_at_end().vertices());
}

void add_deforming(py::module_& m) {
    py::class_<Deforming> type(m, "Deforming",
                               "A mesh whose vertices each go from their place at time 0, in the Mesh, to another one "
                               "at time 1, on a straight "
                               "line: cloth, a soft body, a step of a simulation. It is a surface. Immutable.");
    type.def(py::init(&make_deforming), py::arg("mesh"), py::arg("vertices"),
             "Makes one of a Mesh and the vertices (n, 3) at time 1. Raises InvalidMesh, also for too few vertices.");
    type.def_property_readonly("mesh", &deforming_mesh, "The Mesh at time 0.");
    type.def_property_readonly("vertices", &vertices_at_end, "(n, 3) float64: at time 1.");
    type.def_property_readonly("box", &Deforming::box, "(2, 3) float64: the box of all triangles at all times.");
    type.def("__repr__", [](const Deforming& self) {
        return "<ecods.Deforming of " + std::string(py::repr(py::cast(deforming_mesh(self)))) + ">";
    });
    copies_are_itself(type);
    type.def(py::pickle(
        [](const Deforming& self) { return py::make_tuple(deforming_mesh(self), vertices_at_end(self)); },
        [](const py::tuple& state) { return make_deforming(state[0].cast<std::shared_ptr<MeshShape>>(), state[1]); }));
}

template <class A, class B>
void add_deforming_casts(py::module_& m, const char* text) {
    m.def("cast", asked_with_witness<A, B, double>(ECODS_QUESTION(cast)), py::arg("a"), py::arg("b"),
          py::arg("max_time") = 1.0, py::arg("witness") = py::none(), text);
}

template <class A, class B>
void add_cast_to_distance(py::module_& m, const char* text) {
    m.def("cast_to_distance", asked_with_witness<A, Vec3, B, double, double>(ECODS_QUESTION(cast_to_distance)),
          py::arg("a"), py::arg("motion"), py::arg("b"), py::arg("distance"), py::arg("max_time") = 1.0,
          py::arg("witness") = py::none(), text);
}

}  // namespace

void bind_deforming(py::module_& m) {
    add_deforming(m);
    add_deforming_casts<Deforming, PosedMesh>(
        m, "FirstContact of a Deforming mesh with a body that stays or moves, or with another Deforming mesh.");
    add_deforming_casts<PosedMesh, Deforming>(m, "");
    add_deforming_casts<Deforming, MovingMesh>(m, "");
    add_deforming_casts<MovingMesh, Deforming>(m, "");
    add_deforming_casts<Deforming, Deforming>(m, "");
    add_cast_to_distance<PosedMesh, PosedMesh>(
        m,
        "FirstContact at the first time at which a, translated by time times motion (3,), is within the distance of b, "
        "which stays; None if it is not up to max_time. Exact. Raises InvalidArgument.");
    add_cast_to_distance<PosedRounded, PosedRounded>(m, "");
    add_cast_to_distance<PosedRounded, PosedMesh>(m, "");
    add_cast_to_distance<PosedMesh, PosedRounded>(m, "");
}

}  // namespace ecods::python
