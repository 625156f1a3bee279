// When a body on its way first meets another: cast.hpp.
#include "ecods/cast.hpp"

#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {

void bind_casts(py::module_& m) {
    m.def(
        "cast",
        [](const PosedMesh& a, const Vec3& motion, const PosedMesh& b, PairWitness* known) {
            return ask(known, [&](auto& memory, auto& w) { return cast(a, motion, b, memory, w); });
        },
        py::arg("a"), py::arg("motion"), py::arg("b"), py::arg("witness") = py::none(),
        "FirstContact of a, translated by time times motion (3,), with b, which stays; None if there is none up to "
        "time "
        "1. Contact at time 0 and grazing count. Exact. Raises InvalidMotion.");
    m.def(
        "cast",
        [](const MovingMesh& a, const MovingMesh& b, PairWitness* known) {
            return ask(known, [&](auto& memory, auto& w) { return cast(a, b, memory, w); });
        },
        py::arg("a"), py::arg("b"), py::arg("witness") = py::none(),
        "The same of two meshes of which each goes from one pose to another (Mesh.moving): each point straight from "
        "its one place to the other, so that a mesh that turns is not rigid on its way.");
}

}  // namespace ecods::python
