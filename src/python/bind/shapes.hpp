// Meshes and solids as Python holds them: shared, so that whatever refers to a mesh keeps it alive.
#pragma once

#include <memory>
#include <string>
#include <utility>

#include "ecods/convex_solid.hpp"
#include "ecods/motion.hpp"
#include "ecods/posed.hpp"
#include "ecods/shape.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {

// A Posed in Python: owns its shape, unlike the library's Posed.
struct PosedMesh {
    std::shared_ptr<MeshShape> shape;  // never null
    Pose pose;

    operator Posed<MeshShape>() const { return {*shape, pose}; }
};

// A Moving in Python: owns its shape, unlike the library's Moving.
struct MovingMesh {
    std::shared_ptr<MeshShape> shape;  // never null
    Pose from;
    Pose to;

    operator Moving<MeshShape>() const { return {*shape, from, to}; }
};

// Returns the posed mesh as a Solid or a ConvexSolid. Throws TypeError if it is neither.
template <class Shape>
Posed<Shape> as(const PosedMesh& posed, const char* argument) {
    const auto* solid = dynamic_cast<const Shape*>(posed.shape.get());
    if (solid == nullptr) {
        throw py::type_error(std::string(argument) + ": a " +
                             std::string(py::str(py::type::of<Shape>().attr("__name__"))) + " is expected, not a " +
                             type_name(py::cast(posed.shape)));
    }
    return {*solid, posed.pose};
}

// Makes copies of an object the object itself, for classes whose objects never change.
template <class Type>
void copies_are_itself(Type& type) {
    type.def("__copy__", [](py::object self) { return self; });
    type.def(
        "__deepcopy__", [](py::object self, const py::dict&) { return self; }, py::arg("memo"));
}

}  // namespace ecods::python
