#include "programs/clash/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <regex>
#include <thread>

#include "programs/clash/write.hpp"
#include "programs/command_line.hpp"

namespace ecods::clash {
namespace {

constexpr const char* about =
    "Says which parts of some files clash, how, and where: exactly.\n\n"
    "Files are meshes (.off, .ply: a part each; .obj, .stl: a part for each object, group or solid), assemblies\n"
    "(.gltf, .glb: a part for each node with a mesh) and scenes (.json); of folders the meshes and assemblies in them\n"
    "are read. Kinds of clashes, of which a pair has the first that holds: equal, inside, overlapping, crossing (of\n"
    "surfaces that bound no solid), touching, clearance.\n\n"
    "Exit status: 0; 1 if there are clashes of a kind of --fail-on; 2 if something cannot be read or written, also "
    "with\n"
    "--keep-going.";

constexpr const char* pattern_help = "'*' is any text, '?' any byte; a name or a whole path";

void add_kinds(CLI::App& app, Command& command) {
    const auto take = [&command](const std::vector<std::string>& names) {
        for (const std::string& name : names) {
            for (const Kind kind : all_kinds) {
                if (name == "any" || name == name_of(kind)) command.failing_kinds.insert(kind);
            }
        }
    };
    std::vector<std::string> words{"any"};
    for (const Kind kind : all_kinds) words.emplace_back(name_of(kind));
    app.add_option_function<std::vector<std::string>>("--fail-on", take,
                                                      "Exit with status 1 if there is a clash of this kind (any: of "
                                                      "those that are reported). May be given more than once")
        ->allow_extra_args(false)
        ->check(CLI::IsMember(words))
        ->type_name("KIND");
}

void add_groups(CLI::App& app, Rules& rules) {
    const std::string group_help = fmt::format(" ({}). May be given more than once", pattern_help);
    app.add_option("--a", rules.a,
                   "Group A are the parts of this pattern: judge only pairs with one of them" + group_help)
        ->allow_extra_args(false)
        ->type_name("PATTERN");
    app.add_option("--b", rules.b, "Group B, likewise; with both, judge the parts of A against those of B")
        ->allow_extra_args(false)
        ->type_name("PATTERN");
    app.add_option("--ignore", rules.ignored,
                   "Do not judge pairs of a part of the first pattern and one of the second. May be given more than "
                   "once")
        ->allow_extra_args(false)
        ->type_name("PATTERN PATTERN");
}

void add_pages(CLI::App& app, Command& command) {
    app.add_option("--html", command.html, "The same as a page that opens from disk")->type_name("FILE");
    app.add_option("--bcf", command.bcf, "The same as BCF 2.1, a topic for each clash")->type_name("FILE");
    app.add_option("--pictures", command.picture_count, "Put pictures of the first N clashes into the page and the BCF")
        ->type_name("N");
    app.add_option("--date", command.date,
                   "The date that BCF demands of its topics; the default is the same always: 1970-01-01T00:00:00Z")
        ->type_name("DATE");
}

// xs:dateTime with a time zone or Z, as far as its form goes.
bool is_date(const std::string& text) {
    static const std::regex form(
        "[0-9]{4}-(0[1-9]|1[0-2])-(0[1-9]|[12][0-9]|3[01])T([01][0-9]|2[0-3])(:[0-5][0-9]){2}(\\.[0-9]+)?"
        "(Z|[+-](0[0-9]|1[0-3]):[0-5][0-9])");
    return std::regex_match(text, form);
}

void check_pages(const Command& command) {
    if (!command.bcf.empty() && !can_write_bcf())
        throw CLI::ValidationError("--bcf", "this program was built without libzip or pugixml, which BCF needs");
    if (command.picture_count > 0 && !can_make_pictures())
        throw CLI::ValidationError("--pictures", "this program was built without libpng, which pictures need");
    if (command.picture_count > 0 && command.html.empty() && command.bcf.empty())
        throw CLI::ValidationError("--pictures", "needs --html or --bcf");
    if (!is_date(command.date)) throw CLI::ValidationError("--date", "must be like 2026-01-31T12:00:00Z");
}

void check(const Command& command, bool has_any) {
    const auto& clearance = command.judging.clearance;
    if (clearance && !(*clearance >= 0 && std::isfinite(*clearance)))
        throw CLI::ValidationError("--clearance", "must be finite, and not negative");
    if (!has_any && command.failing_kinds.contains(Kind::clearance) && !clearance)
        throw CLI::ValidationError("--fail-on", "clearance needs --clearance");
    check_pages(command);
    int on_standard_output = 0;
    for (const std::string* file : {&command.json, &command.csv, &command.html, &command.bcf})
        on_standard_output += int{*file == "-"};
    if (on_standard_output > 1) throw CLI::ValidationError("-", "only one format can be on standard output");
}

}  // namespace

std::optional<int> parse(int argc, const char* const* argv, Command& command) {
    JudgeOptions& judging = command.judging;
    judging.jobs = std::max(1U, std::thread::hardware_concurrency());
    CLI::App app(about, "ecods_clash");
    app.add_option("PATH", command.paths, "Files and folders; of a scene with motion, frame 0 is judged")->required();
    programs::add_untrusted(app, command.named_files);
    add_groups(app, judging.rules);
    app.add_option("--clearance", judging.clearance, "Also report parts at a distance of at most this")->type_name("D");
    app.add_flag("--touching", judging.has_touching, "Also report parts that only touch");
    add_kinds(app, command);
    app.add_flag("--narrow-depths", judging.has_narrow_depths,
                 "Find narrow bounds of how deep solids with dents are in each other, for some milliseconds a clash, "
                 "also where there are more than 256 of them");
    app.add_option(
           "--lines", judging.line_limit,
           "Also find in which points and lines the surfaces meet, and write at most so many lines of each clash")
        ->type_name("N");
    app.add_option("--json", command.json, "Write the report as JSON to this file; - is standard output")
        ->type_name("FILE");
    app.add_option("--csv", command.csv,
                   "The same as CSV; a name that a spreadsheet would take for a formula has an apostrophe before it")
        ->type_name("FILE");
    add_pages(app, command);
    app.add_flag("--quiet", command.is_quiet, "Print no table");
    app.add_flag("--times", command.has_times, "Say on the error stream what the parts of the work took");
    app.add_flag("--keep-going", command.keeps_going, "Name the files that cannot be read, and judge the others");
    app.add_option("--jobs", judging.jobs,
                   "How many threads; the default is that of the processors. Reports are the same")
        ->check(CLI::Range(1, 1024))
        ->type_name("N");
    app.callback([&] {
        const bool has_any = command.failing_kinds.size() == kind_count;
        check(command, has_any);
        if (!has_any && command.failing_kinds.contains(Kind::touching)) judging.has_touching = true;
    });
    return programs::parse(app, argc, argv);
}

std::vector<std::pair<std::string, std::string>> list_options(const Command& command) {
    std::vector<std::pair<std::string, std::string>> options;
    const JudgeOptions& judging = command.judging;
    for (const std::string& pattern : judging.rules.a) options.emplace_back("a", pattern);
    for (const std::string& pattern : judging.rules.b) options.emplace_back("b", pattern);
    for (const auto& [one, other] : judging.rules.ignored) options.emplace_back("ignore", one + " " + other);
    if (judging.clearance) options.emplace_back("clearance", fmt::format("{}", *judging.clearance));
    if (judging.has_touching) options.emplace_back("touching", "");
    if (judging.has_narrow_depths) options.emplace_back("narrow-depths", "");
    if (judging.line_limit > 0) options.emplace_back("lines", fmt::format("{}", judging.line_limit));
    return options;
}

}  // namespace ecods::clash
