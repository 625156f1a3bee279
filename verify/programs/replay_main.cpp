// ecods_replay: runs the trace of a world again. `ecods_replay --help` lists the options.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fstream>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "certificates/folder/certificate_folder.hpp"
#include "command_line.hpp"
#include "ecods/error.hpp"
#include "ecods/trace.hpp"
#include "run_main.hpp"

namespace ecods {
namespace {

constexpr int exit_same = 0;
constexpr int exit_differs = 1;
constexpr int exit_unreadable = 2;

struct Options {
    std::string file;
    ReplayOptions replay;
    std::optional<std::filesystem::path> certificates;  // the file for them, or its folder
    bool json = false;
};

void print_text(const Options& options, const ReplayReport& report) {
    fmt::print("{}: {} calls, {} updates, {} bodies, {} colliding pairs: {}\n", options.file, report.call_count,
               report.update_count, report.body_count, report.colliding_count,
               report.difference ? "DIFFERS" : "as traced");
    if (!report.difference) return;
    const auto& [update, call, line, what] = *report.difference;
    fmt::print("DIFFERS  update {}, call {}, line {}: {}\n", update, call, line, what);
}

void print_json(const Options& options, const ReplayReport& report) {
    nlohmann::ordered_json json = {
        {"file", options.file},        {"calls", report.call_count},          {"updates", report.update_count},
        {"bodies", report.body_count}, {"colliding", report.colliding_count}, {"difference", nullptr}};
    if (report.difference) {
        const auto& [update, call, line, what] = *report.difference;
        json["difference"] = {{"update", update}, {"call", call}, {"line", line}, {"what", what}};
    }
    fmt::print("{}\n", json.dump(2));
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Runs the trace of a world again (World::trace_to), and compares what every update gives with what it gave.\n"
        "Exit status: 0 if all is as traced; 1 if not: the first update that differs is named, with its call and\n"
        "line; 2 if the file cannot be read, or memory runs out.",
        "ecods_replay");
    app.add_option("TRACE", options.file, "The file to run")->required();
    BroadPhaseKind broad_phase{};
    const CLI::Option* has_broad_phase =
        programs::add_broad_phase(app, broad_phase, "In place of the one in the trace");
    app.add_flag("--validate", options.replay.checks_invariants, "Check every invariant after each update (slow)");
    app.add_option(
           "--certify", options.certificates,
           "Also write the lists after each update with a proof to this file, and meshes to files DIGEST.mesh "
           "beside it, for ecods_check_certificate; to certificates.txt in it if it is a folder, or ends with /")
        ->type_name("FILE");
    app.add_flag("--json", options.json, "Write JSON");
    if (const auto status = programs::parse(app, argc, argv)) return *status;
    if (*has_broad_phase) options.replay.broad_phase = broad_phase;
    std::ifstream in(options.file, std::ios::binary);
    if (!in) {
        fmt::print(stderr, "ecods_replay: {}: cannot be opened\n", options.file);
        return exit_unreadable;
    }
    try {
        std::optional<certificates::CertificateFolder> folder;
        QueryMemory memory;
        if (options.certificates) {
            folder.emplace(*options.certificates);
            options.replay.updated = [&](const World& world) { folder->add(world.certify(memory)); };
        }
        const ReplayReport report = replay(in, options.replay);
        (options.json ? print_json : print_text)(options, report);
        return report.difference ? exit_differs : exit_same;
    } catch (const Error& error) {
        fmt::print(stderr, "ecods_replay: {}: {}\n", options.file, error.what());
        return exit_unreadable;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "ecods_replay: {}: out of memory\n", options.file);
        return exit_unreadable;
    }
}

}  // namespace
}  // namespace ecods

int main(int argc, char** argv) {
    return ecods::programs::run_main("ecods_replay", argc, argv, &ecods::run);
}
