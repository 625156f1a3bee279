// Makes Python enums for the library's enums.
#include <algorithm>
#include <concepts>
#include <initializer_list>
#include <ostream>
#include <sstream>

#include "ecods/hit.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {
namespace {

// Makes the Python type of an enum whose members have these names and consecutive values from `least` on.
void make(py::module_& m, Enumeration& made, const char* name, const char* doc, const std::vector<std::string>& names,
          int least) {
    py::dict values;
    for (std::size_t i = 0; i < names.size(); ++i) values[names[i].c_str()] = least + static_cast<int>(i);
    py::object type = py::module_::import("enum").attr("IntEnum")(name, values, py::arg("module") = "ecods");
    type.attr("__doc__") = doc;
    type.attr("__str__") =
        py::cpp_function([](py::handle self) { return self.attr("name"); }, py::name("__str__"), py::is_method(type));
    for (const std::string& each : names) made.members.push_back(py::object(type.attr(each.c_str())).release().ptr());
    made.least = least;
    m.attr(name) = type;
    made.type = type.release().ptr();
}

template <class Enum>
void make(py::module_& m, const char* name, const char* doc, std::initializer_list<std::string> names) {
    make(m, enumeration<Enum>(), name, doc, names, 0);
}

// Makes the Python type of an enum, with the names that the library prints for its values.
template <class Enum>
void make(py::module_& m, const char* name, const char* doc, Enum least, Enum greatest) {
    std::vector<std::string> names;
    for (int value = static_cast<int>(least); value <= static_cast<int>(greatest); ++value) {
        std::ostringstream text;
        text << static_cast<Enum>(value);
        std::string written = text.str();
        std::ranges::replace(written, ' ', '_');
        std::ranges::replace(written, '-', '_');
        names.push_back(std::move(written));
    }
    make(m, enumeration<Enum>(), name, doc, names, static_cast<int>(least));
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
    make(m, "Sign", "The sign of a real number.", Sign::negative, Sign::positive);
    make(m, "Relation",
         "The relation of the first of two sets to the second. Surfaces, and triangles, are apart, touching or "
         "crossing: they "
         "share no point; they share one; or two triangles that are not coplanar share a point inside both. Two solids "
         "are anything but crossing. A surface and a solid are apart, touching or crossing, or the surface is inside: "
         "then the solid contains it.",
         Relation::apart, Relation::equal);
    make<MeshForm>(m, "MeshForm", "The set that a Mesh, a Solid or a ConvexSolid is.", {"surface", "solid", "convex"});
    make<Feature::Kind>(m, "FeatureKind",
                        "The kind of a Feature of a mesh; `none` for a point inside a solid, which is on no feature.",
                        {"vertex", "edge", "face", "none"});
    make<ClosestKind>(m, "ClosestKind",
                      "The kinds of the two features that hold the closest points, or touch first; `intersecting` if "
                      "the bodies share a point, and `contained` if they do and no two triangles do.",
                      {"vertex_vertex", "vertex_edge", "vertex_face", "edge_edge", "intersecting", "contained"});
    make(m, "HitKind",
         "How a line meets a triangle: inside the face, from the side of its normal, from the other one or from none; "
         "in an edge or a vertex; or at more than one point. `inside`: no triangle, as the line begins inside a solid.",
         HitKind::front, HitKind::inside);
    make<Passage>(m, "Passage", "What a line does at a hit: SidedHit.passage.",
                  {"enters", "leaves", "grazes", "crosses", "begins"});
    make<PartEnd>(m, "PartEnd", "How a part of a line inside a solid begins or ends.",
                  {"of_line", "crosses", "grazes", "along"});
    make(m, "Side", "The place of a point with respect to a solid.", Side::outside, Side::inside);
    make<BroadPhaseKind>(m, "BroadPhaseKind", "The way of finding overlapping boxes. No answer depends on it.",
                         {"brute_force", "sweep_and_prune", "kept_candidates", "automatic"});
    make(m, "InstructionSet",
         "Instructions of the processor; each set includes the sets before it. No answer depends on them.",
         InstructionSet::baseline, InstructionSet::avx512);
    make<Certificate::Claim>(m, "Claim", "The claim that a Certificate proves.",
                             {"disjoint", "touching", "crossing", "distance", "within", "beyond", "hit", "miss"});
    make<Question>(m, "Question", "The question that NotSupported names.",
                   {"relation", "intersecting_triangles", "distance", "within", "closest", "intersections",
                    "close_features", "cast", "cast_moving", "hits", "intersects", "certify", "cast_any_motion"});
    make<InvalidMesh::Reason>(m, "InvalidMeshReason", "The reason of an InvalidMesh.",
                              {"empty", "vertex", "index", "layout", "too_large"});
    make<NotSolid::Reason>(m, "NotSolidReason", "The reason of a NotSolid.",
                           {"open_edge", "self_intersection", "dent", "no_interior"});
    make<Argument>(m, "Argument", "The argument that InvalidArgument is about.",
                   {"pose", "box", "segment", "ray", "point", "motion", "ball", "half_space", "distance", "time",
                    "list_length", "null", "mesh_and_shape", "size", "count", "polygon", "turn"});
}

}  // namespace ecods::python
