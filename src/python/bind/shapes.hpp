// Defines how Python holds meshes and solids: by shared pointers, so that every object that refers to a mesh keeps it
// alive.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <variant>

#include "ecods/distance.hpp"
#include "ecods/pose.hpp"
#include "ecods/rounded.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {

// These are the C++ types of Python's posed and moving shapes. Python code can make them only from shared pointers, so
// each object keeps its shape alive.
using PosedMesh = Posed<MeshShape>;
using MovingMesh = Moving<MeshShape>;
using PosedRounded = Posed<Rounded>;
using PosedHalfSpace = Posed<HalfSpace>;

// Returns a shape in the form in which pybind11 holds it, without const. No bound function changes it.
inline std::shared_ptr<MeshShape> to_python(const std::shared_ptr<const ecods::Shape>& shape) {
    return std::const_pointer_cast<MeshShape>(std::static_pointer_cast<const MeshShape>(shape));
}

// An AnyShape is a shape of any class that Python has.
using AnyShape = std::variant<std::shared_ptr<MeshShape>, std::shared_ptr<Rounded>, std::shared_ptr<HalfSpace>>;

inline AnyShape to_any_shape(const std::shared_ptr<const ecods::Shape>& shape) {
    if (auto rounded = std::dynamic_pointer_cast<const Rounded>(shape)) {
        return std::const_pointer_cast<Rounded>(std::move(rounded));
    }
    if (auto half_space = std::dynamic_pointer_cast<const HalfSpace>(shape)) {
        return std::const_pointer_cast<HalfSpace>(std::move(half_space));
    }
    return to_python(shape);
}
inline std::shared_ptr<const ecods::Shape> to_shape(const AnyShape& shape) {
    return std::visit([](const auto& one) -> std::shared_ptr<const ecods::Shape> { return one; }, shape);
}

// Returns a pose as text, such as "pose=[[1.0, 0.0, 0.0, 2.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]]".
inline std::string pose_text(const char* name, const Pose& pose) {
    const py::list rows = from_pose(pose).attr("tolist")();
    return std::string(name) + "=" + std::string(py::repr(rows[py::slice(0, 3, 1)]));
}

// Returns the posed mesh with its shape as a `Shape`, which is Solid or ConvexSolid. Throws TypeError if the shape is
// not one.
template <class Shape>
Posed<Shape> as(const PosedMesh& posed, const char* argument) {
    auto solid = std::dynamic_pointer_cast<const Shape>(posed.kept);
    if (solid == nullptr) {
        throw py::type_error(std::string(argument) + ": a " +
                             std::string(py::str(py::type::of<Shape>().attr("__name__"))) + " is expected, not a " +
                             type_name(py::cast(to_python(posed.kept))));
    }
    return {std::move(solid), posed.pose};
}

// Binds copying for classes whose objects never change: a copy of an object is the object itself.
template <class Type>
void copies_are_itself(Type& type) {
    type.def("__copy__", [](py::object self) { return self; });
    type.def(
        "__deepcopy__", [](py::object self, const py::dict&) { return self; }, py::arg("memo"));
}

// Returns a function that returns bounds of the distance of two bodies, given the numbers of a DistanceTolerance.
template <class A, class B>
auto asked_for_distance_bounds() {
    return [](const A& a, const B& b, double relative, double absolute, double most, PairWitness* known) {
        const DistanceTolerance tolerance{.relative = relative, .absolute = absolute, .max_distance = most};
        return ask(known, [&](const Ask& how) { return distance_bounds(a, b, tolerance, how); });
    };
}

// Binds the methods that shapes without triangles and their posed classes share. `name` is the name of the class, and
// text(shape) writes a shape.
template <class Thing, class Text>
void add_posed(py::class_<Posed<Thing>>& posed, py::class_<Thing, std::shared_ptr<Thing>>& type,
               const std::string& name, Text text) {
    using Shared = std::shared_ptr<Thing>;
    using PosedThing = Posed<Thing>;
    const auto shape_of = [](const PosedThing& self) { return std::const_pointer_cast<Thing>(self.kept); };
    type.def(
        "at", [](Shared self, const Pose& pose) { return PosedThing(std::move(self), pose); }, py::arg("pose"),
        "The shape at a pose (4, 4) or (3, 4). Raises InvalidArgument.");
    type.def("__repr__", text);
    copies_are_itself(type);
    posed.def_property_readonly("shape", shape_of, ("The " + name + ".").c_str());
    posed.def_readonly("pose", &PosedThing::pose, "(4, 4) float64.");
    posed.def("__repr__", [name, text](const PosedThing& self) {
        return "Posed" + name + "(" + text(*self.what) + ", " + pose_text("pose", self.pose) + ")";
    });
    posed.def(
        py::pickle([shape_of](const PosedThing& self) { return py::make_tuple(shape_of(self), self.pose); },
                   [](const py::tuple& state) { return PosedThing(state[0].cast<Shared>(), state[1].cast<Pose>()); }));
    posed.def(py::init([](Shared shape, const Pose& pose) { return PosedThing(std::move(shape), pose); }),
              py::arg("shape"), py::arg("pose") = py::none(), (name + ".at(pose). Raises InvalidArgument.").c_str());
    py::implicitly_convertible<Thing, PosedThing>();
}

}  // namespace ecods::python
