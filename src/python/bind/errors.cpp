// Makes Python exceptions for the library's errors, with equal names, text and members.
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

// Returns the known errors. They live as long as the process, since exceptions may come until its end.
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

// Returns the library's text, with an id as Python has it: an integer.
std::string message_of(const Error& error) {
    const auto* const stale = dynamic_cast<const StaleBody*>(&error);
    if (stale == nullptr) return error.what();
    const std::string number = std::to_string(number_of(stale->body));
    if (!stale->body) return stale_text(number, stale->index);
    return std::string(error.what()) + " (id " + number + ")";
}

// Returns the exception, with the members of the error; `text` is its message.
py::object exception_of(const Error& error, const std::string& text) {
    const auto at = known().find(typeid(error));
    py::object raised = py::handle(at == known().end() ? base_type : at->second.type)(text);
    if (at != known().end()) at->second.add_members(error, raised);
    return raised;
}

void set(const py::object& raised) {
    PyErr_SetObject(py::type::handle_of(raised).ptr(), raised.ptr());
}

void add_mesh_errors(py::module_& m) {
    add<InvalidVertex>(m, "InvalidVertex", "A vertex coordinate is NaN or infinite.",
                       member("vertex", &InvalidVertex::vertex), member("axis", &InvalidVertex::axis),
                       member("value", &InvalidVertex::value));
    add<InvalidIndex>(m, "InvalidIndex",
                      "A triangle names a vertex that does not exist: `value`, which may be negative.",
                      member("triangle", &InvalidIndex::triangle), member("corner", &InvalidIndex::corner),
                      member("value", &InvalidIndex::value), member("vertex_count", &InvalidIndex::vertex_count));
    add<EmptyMesh>(m, "EmptyMesh", "A mesh has no triangle.");
    add<InvalidLayout>(m, "InvalidLayout", "Numbers do not make whole vertices or triangles.",
                       member("count", &InvalidLayout::count), member("stride", &InvalidLayout::stride));
    add<MeshTooLarge>(m, "MeshTooLarge", "A mesh has more vertices or triangles than 32-bit indices can name.",
                      member("vertex_count", &MeshTooLarge::vertex_count),
                      member("triangle_count", &MeshTooLarge::triangle_count));
    add<NotClosed>(m, "NotClosed", "The triangles meant to bound a solid are not closed along this edge.",
                   member("triangle", &NotClosed::triangle), member("corner", &NotClosed::corner),
                   member("vertices", &NotClosed::vertices), member("points", &NotClosed::points));
    add<SelfIntersecting>(m, "SelfIntersecting",
                          "Two triangles meant to bound a solid share a segment or more that is not a side of both.",
                          member("triangles", &SelfIntersecting::triangles));
    add<NotConvex>(m, "NotConvex",
                   "A mesh meant as a convex solid has a vertex beyond the plane of one of its triangles.",
                   member("triangle", &NotConvex::triangle), member("corner", &NotConvex::corner),
                   member("vertices", &NotConvex::vertices), member("beyond", &NotConvex::beyond));
    add<NoInterior>(m, "NoInterior", "The points meant for a convex solid lie in one plane, or there are none.",
                    member("point_count", &NoInterior::point_count));
}

