#include <fmt/ostream.h>

#include <algorithm>
#include <exception>
#include <string>

#include "fuzz/checks/text.hpp"
#include "fuzz/script/scene.hpp"
#include "fuzz/script/trace.hpp"

namespace ecods::fuzz {
namespace {

// Writes the notes that go before a call, or hold it.
class NoteWriter : public NoField {
  public:
    NoteWriter(const ScriptedWorld& scripted, std::ostream& out) : scripted_(scripted), out_(out) {}

    void write(const Call& call) {
        std::visit(Overloaded{[&](const Update& update) {
                                  if (update.is_quiet) out_ << "note quiet\n";
                                  if (update.fails) out_ << "note failing\n";
                              },
                              [&](const auto& row) {
                                  row.fields(*this, row);
                                  if (is_in<NoteCall>(row)) fmt::print(out_, "note {}{}\n", row.name, text_);
                              }},
                   call);
    }

    void shape(const Part& part) const {
        if (part.refits) out_ << "note refit\n";
    }
    void body(const Label& label) { text_ += fmt::format(" {}", fuzz::text(scripted_.id(label))); }
    void number(const std::uint32_t& number) { text_ += fmt::format(" {}", number); }
    void text(const std::string& text) { text_ += fmt::format(" {}", text); }

  private:
    template <class... Rows, class Row>
    static constexpr bool is_one_of(const std::variant<Rows...>*, const Row*) {
        return (std::is_same_v<Rows, Row> || ...);
    }
    template <class AnyCall, class Row>
    static constexpr bool is_in(const Row& row) {
        return is_one_of(static_cast<const AnyCall*>(nullptr), &row);
    }

    const ScriptedWorld& scripted_;
    std::ostream& out_;
    std::string text_;
};

void apply(ScriptedWorld& scripted, const Call& call, std::ostream& out) {
    NoteWriter(scripted, out).write(call);
    if (std::holds_alternative<MakeAgain>(call)) return;  // the trace goes on, and has the same ids
    const auto* update = std::get_if<Update>(&call);
    if (update != nullptr && update->fails) {
        scripted.tests().fail(true);
        try {
            scripted.world().update();
            scripted.tests().fail(false);
            return;
        } catch (const TestFailed&) {
            scripted.tests().fail(false);
        }
    }
    scripted.apply(call);
}

// A note is one line.
std::string one_line(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}  // namespace

void write_trace(const Script& script, std::ostream& out) {
    ScriptedWorld scripted({.broad_phase = BroadPhaseKind::brute_force});
    scripted.world().trace_to(out, {.write_shape = write_user_shape});
    try {
        for (const Call& call : script) apply(scripted, call, out);
        scripted.world().end_trace();
    } catch (const std::exception& error) {
        fmt::print(out, "note here the world threw: {}\n", one_line(error.what()));
    }
}

void write_failure(const Failure& failure, std::ostream& out) {
    fmt::print(out, "note check: {}\nnote expected: {}\nnote got: {}\n", failure.check, one_line(failure.expected),
               one_line(failure.got));
}

void write_picture(const Script& script, std::ostream& out) {
    Model model;
    for (const Call& call : script) model.apply(call);
    out << "# Points are rounded.\n";
    std::size_t vertex_count = 1;
    for (const auto& [label, body] : model.bodies) {
        fmt::print(out, "o body_{}\n", label);
        const Mesh& mesh = *body.part.mesh;
        for (const Vec3& v : mesh.vertices()) {
            const Vec3 p = body.pose.R * v + body.pose.t;
            fmt::print(out, "v {} {} {}\n", p[0], p[1], p[2]);
        }
        for (const Triangle& t : mesh.triangles()) {
            fmt::print(out, "f {} {} {}\n", vertex_count + t[0], vertex_count + t[1], vertex_count + t[2]);
        }
        vertex_count += mesh.vertices().size();
    }
}

}  // namespace ecods::fuzz
