#include <fmt/ostream.h>

#include <algorithm>
#include <exception>
#include <string>

#include "fuzz/checks/text.hpp"
#include "fuzz/script/scene.hpp"
#include "fuzz/script/trace.hpp"

namespace ecods::fuzz {
namespace {

void apply(ScriptedWorld& scripted, const Call& call, std::ostream& out) {
    if (const auto* bad = std::get_if<BadCall>(&call)) {
        fmt::print(out, "note bad {} {} {}\n", text(scripted.id(bad->body)), bad->choice, bad->name);
        return;
    }
    if (const auto* shape = std::get_if<SetShape>(&call); shape != nullptr && shape->refits) out << "note refit\n";
    if (const auto* reserve = std::get_if<Reserve>(&call)) fmt::print(out, "note reserve {}\n", reserve->count);
    if (std::holds_alternative<SetTests>(call)) out << "note tests\n";
    const auto* update = std::get_if<Update>(&call);
    if (update != nullptr && update->is_quiet) out << "note quiet\n";
    if (update != nullptr && update->fails) {
        out << "note failing\n";
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
