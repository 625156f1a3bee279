// Converts the library's plain values between C++ and Python. Every file that binds something includes this one, so
// that each value has one form in all signatures.
//
//     BodyId              an int; an array of bodies is an array of uint64. StaleBody if no id is that int
//     AnyId               an int, as an argument only; any int is accepted
//     TrianglePair        a tuple of two ints
//     Vec3                an array (3,)
//     Pose                an array (4, 4); as an argument also (3, 4), or None
//     Aabb                an array (2, 3)
//     Quaternion          a tuple (w, x, y, z); as an argument any four numbers
//     an enum             a member of Python's enum.IntEnum; as an argument also the member's name
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/certificate.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "python/bind/arrays.hpp"
#include "python/bind/errors.hpp"

namespace ecods::python {

// Returns an integer object as a Python int; null for other objects, such as a float or an array of several numbers.
inline py::object integer_of(py::handle value) {
    if (PyFloat_Check(value.ptr()) || !PyIndex_Check(value.ptr())) return {};
    auto integer = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    if (integer) return integer;
    if (PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
    PyErr_Clear();
    return {};
}

// Returns the body id of a Python int; nullopt if the integer is negative or has more than 64 bits.
inline std::optional<BodyId> body_of(const py::object& integer) {
    const std::uint64_t number = PyLong_AsUnsignedLongLong(integer.ptr());
    if (PyErr_Occurred() == nullptr) return body_of(number);
    PyErr_Clear();
    return std::nullopt;
}

// An AnyId holds an id that was given to a function which accepts any integer; the null id if the integer is no id.
struct AnyId {
    BodyId body;
};

// An Enumeration holds Python's enum for an enum of the library: its type, and its members in the order of their
// values, beginning with the value `least`. It lives as long as the process.
struct Enumeration {
    PyObject* type = nullptr;
    std::vector<PyObject*> members;
    int least = 0;
};

template <class Enum>
Enumeration& enumeration() {
    static Enumeration* const kept = new Enumeration;
    return *kept;
}

// Convert pairs of bodies or of triangles from and to tuples.
template <class Pair>
Pair to_pair(py::handle value) {
    using Name = decltype(Pair::a);
    const auto [a, b] = py::cast<std::pair<Name, Name>>(value);
    return {a, b};
}
template <class Pair>
py::object from_pair(const Pair& pair) {
    return py::make_tuple(pair.a, pair.b);
}

inline ShapeKind to_kind(py::handle value) {
    return {py::cast<std::uint32_t>(value)};
}
inline py::object from_kind(ShapeKind kind) {
    return py::int_(kind.value);
}

inline Vec3 to_point(py::handle value) {
    return to_vec3(value, "point or vector");
}

inline Quaternion to_quaternion(py::handle value) {
    constexpr std::array<py::ssize_t, 1> four = {4};
    const Doubles numbers = exact_doubles(value, "quaternion", four);
    return {numbers.at(0), numbers.at(1), numbers.at(2), numbers.at(3)};
}
inline py::object from_quaternion(const Quaternion& q) {
    return py::make_tuple(q.w, q.x, q.y, q.z);
}

// Returns the value of a member of the enum, or of a member's name; nullopt for other objects.
std::optional<int> value_of(py::handle member_or_name, const Enumeration& enumeration);

}  // namespace ecods::python

namespace pybind11::detail {

template <class Enum>
struct ecods_enum_caster {
    PYBIND11_TYPE_CASTER(Enum, const_name("int"));

