// ecods_check: which bodies of some files touch, which cross, how far they are from each other, when they meet, and
// what rays hit of them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <vector>

#include "check_cases.hpp"
#include "check_certificates.hpp"
#include "check_oracle.hpp"
#include "check_print.hpp"
#include "check_scene.hpp"
#include "command_line.hpp"
#include "ecods/error.hpp"
#include "ecods/export.hpp"
#include "environment/instruction_sets.hpp"
#include "process/progress.hpp"
#include "run_main.hpp"
#include "scenes/io/scene_file.hpp"

namespace ecods::check {
namespace {

constexpr int exit_ok = 0;
constexpr int exit_differs = 1;

struct Options {
    std::vector<std::filesystem::path> files;
    scenes::NamedFiles named_files = scenes::NamedFiles::anywhere;
    std::filesystem::path cases;
    std::optional<std::filesystem::path> certificates;  // the file for them, or its folder
    bool json = false;
    bool oracle = false;
    SceneQuestions questions;
    BroadPhaseKind broad_phase = BroadPhaseKind::sweep_and_prune;
    InstructionSet instruction_set = environment::widest_instruction_set();
};

std::optional<certificates::CertificateFolder> open_folder(const Options& options) {
    if (!options.certificates) return std::nullopt;
    return std::make_optional<certificates::CertificateFolder>(*options.certificates);
}

int check_files(const Options& options) {
    const scenes::Scene scene = scenes::read_files(options.files, options.named_files);
    for (const std::string& note : scene.notes) fmt::print(stderr, "ecods_check: {}\n", note);
    SceneWorld world(scene, options.broad_phase, options.questions);
    OracleJudge judge(scene);
    auto folder = open_folder(options);
    nlohmann::ordered_json json = to_json(scene);
    if (options.questions.has_solids) {
        if (options.json) {
            json["solids"] = solids_to_json(scene, world);
        } else {
            print_solids(stdout, scene, world);
        }
    }
    process::Progress progress;
    for (std::size_t frame = 0; world.next_frame(); ++frame) {
        if (!scene.frames.empty()) progress.show(fmt::format("frame {} of {}", frame, scene.frames.size()));
        const FrameAnswer answer = world.answer();
        if (options.oracle) judge.check_frame(world, answer);
        if (folder) certify_frame(world, scene.bodies.size(), *folder);
        if (options.json) {
            json["frames"].push_back(to_json(scene, answer));
        } else {
            progress.wipe();
            print_frame(stdout, scene, answer);
        }
    }
    progress.wipe();
    if (options.oracle && options.json) json["oracle"] = to_json(judge.report());
    if (options.oracle && !options.json) print_report(stdout, judge.report());
    if (options.json) fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    return judge.report().differences.empty() ? exit_ok : exit_differs;
}

int check_cases(const Options& options) {
    auto folder = open_folder(options);
    const CasesReport report = run_cases(options.cases, options.oracle, folder ? &*folder : nullptr);
    std::size_t mismatches = 0;
    nlohmann::ordered_json cases = nlohmann::ordered_json::array();
    for (const CaseAnswer& answer : report.cases) {
        if (!answer.is_ok) ++mismatches;
        if (options.json) {
            cases.push_back({{"id", answer.id},
                             {"intersects", answer.intersects},
                             {"triangle_pairs", answer.triangle_pair_count},
                             {"ok", answer.is_ok}});
        } else {
            fmt::print("{}  {}  {}  {}\n", answer.id, answer.intersects ? "intersects" : "apart",
                       counted(answer.triangle_pair_count, "triangle pair"), answer.is_ok ? "ok" : "MISMATCH");
        }
    }
    if (options.json) {
        const nlohmann::ordered_json json{{"cases", cases}, {"mismatches", mismatches}, {"skipped", report.skipped}};
        fmt::print("{}\n", json.dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
    } else {
        fmt::print("{}, {}, {} skipped (not two meshes)\n", counted(report.cases.size(), "case"),
                   counted(mismatches, "mismatch", "mismatches"), report.skipped);
    }
    return mismatches == 0 ? exit_ok : exit_differs;
}

void add_files(CLI::App& app, Options& options) {
    app.add_option("FILE", options.files, "Files to read");
    app.add_option("--cases", options.cases, "Check the known answers in this file (.json) instead");
    programs::add_untrusted(app, options.named_files);
}

void add_rays(CLI::App& app, std::vector<Ray>& rays) {
    const auto take = [&rays](const std::vector<std::array<double, 6>>& given) {
        for (const auto& [x, y, z, dx, dy, dz] : given) {
            rays.push_back({Vec3(x, y, z), Vec3(dx, dy, dz)});
            try {
                validate(rays.back());
            } catch (const InvalidArgument& error) {
                throw CLI::ValidationError("--ray", error.what());
            }
        }
    };
    app.add_option_function<std::vector<std::array<double, 6>>>(
           "--ray", take,
           "Also list everything that this ray hits, in the exact order: six numbers, the origin and the direction. "
           "Parameters are multiples of the direction. May be given more than once")
        ->allow_extra_args(false)
        ->type_name("X Y Z DX DY DZ");
}

void add_certify(CLI::App& app, std::optional<std::filesystem::path>& folder) {
    app.add_option(
           "--certify", folder,
           "Also write the lists of each frame (with --distance also distances; with --cases, each case) with a "
           "proof to this file, and meshes to files DIGEST.mesh beside it, for ecods_check_certificate; to "
           "certificates.txt in it if it is a folder, or ends with /")
        ->type_name("FILE");
}

// Throws CLI::ValidationError for options that go not together.
void require_sense(const Options& options) {
    if (options.files.empty() == options.cases.empty()) {
        throw CLI::ValidationError("ecods_check", "files to read, or --cases with one file, are expected");
    }
    const SceneQuestions& asked = options.questions;
    const bool has_questions = asked.has_distances || asked.clearance || asked.has_moves || asked.has_casts ||
                               asked.has_solids || asked.has_depths || !asked.rays.empty();
    if (has_questions && !options.cases.empty()) {
        throw CLI::ValidationError("ecods_check",
                                   "--distance, --clearance, --moves, --casts, --solids, --depth and --ray are "
                                   "for files, not for --cases");
    }
    if (!asked.may_have_solids()) return;
    if (options.certificates) {
        throw CLI::ValidationError("ecods_check", "--certify is about surfaces, not for --solids and --depth");
    }
    const bool is_more_asked = asked.has_distances || asked.clearance || asked.has_moves || asked.has_casts;
    if (options.oracle && (is_more_asked || !asked.rays.empty())) {
        throw CLI::ValidationError("ecods_check",
                                   "--oracle checks distances, clearances, moves, casts and rays of surfaces, not "
                                   "with --solids or --depth");
    }
}

int run(int argc, char** argv) {
    Options options;
    CLI::App app(
        "Says which bodies of some files touch, which cross, how far they are from each other, when they meet on "
        "their\n"
        "way, and what rays hit of them: exactly.\n\n"
        "Files are meshes (.off, .ply: a body each; .obj, .stl: a body for each object, group or solid), assemblies\n"
        "(.gltf, .glb: a body for each node with a mesh) and scenes (.json); all of them together are one scene.\n\n"
        "Exit status: 0, or 1 if an answer is not the expected one, or 2 if the input cannot be read.",
        "ecods_check");
    add_files(app, options);
    app.add_flag("--json", options.json, "Write JSON");
    app.add_flag("--distance", options.questions.has_distances,
                 "Also say of each pair of bodies how far they are from each other, and where they are nearest");
    app.add_option("--clearance", options.questions.clearance,
                   "Also list the pairs of bodies at a distance of at most this, and where they are nearest")
        ->type_name("D");
    app.add_flag(
        "--moves", options.questions.has_moves,
        "Also list, at each frame of a scene, the pairs of bodies that meet on the way from the frame before, and at "
        "which time from 0 to 1. The way is straight, or a \"turn\", of which the angle is listed, too, in degrees (as "
        "JSON also in radians). A body that turns is listed first. Beside it, others rest or make the same turn");
    app.add_flag(
        "--casts", options.questions.has_casts,
        "Also say of each body with a \"motion\" or a \"turn\" (in a scene file, or in the extras of a glTF node) "
        "which "
        "body it meets first when it is translated by that, or makes that turn, and at which time from 0 to 1");
    add_rays(app, options.questions.rays);
    app.add_flag("--solids", options.questions.has_solids,
                 "Take bodies of which the mesh bounds a solid for solids, what is inside included, in every answer: "
                 "pairs are also overlapping, inside, contains or equal. Also say of each body whether it is one, or "
                 "why not. --oracle then checks who collides, and how");
    app.add_flag(
        "--depth", options.questions.has_depths,
        "Take bodies of which the mesh bounds a convex solid for solids, as --solids, and also say of each pair of "
        "these how deep they are in each other, the direction in which the second gets out, and on which features "
        "(triangle:corner); or their gap. --oracle does not check these");
    add_certify(app, options.certificates);
    app.add_flag("--oracle", options.oracle, "Check every answer, of all pairs of bodies, with CGAL's exact numbers");
    programs::add_broad_phase(app, options.broad_phase, "Which broad phase; sweep_and_prune is the default");
    std::map<std::string, InstructionSet> sets;
    for (const InstructionSet set : environment::supported_instruction_sets()) sets[environment::name(set)] = set;
    programs::add_choice(app, "--instruction-set", options.instruction_set, sets,
                         "Use no wider instructions than these, of those that the processor has (the default is the "
                         "widest). Answers are the same");
    app.callback([&] { require_sense(options); });
    if (const auto status = programs::parse(app, argc, argv)) return *status;
    limit_instruction_set(options.instruction_set);
    return options.cases.empty() ? check_files(options) : check_cases(options);
}

}  // namespace
}  // namespace ecods::check

int main(int argc, char** argv) {
    return ecods::programs::run_main("ecods_check", argc, argv, &ecods::check::run);
}
