// Binds trace.hpp: traces of a world's calls, and their replay.
#include <algorithm>
#include <cerrno>
#include <fstream>
#include <sstream>

#include "ecods/trace.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/world.hpp"

namespace ecods::python {
namespace {

// Holds a trace as text.
struct Trace {
    std::string text;
};

std::unique_ptr<std::ostream> open(const std::optional<std::string>& path) {
    if (!path) return std::make_unique<std::ostringstream>();
    auto file = std::make_unique<std::ofstream>(*path, std::ios::binary);
    if (!*file) {
        PyErr_SetFromErrnoWithFilename(PyExc_OSError, path->c_str());
        throw py::error_already_set();
    }
    return file;
}

ReplayReport run(const Trace& trace, std::optional<BroadPhaseKind> broad_phase, std::size_t threads,
                 bool checks_invariants) {
    const ReplayOptions options{
        .broad_phase = broad_phase, .executor = make_threads(threads), .checks_invariants = checks_invariants};
    const py::gil_scoped_release release;
    std::istringstream in(trace.text);
    return replay(in, options);
}

}  // namespace

void SharedWorld::begin_trace(std::unique_ptr<std::ostream> out, bool questions) {
    change([&](World& world) {
        world.trace_to(*out, {.questions = questions});
        trace_ = std::move(out);
    });
}

std::unique_ptr<std::ostream> SharedWorld::end_trace() {
    return change([&](World& world) {
        auto ended = std::exchange(trace_, nullptr);
        world.end_trace();
        return ended;
    });
}

void add_trace_calls(WorldClass& type) {
    type.def(
        "start_trace",
        [](SharedWorld& self, const std::optional<std::string>& path, bool questions) {
            self.begin_trace(open(path), questions);
        },
        py::arg("path") = py::none(), py::arg("questions") = false,
        "Records every call that changes the world from now on, in memory or in a file; with `questions`, also "
        "questions about more than two bodies. Raises OSError.");
    type.def(
        "end_trace",
        [](SharedWorld& self) -> std::optional<Trace> {
            const auto stream = self.end_trace();
            const auto* text = dynamic_cast<const std::ostringstream*>(stream.get());
            return text == nullptr ? std::nullopt : std::optional(Trace{text->str()});
        },
        "Ends the trace: a Trace, or None if it went to a file or there is none. Raises TraceFailed.");
}

void bind_trace(py::module_& m) {
    add_record(m, "ReplayDifference", "The first difference between a replay and its trace.",
               Field{"update", &ReplayReport::Difference::update, "Number of the update, from 0."},
               Field{"call", &ReplayReport::Difference::call, "Number of the call, from 0."},
               Field{"line", &ReplayReport::Difference::line, "Line of the trace, from 1."},
               Field{"what", &ReplayReport::Difference::what, "The difference in words."});
    add_record(m, "ReplayReport", "The result of a replay, up to its end or to the first difference.",
               Field{"call_count", &ReplayReport::call_count, "Number of calls that were made."},
               Field{"update_count", &ReplayReport::update_count, "Number of updates among them."},
               Field{"question_count", &ReplayReport::question_count, "Number of questions among them."},
               Field{"body_count", &ReplayReport::body_count, "Number of bodies at the end."},
               Field{"colliding_count", &ReplayReport::colliding_count, "Number of pairs that collide at the end."},
               Field{"difference", &ReplayReport::difference, "ReplayDifference, or None if there is none."});
    py::class_<Trace>(m, "Trace", "The calls that changed a world, as text.")
        .def(py::init<std::string>(), py::arg("text"))
        .def_readonly("text", &Trace::text)
        .def("__repr__",
             [](const Trace& self) {
                 const auto lines = std::count(self.text.begin(), self.text.end(), '\n');
                 return "<ecods.Trace of " + std::to_string(lines) + " lines>";
             })
        .def("replay", &run, py::arg("broad_phase") = py::none(), py::arg("threads") = 1,
             py::arg("checks_invariants") = false,
             "Makes the calls again, up to the end or the first difference: a ReplayReport. With `checks_invariants`, "
             "checks every invariant after each update, which is slow. Raises InvalidTrace.")
        .def(
            "__eq__", [](const Trace& self, const Trace& other) { return self.text == other.text; }, py::is_operator())
        .def(py::pickle([](const Trace& self) { return py::make_tuple(self.text); },
                        [](const py::tuple& state) { return Trace{state[0].cast<std::string>()}; }));
}

}  // namespace ecods::python
