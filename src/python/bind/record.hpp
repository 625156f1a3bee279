// Makes Python types for answers that have several fields. The types are read-only, are compared field by field, have a
// repr of all fields, and can be pickled.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <tuple>

#include "ecods/hit.hpp"
#include "ecods/shape.hpp"
#include "ecods/trace.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {

// Returns true if two values of a field are equal.
template <class T>
bool are_same(const T& a, const T& b) {
    return a == b;
}
inline bool are_same(const std::shared_ptr<ConvexSolid>& a, const std::shared_ptr<ConvexSolid>& b) {
    return a == b || (a && b && a->digest() == b->digest());
}
inline bool are_same(const Hit& a, const Hit& b) {
    return a.parameter == b.parameter && a.leave_parameter == b.leave_parameter && a.kind == b.kind &&
           a.rank == b.rank && a.feature == b.feature && a.point == b.point && a.leave_point == b.leave_point;
}
inline bool are_same(const SidedHit& a, const SidedHit& b) {
    return are_same(a.hit, b.hit) && a.before == b.before && a.after == b.after && a.passage == b.passage &&
           a.normal == b.normal;
}

inline bool are_same(const std::optional<ReplayReport::Difference>& a,
                     const std::optional<ReplayReport::Difference>& b) {
    const auto members = [](const ReplayReport::Difference& d) { return std::tie(d.update, d.call, d.line, d.what); };
    return a.has_value() == b.has_value() && (!a || members(*a) == members(*b));
}

template <class T, class Value>
struct Field {
    const char* name;
    Value T::*member;
    const char* doc;
};
template <class T, class Value>
Field(const char*, Value T::*, const char*) -> Field<T, Value>;

// Returns a value as text, with all digits: numpy's own repr of an array omits some.
inline std::string text_of_value(const py::object& value) {
    return py::repr(py::isinstance<py::array>(value) ? value.attr("tolist")() : value);
}

template <class T, class... Values>
py::class_<T> add_record(py::module_& m, const char* name, const char* doc, Field<T, Values>... fields) {
    py::class_<T> type(m, name, doc);
    (type.def_property_readonly(
         fields.name, [member = fields.member](const T& self) { return self.*member; }, fields.doc),
     ...);
    type.def(
        "__eq__",
        [fields...](const T& self, const T& other) {
            return (are_same(self.*fields.member, other.*fields.member) && ...);
        },
        py::is_operator());
    type.def("__repr__", [name, fields...](const T& self) {
        std::string text;
        ((text +=
          (text.empty() ? "" : ", ") + std::string(fields.name) + "=" + text_of_value(py::cast(self.*fields.member))),
         ...);
        return std::string(name) + "(" + text + ")";
    });
    type.def(py::pickle([fields...](const T& self) { return py::make_tuple(self.*fields.member...); },
                        [fields...](const py::tuple& state) {
                            if (state.size() != sizeof...(Values)) throw py::value_error("a state of another type");
                            T made{};
                            std::size_t at = 0;
                            ((made.*fields.member = state[at++].template cast<Values>()), ...);
                            return made;
                        }));
    return type;
}

}  // namespace ecods::python
