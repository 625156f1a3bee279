// The library's enums as Python's.
#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <ostream>
#include <sstream>

#include "python/bind/bind.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {
namespace {

// Makes the type of an enum whose values from the least to the greatest have these names.
void make(py::module_& m, Enumeration& made, const char* name, const std::vector<std::string>& names, int least) {
    py::dict values;
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i].c_str()] = least + static_cast<int>(i);
    py::object type = py::module_::import("enum").attr("IntEnum")(name, values, py::arg("module") = "ecods");
    type.attr("__str__") =
        py::cpp_function([](py::handle self) { return self.attr("name"); }, py::name("__str__"), py::is_method(type));
    for (const std::string& each : names) made.members.push_back(py::object(type.attr(each.c_str())).release().ptr());
    made.least = least;
    m.attr(name) = type;
    made.type = type.release().ptr();
}

template <class Enum>
void make(py::module_& m, const char* name, std::initializer_list<std::string> names) {
    make(m, enumeration<Enum>(), name, names, 0);
}

// With the names that the library writes.
template <class Enum>
void make(py::module_& m, const char* name, Enum least, Enum greatest) {
    std::vector<std::string> names;
    for (int value = static_cast<int>(least); value <= static_cast<int>(greatest); ++value) {
        std::ostringstream text;
        text << static_cast<Enum>(value);
        std::string written = text.str();
        std::ranges::replace(written, ' ', '_');
        std::ranges::replace(written, '-', '_');
        names.push_back(std::move(written));
    }
    make(m, enumeration<Enum>(), name, names, static_cast<int>(least));
}

}  // namespace

std::optional<int> value_of(py::handle member_or_name, const Enumeration& enumeration) {
    if (PyObject_TypeCheck(member_or_name.ptr(), reinterpret_cast<PyTypeObject*>(enumeration.type)) != 0) {
        return static_cast<int>(PyLong_AsLong(member_or_name.ptr()));
    }
    if (!py::isinstance<py::str>(member_or_name)) return std::nullopt;
    const py::object members = py::handle(enumeration.type).attr("__members__");
    if (!members.contains(member_or_name)) return std::nullopt;
    return members[member_or_name].cast<int>();
}

void bind_enums(py::module_& m) {
    make(m, "Sign", Sign::negative, Sign::positive);
    make(m, "Relation", Relation::disjoint, Relation::crossing);
    make<Feature::Kind>(m, "FeatureKind", {"vertex", "edge", "face"});
    make<ClosestKind>(m, "ClosestKind", {"vertex_vertex", "vertex_edge", "vertex_face", "edge_edge", "intersecting"});
    make(m, "HitKind", HitKind::front, HitKind::along);
    make(m, "Side", Side::outside, Side::inside);
    make(m, "SolidRelation", SolidRelation::apart, SolidRelation::equal);
    make(m, "SurfaceRelation", SurfaceRelation::apart, SurfaceRelation::partly_inside);
    make<BroadPhaseKind>(m, "BroadPhaseKind", {"brute_force", "sweep_and_prune", "kept_candidates", "automatic"});
    make(m, "InstructionSet", InstructionSet::baseline, InstructionSet::avx512);
    make<Certificate::Claim>(m, "Claim",
                             {"disjoint", "touching", "crossing", "distance", "within", "beyond", "hit", "miss"});
    make<Question>(m, "Question",
                   {"relation", "intersecting_triangles", "distance", "within", "closest", "intersections",
                    "close_features", "cast", "cast_moving", "hits"});
}

}  // namespace ecods::python