void add_body_errors(py::module_& m) {
    add<InvalidPose>(m, "InvalidPose", "An entry of a pose is NaN or infinite, or its last row is not 0 0 0 1.",
                     member("row", &InvalidPose::row), member("column", &InvalidPose::column),
                     member("value", &InvalidPose::value), member("body", &InvalidPose::body),
                     member("index", &InvalidPose::index));
    add<SingularPose>(m, "SingularPose",
                      "The matrix of a solid's pose is singular, and the question needs inner points.",
                      member("argument", &SingularPose::argument), member("body", &SingularPose::body));
    add<SolidsApart>(m, "SolidsApart", "Two solids share no point, so neither is in the other to a depth.",
                     member("a", &SolidsApart::a), member("b", &SolidsApart::b));
    add<LengthMismatch>(m, "LengthMismatch", "Two lists that belong together have different lengths.",
                        member("body_count", &LengthMismatch::body_count),
                        member("pose_count", &LengthMismatch::pose_count));
    add<NullArgument>(m, "NullArgument", "None was given for a mesh.");
    add<StaleBody>(m, "StaleBody", "An id names no body of this world.", member("body", &StaleBody::body),
                   member("index", &StaleBody::index));
    add<MovedFromWorld>(m, "MovedFromWorld", "A world was used after it was moved from; not in Python.");
    add<MeshAndShape>(m, "MeshAndShape", "A body was to be of two shapes at once; not in Python.");
    add<SameBody>(m, "SameBody", "One body was given twice in place of a pair.", member("body", &SameBody::body));
    add<MissingTest>(m, "MissingTest", "No test for two kinds of shapes is registered.", member("a", &MissingTest::a),
                     member("b", &MissingTest::b));
    add<NotSupported>(m, "NotSupported", "A shape cannot be asked this question: a mesh that is no Solid, say.",
                      member("question", &NotSupported::question), member("a", &NotSupported::a),
                      member("b", &NotSupported::b));
}

void add_argument_errors(py::module_& m) {
    add<InvalidBox>(m, "InvalidBox", "A box has a NaN, or a least corner above its greatest.",
                    member("kind", &InvalidBox::kind), member("axis", &InvalidBox::axis),
                    member("min", &InvalidBox::min), member("max", &InvalidBox::max), member("body", &InvalidBox::body),
                    member("index", &InvalidBox::index));
    add<InvalidSegment>(m, "InvalidSegment", "An end of a segment is not finite.", member("end", &InvalidSegment::end),
                        member("axis", &InvalidSegment::axis), member("value", &InvalidSegment::value));
    add<InvalidRay>(m, "InvalidRay",
                    "A ray is not finite, has no direction, or a largest parameter that is negative or NaN.",
                    member("axis", &InvalidRay::axis), member("value", &InvalidRay::value));
    add<InvalidPoint>(m, "InvalidPoint", "A point is not finite.", member("axis", &InvalidPoint::axis),
                      member("value", &InvalidPoint::value));
    add<InvalidMotion>(m, "InvalidMotion", "A motion is not finite.", member("axis", &InvalidMotion::axis),
                       member("value", &InvalidMotion::value));
    add<InvalidBall>(m, "InvalidBall", "A ball's center is not finite, or its radius is negative or NaN (axis 3).",
                     member("axis", &InvalidBall::axis), member("value", &InvalidBall::value));
    add<InvalidDistance>(m, "InvalidDistance", "A distance is negative or NaN, or infinite where it must not be.",
                         member("value", &InvalidDistance::value));
    add<InvalidTime>(m, "InvalidTime", "A limit of time is negative or NaN.", member("value", &InvalidTime::value));
    add<NotUpdated>(m, "NotUpdated", "A certificate was requested of a world that changed since its last update.");
    add<NotCertified>(m, "NotCertified", "A shape has no certificates; not in Python.",
                      member("body", &NotCertified::body), member("kind", &NotCertified::kind));
    add<ShapeChanged>(m, "ShapeChanged", "A shape changed after its body got it; not in Python.",
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

void raise_negative(const InvalidIndex& error) {
    const auto value = static_cast<std::int64_t>(error.value);
    std::string text = error.what();
    const std::string unsigned_value = std::to_string(error.value);
    text.replace(text.find(unsigned_value), unsigned_value.size(), std::to_string(value));
    const py::object raised = exception_of(error, text);
    raised.attr("value") = value;
    set(raised);
    throw py::error_already_set();
}

void bind_errors(py::module_& m) {
    base_type =
        make_type(m, "Error", "The common base of all errors of ECoDS: catch this to catch them all.", PyExc_Exception);
    add_mesh_errors(m);
    add_body_errors(m);
    add_argument_errors(m);
    py::register_exception_translator([](std::exception_ptr pointer) {
        try {
            if (pointer) std::rethrow_exception(pointer);
        } catch (const Error& error) {
            set(exception_of(error, message_of(error)));
        }
    });
}

}  // namespace ecods::python