    bool load(handle source, bool) {
        const auto found = ecods::python::value_of(source, ecods::python::enumeration<Enum>());
        if (found) value = static_cast<Enum>(*found);
        return found.has_value();
    }
    static handle cast(Enum member, return_value_policy, handle) {
        const auto& known = ecods::python::enumeration<Enum>();
        return handle(known.members.at(static_cast<std::size_t>(static_cast<int>(member) - known.least))).inc_ref();
    }
};

#define ECODS_PYTHON_ENUM(Enum, python_name)                  \
    template <>                                               \
    struct type_caster<Enum> : ecods_enum_caster<Enum> {      \
        static constexpr auto name = const_name(python_name); \
    }

ECODS_PYTHON_ENUM(ecods::Sign, "Sign");
ECODS_PYTHON_ENUM(ecods::Relation, "Relation");
ECODS_PYTHON_ENUM(ecods::Feature::Kind, "FeatureKind");
ECODS_PYTHON_ENUM(ecods::ClosestKind, "ClosestKind");
ECODS_PYTHON_ENUM(ecods::HitKind, "HitKind");
ECODS_PYTHON_ENUM(ecods::MeshForm, "MeshForm");
ECODS_PYTHON_ENUM(ecods::Side, "Side");
ECODS_PYTHON_ENUM(ecods::BroadPhaseKind, "BroadPhaseKind");
ECODS_PYTHON_ENUM(ecods::InstructionSet, "InstructionSet");
ECODS_PYTHON_ENUM(ecods::Certificate::Claim, "Claim");
ECODS_PYTHON_ENUM(ecods::Question, "Question");
ECODS_PYTHON_ENUM(ecods::InvalidMesh::Reason, "InvalidMeshReason");
ECODS_PYTHON_ENUM(ecods::NotSolid::Reason, "NotSolidReason");
ECODS_PYTHON_ENUM(ecods::Argument, "Argument");
#undef ECODS_PYTHON_ENUM

template <>
struct type_caster<ecods::BodyId> {
    PYBIND11_TYPE_CASTER(ecods::BodyId, const_name("int"));

    bool load(handle source, bool) {
        const object integer = ecods::python::integer_of(source);
        if (!integer) return false;
        const auto body = ecods::python::body_of(integer);
        if (!body) ecods::python::raise_stale(integer);
        value = *body;
        return true;
    }
    static handle cast(ecods::BodyId body, return_value_policy, handle) {
        return PyLong_FromUnsignedLongLong(ecods::python::number_of(body));
    }
};

template <>
struct type_caster<ecods::python::AnyId> {
    PYBIND11_TYPE_CASTER(ecods::python::AnyId, const_name("int"));

    bool load(handle source, bool) {
        const object integer = ecods::python::integer_of(source);
        if (integer) value = {ecods::python::body_of(integer).value_or(ecods::BodyId{})};
        return static_cast<bool>(integer);
    }
};

template <class Value, auto to_value, auto to_python>
struct ecods_value_caster {
    PYBIND11_TYPE_CASTER(Value, const_name("object"));

    bool load(handle source, bool) {
        value = to_value(source);
        return true;
    }
    static handle cast(const Value& given, return_value_policy, handle) { return object(to_python(given)).release(); }
};

#define ECODS_PYTHON_VALUE(Value, python_name, to_value, to_python)              \
    template <>                                                                  \
    struct type_caster<Value> : ecods_value_caster<Value, to_value, to_python> { \
        static constexpr auto name = const_name(python_name);                    \
    }

ECODS_PYTHON_VALUE(ecods::BodyPair, "Tuple[int, int]", ecods::python::to_pair<ecods::BodyPair>,
                   ecods::python::from_pair<ecods::BodyPair>);
ECODS_PYTHON_VALUE(ecods::TrianglePair, "Tuple[int, int]", ecods::python::to_pair<ecods::TrianglePair>,
                   ecods::python::from_pair<ecods::TrianglePair>);
ECODS_PYTHON_VALUE(ecods::ShapeKind, "int", ecods::python::to_kind, ecods::python::from_kind);
ECODS_PYTHON_VALUE(ecods::Pose, "numpy.ndarray", ecods::python::to_pose, ecods::python::from_pose);
ECODS_PYTHON_VALUE(ecods::Aabb, "numpy.ndarray", ecods::python::to_box, ecods::python::from_box);
ECODS_PYTHON_VALUE(ecods::Quaternion, "Tuple[float, float, float, float]", ecods::python::to_quaternion,
                   ecods::python::from_quaternion);
#undef ECODS_PYTHON_VALUE

// Refuses objects of the module's own classes as points, so that a function may take a point or a body in one place.
template <>
struct type_caster<ecods::Vec3> : ecods_value_caster<ecods::Vec3, ecods::python::to_point, ecods::python::from_vec3> {
    static constexpr auto name = const_name("numpy.ndarray");

    bool load(handle source, bool converts) {
        return get_type_info(Py_TYPE(source.ptr())) == nullptr && ecods_value_caster::load(source, converts);
    }
};

}  // namespace pybind11::detail
