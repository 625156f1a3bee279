// Makes Python exceptions for the library's errors, with the same names, texts and members.
#include "python/bind/errors.hpp"

#include <functional>
#include <map>
#include <typeindex>

#include "python/bind/bind.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {
namespace {

struct Known {
    PyObject* type;
    std::function<void(const Error&, py::object&)> add_members;
};

// Returns the known errors by type. The map is never destroyed, because exceptions may be raised until the process
// ends.
std::map<std::type_index, Known>& known() {
    static auto* const kept = new std::map<std::type_index, Known>;
    return *kept;
}
PyObject* base_type = nullptr;

PyObject* make_type(py::module_& m, const char* name, const char* doc, PyObject* base) {
    PyObject* const type = PyErr_NewExceptionWithDoc(("ecods." + std::string(name)).c_str(), doc, base, nullptr);
    if (type == nullptr) throw py::error_already_set();
    m.attr(name) = py::handle(type);
    return type;
}

template <class E, class Value>
struct Member {
    const char* name;
    Value E::*member;
};

template <class E, class Value>
Member<E, Value> member(const char* name, Value E::*member) {
    return {name, member};
}

template <class E, class... Values>
void add(py::module_& m, const char* name, const char* doc, Member<E, Values>... members) {
    const auto add_members = [members...]([[maybe_unused]] const Error& error, py::object& raised) {
        [[maybe_unused]] const E& e = static_cast<const E&>(error);
        ((raised.attr(members.name) = py::cast(e.*members.member)), ...);
    };
    known()[typeid(E)] = {make_type(m, name, doc, base_type), add_members};
}

std::string stale_text(const std::string& number, ListIndex index) {
    return (index ? "entry " + std::to_string(*index) + ": " : "") + "id " + number + " names no body of this world";
}

// Returns the library's text of an error, with the id of a body in Python's form, an integer.
std::string message_of(const Error& error) {
    const auto* const stale = dynamic_cast<const StaleBody*>(&error);
    if (stale == nullptr) return error.what();
    const std::string number = std::to_string(number_of(stale->body));
    if (!stale->body) return stale_text(number, stale->index);
    return std::string(error.what()) + " (id " + number + ")";
}

// Returns Python's exception for an error, with the members of the error and `text` as its message.
py::object exception_of(const Error& error, const std::string& text) {
    const auto at = known().find(typeid(error));
    py::object raised = py::handle(at == known().end() ? base_type : at->second.type)(text);
    if (at != known().end()) at->second.add_members(error, raised);
    return raised;
}

void set(const py::object& raised) {
    PyErr_SetObject(py::type::handle_of(raised).ptr(), raised.ptr());
}

// Adds the errors about input. The reason of an error says which members have a meaning; the other members have their
// defaults, as in C++.
void add_input_errors(py::module_& m) {
    using Mesh = InvalidMesh;
    add<Mesh>(
        m, "InvalidMesh",
        "Vertices and faces do not make a mesh. `reason` is an InvalidMeshReason: empty; vertex (`vertex`, `axis`, "
        "`value`), a coordinate that is not finite; index (`triangle`, `corner`, `index`, which may be negative, "
        "`vertex_count`); layout (`number_count`, `stride`); too_large (`vertex_count`, `triangle_count`).",
        member("reason", &Mesh::reason), member("vertex", &Mesh::vertex), member("axis", &Mesh::axis),
        member("value", &Mesh::value), member("triangle", &Mesh::triangle), member("corner", &Mesh::corner),
        member("index", &Mesh::index), member("vertex_count", &Mesh::vertex_count),
        member("triangle_count", &Mesh::triangle_count), member("number_count", &Mesh::number_count),
        member("stride", &Mesh::stride));
    add<NotSolid>(
        m, "NotSolid",
        "A mesh or points bound no solid, or no convex one. `reason` is a NotSolidReason: open_edge (`triangle`, "
        "`corner`, `vertices`, `points`); self_intersection (`triangles`); dent (`triangle`, `corner`, "
        "`vertices`, and `beyond`, a vertex beyond the triangle's plane by `depth`); no_interior (`point_count`).",
        member("reason", &NotSolid::reason), member("triangle", &NotSolid::triangle),
        member("corner", &NotSolid::corner), member("vertices", &NotSolid::vertices),
        member("points", &NotSolid::points), member("triangles", &NotSolid::triangles),
        member("beyond", &NotSolid::beyond), member("depth", &NotSolid::depth),
        member("point_count", &NotSolid::point_count));
    using Bad = InvalidArgument;
    add<Bad>(m, "InvalidArgument",
             "An argument of a call cannot be used: a number in it is bad, or it is None. `argument` is an Argument; "
             "`part` says which number, as 'R(0, 1)', 't(2)', 'min(1)', 'direction(2)' or 'radius'; `value` is the "
             "number; `body` and `index`, if any, are the body that the argument was for and its place in a list.",
             member("argument", &Bad::argument), member("part", &Bad::part), member("value", &Bad::value),
             member("body", &Bad::body), member("index", &Bad::index), member("kind", &Bad::kind));
    add<SingularPose>(m, "SingularPose", "The matrix of a solid's pose is singular where inner points are needed.",
                      member("argument", &SingularPose::argument), member("body", &SingularPose::body));
}

void add_call_errors(py::module_& m) {
    add<StaleBody>(m, "StaleBody", "An id names no body of this world.", member("body", &StaleBody::body),
                   member("index", &StaleBody::index));
    add<SameBody>(m, "SameBody", "The same body was given twice, where a pair of bodies is needed.",
                  member("body", &SameBody::body));
    add<MovedFromWorld>(m, "MovedFromWorld", "A world was used after it was moved from; this cannot happen in Python.");
    add<NotSupported>(m, "NotSupported",
                      "A shape does not support this question, for example because the mesh is no Solid.",
                      member("question", &NotSupported::question), member("a", &NotSupported::a),
                      member("b", &NotSupported::b), member("body", &NotSupported::body));
    add<NotUpdated>(m, "NotUpdated",
                    "A certificate of a world was requested, but the world has changed since its last update.");
    add<ShapeChanged>(m, "ShapeChanged", "A shape changed after a body got it; this cannot happen in Python.",
                      member("body", &ShapeChanged::body), member("kind", &ShapeChanged::kind));
    add<ExecutorFailed>(m, "ExecutorFailed", "Threads did not run each task once.");
    add<TraceFailed>(m, "TraceFailed", "A trace could not be written in full.");
    add<InvalidTrace>(m, "InvalidTrace", "A text is no trace, or holds a call that a world refuses.",
                      member("line", &InvalidTrace::line));
    add<BrokenInvariant>(m, "BrokenInvariant", "A defect in the library, or memory overwritten.");
}

}  // namespace

void raise_stale(const py::object& number, ListIndex index) {
    const py::object raised = exception_of(StaleBody({}, index), stale_text(py::str(number), index));
    raised.attr("body") = number;
    set(raised);
    throw py::error_already_set();
}

void raise_negative(const InvalidMesh& error) {
    const auto index = static_cast<std::int64_t>(error.index);
    std::string text = error.what();
    const std::string unsigned_index = std::to_string(error.index);
    text.replace(text.find(unsigned_index), unsigned_index.size(), std::to_string(index));
    const py::object raised = exception_of(error, text);
    raised.attr("index") = index;
    set(raised);
    throw py::error_already_set();
}

void bind_errors(py::module_& m) {
    base_type =
        make_type(m, "Error", "The common base of all errors of ECoDS: catch this to catch them all.", PyExc_Exception);
    add_input_errors(m);
    add_call_errors(m);
    py::register_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const Error& error) {
            set(exception_of(error, message_of(error)));
        }
    });
}

}  // namespace ecods::python
