// ecods_clash: which parts of some files clash, how, and where.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <system_error>

#include "process/progress.hpp"
#include "programs/clash/command.hpp"
#include "programs/clash/inputs.hpp"
#include "programs/clash/judge.hpp"
#include "programs/clash/write.hpp"
#include "programs/run_main.hpp"

namespace ecods::clash {
namespace {

// What is left of a file that could not be written to its end, so that nobody takes it for a report.
void remove_half(const std::string& file) {
    std::error_code error;
    if (std::filesystem::is_regular_file(file, error)) std::filesystem::remove(file, error);
}

void write(const std::string& file, const ClashReport& report,
           const std::function<void(std::ostream&, const ClashReport&)>& write_format) {
    if (file.empty()) return;
    if (file == "-") return write_format(std::cout, report);  // process/standard_output.cpp sees whether it can
    std::ofstream out(file, std::ios::binary);
    try {
        if (out) write_format(out, report);
        if (!out.flush()) throw std::runtime_error(file + ": cannot be written");
    } catch (...) {
        out.close();
        remove_half(file);
        throw;
    }
}

// What has pictures, which are made once.
void write_pages(const Command& command, const ClashReport& report) {
    const std::size_t count = std::min(command.picture_count, report.clashes.size());
    process::Progress progress("pictures", count);
    const std::vector<Picture> pictures =
        make_pictures(report, count, command.judging.jobs, [&progress] { progress.step(); });
    progress.wipe();
    write(command.html, report, [&](std::ostream& out, const ClashReport& all) { write_html(out, all, pictures); });
    write(command.bcf, report,
          [&](std::ostream& out, const ClashReport& all) { write_bcf(out, all, pictures, command.date); });
}

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

// The parts of the work that come one after the other.
struct Times {
    double reading = 0;   // files to meshes
    double judging = 0;   // finding solids, clashes and places
    double writing = 0;   // JSON, CSV and the table
    double pictures = 0;  // with the page and the BCF

    void print() const {
        fmt::print(stderr, "read {:.3f} s, judged {:.3f} s, written {:.3f} s, pages {:.3f} s: {:.2f} times reading\n",
                   reading, judging, writing, pictures, (reading + judging + writing) / reading);
    }
};

int run(int argc, char** argv) {
    Command command;
    if (const auto status = parse(argc, argv, command)) return *status;
    const JudgeOptions& judging = command.judging;
    Times times;
    auto begin = Clock::now();
    Inputs inputs = read_inputs(find_files(command.paths, command.named_files),
                                {judging.jobs, command.keeps_going, command.named_files});
    for (const std::string& note : inputs.notes) fmt::print(stderr, "ecods_clash: {}\n", note);
    for (const FailedFile& file : inputs.failed) fmt::print(stderr, "ecods_clash: {}\n", file.error);
    times.reading = inputs.reading_seconds;
    ClashReport report = judge(std::move(inputs), judging);
    report.options = list_options(command);
    times.judging = seconds_since(begin) - times.reading;

    begin = Clock::now();
    write_pages(command, report);
    times.pictures = seconds_since(begin);
    begin = Clock::now();
    write(command.json, report, write_json);
    write(command.csv, report, write_csv);
    const bool is_table =
        !command.is_quiet && command.json != "-" && command.csv != "-" && command.html != "-" && command.bcf != "-";
    write(is_table ? "-" : "", report, write_table);
    times.writing = seconds_since(begin);
    if (command.has_times) times.print();
    if (!report.failed.empty()) return exit_failed;
    const bool is_found = std::any_of(command.failing_kinds.begin(), command.failing_kinds.end(),
                                      [&](Kind kind) { return report.counts[static_cast<std::size_t>(kind)] > 0; });
    return is_found ? exit_found : exit_ok;
}

}  // namespace
}  // namespace ecods::clash

int main(int argc, char** argv) {
    return ecods::programs::run_main("ecods_clash", argc, argv, &ecods::clash::run);
}
