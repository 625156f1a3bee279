// The parts that the command lines of all programs share.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/export.hpp"
#include "environment/instruction_sets.hpp"
#include "scenes/io/named_file.hpp"

namespace ecods::programs {

constexpr int exit_misused = 2;  // the command line makes no sense, or the program cannot go on

// An option whose value is given by name; --help lists the names. CLI11's transformers would list the values, too: for
// an enumeration of one byte these are control bytes.
template <class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Value& value,
                        const std::map<std::string, Value>& choices, const std::string& about) {
    std::vector<std::string> names;
    for (const auto& [name, chosen] : choices) names.push_back(name);
    const auto choose = [&value, choices](const std::string& name) { value = choices.at(name); };
    return app.add_option_function<std::string>(option, choose, about)->check(CLI::IsMember(names))->type_name("NAME");
}

inline CLI::Option* add_broad_phase(CLI::App& app, BroadPhaseKind& kind, const std::string& about) {
    return add_choice<BroadPhaseKind>(app, "--broad-phase", kind,
                                      {{"brute_force", BroadPhaseKind::brute_force},
                                       {"sweep_and_prune", BroadPhaseKind::sweep_and_prune},
                                       {"kept_candidates", BroadPhaseKind::kept_candidates},
                                       {"automatic", BroadPhaseKind::automatic}},
                                      about);
}

// The flag for files from strangers, of all programs that read files which may name others.
inline CLI::Option* add_untrusted(CLI::App& app, scenes::NamedFiles& allowed) {
    return app.add_flag_callback(
        "--untrusted", [&allowed] { allowed = scenes::NamedFiles::in_folder; },
        "Refuse files that name a file outside of their folder. Otherwise assemblies (.gltf) and scenes (.json) may "
        "name "
        "any: by ../, by an absolute path or by a link");
}

// Hands ECODS_INSTRUCTION_SET on to the library, adds --version, and parses. When the program is to end at once, its
// exit status: 0 after --help and --version, which are printed, and exit_misused after an error, which is printed to
// the error stream.
inline std::optional<int> parse(CLI::App& app, int argc, const char* const* argv) {
    const std::string version =
        fmt::format("{} {}.{}.{}", app.get_name(), ECODS_VERSION_MAJOR, ECODS_VERSION_MINOR, ECODS_VERSION_PATCH);
    app.set_version_flag("--version", version, "Print the version, and end");
    try {
        environment::limit_by_variable();
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : exit_misused;
    } catch (const std::invalid_argument& error) {
        fmt::print(stderr, "{}: {}\n", app.get_name(), error.what());
        return exit_misused;
    }
    return std::nullopt;
}

}  // namespace ecods::programs
