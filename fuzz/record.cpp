#include "fuzz/record.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "fuzz/base/recipe.hpp"
#include "fuzz/motion/generate.hpp"
#include "fuzz/script/trace.hpp"
#include "fuzz/shrink/shrink.hpp"
#include "process/contained.hpp"

namespace ecods::fuzz {
namespace {

// Plays in a process of its own.
std::optional<Failure> failure_of(const Script& script, const RecordOptions& options) {
    const auto work = [&]() -> std::string {
        Counters counters;
        try {
            play(script, options.play, counters);
        } catch (const Failure& failure) {
            return nlohmann::json{failure.update, failure.check, failure.expected, failure.got}.dump();
        }
        return "";
    };
    const process::Outcome outcome = contained(work, options.run_seconds).run();
    if (!outcome.is_right()) return Failure{0, check_of(outcome), "an end", outcome.failure};
    if (outcome.text.empty()) return std::nullopt;
    const auto json = nlohmann::json::parse(outcome.text);
    return Failure{json[0], json[1], json[2], json[3]};
}

// What comes after the update that failed has no part in it.
Script until_update(const Script& script, std::size_t update) {
    Script result;
    std::size_t updates = 0;
    for (const Call& call : script) {
        result.push_back(call);
        if (std::holds_alternative<Update>(call) && updates++ == update) break;
    }
    return result;
}

std::size_t count_bodies(const Script& script) {
    std::size_t count = 0;
    for (const Call& call : script) count += created_body(call) ? 1 : 0;
    return count;
}

std::ofstream open(const std::filesystem::path& file, std::ios::openmode mode) {
    std::ofstream out(file, mode);
    if (!out) throw std::runtime_error(file.string() + " cannot be written");
    return out;
}

Script script_of(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    if (!in) throw std::runtime_error(file.string() + " cannot be opened");
    return read_trace(in);
}

// The last lines of a trace, if they are notes; those that read_trace() understands are written with the calls.
std::string notes_for_people(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    std::string notes;
    for (std::string line; std::getline(in, line);) {
        const bool is_call = !line.starts_with("note ") || line.starts_with("note bad ") ||
                             line.starts_with("note reserve ") || line == "note tests";
        notes = is_call ? "" : notes + line + "\n";
    }
    return notes;
}

}  // namespace

void record(RunFailure& failure, RecordOptions options) {
    const Profile* profile = find_profile(failure.profile);
    if (profile == nullptr || failure.check == recipe_check) return;  // a script that cannot be made is not shrunk
    options.play = options_of_run(options.play, failure.profile, failure.seed);
    Counters counters;
    Script script = generate(*profile, failure.seed, counters);
    std::optional<Failure> found = failure_of(script, options);
    if (!found || found->check != failure.check) {
        failure.text += "It did not happen again: no trace.\n";
        return;
    }
    if (found->check != "crash" && found->check != "hang") script = until_update(script, found->update);
    const auto fails = [&](const Script& shorter) {
        const auto other = failure_of(shorter, options);
        return other && other->check == failure.check;
    };
    const std::size_t calls = script.size();
    if (options.shrink_seconds > 0) script = shrink(repaired(script), {fails, options.shrink_seconds});
    found = failure_of(script, options).value_or(*found);

    std::filesystem::create_directories(options.folder);
    const auto stem = options.folder / fmt::format("{}-{}", failure.profile, failure.seed);
    failure.trace = stem.string() + ".trace";
    failure.picture = stem.string() + ".obj";
    // The world may crash while it is traced: the file is then complete up to there.
    contained(
        [&] {
            auto out = open(failure.trace, std::ios::binary);
            write_trace(script, out);
            return std::string();
        },
        options.run_seconds)
        .run();
    {
        auto out = open(failure.trace, std::ios::binary | std::ios::app);
        write_failure(*found, out);
    }
    auto picture = open(failure.picture, std::ios::binary);
    write_picture(script, picture);
    failure.expected = found->expected;
    failure.got = found->got;
    failure.text += fmt::format("{} calls shrunk to {}, of {} bodies: {}\n", calls, script.size(), count_bodies(script),
                                failure.trace);
}

std::optional<Failure> replay_trace(const std::filesystem::path& file, const ReplayOptions& options,
                                    Counters& counters) {
    Script script = script_of(file);
    for (Call& call : script) {
        if (auto* update = std::get_if<Update>(&call); update != nullptr && !options.compares_digests)
            update->digest = {};
    }
    try {
        play(script, options.play, counters);
    } catch (const Failure& failure) {
        return failure;
    }
    return std::nullopt;
}

void renew_trace(const std::filesystem::path& file) {
    const Script script = script_of(file);
    const std::string notes = notes_for_people(file);
    auto out = open(file, std::ios::binary);
    write_trace(script, out);
    out << notes;
}

}  // namespace ecods::fuzz
