#include "report/environment.hpp"

#include <fcl/config.h>
#include <fmt/core.h>
#include <gsl/gsl_version.h>
#include <sys/utsname.h>

#include <Eigen/Core>
#include <ctime>
#include <fstream>
#include <thread>

#include "ecods/export.hpp"
#include "process/program.hpp"
#include "report/instruction_set.hpp"

namespace ecods::bench {

namespace {

std::string processor() {
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);) {
        const std::size_t colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown processor";
}

std::string system_name() {
    std::ifstream in("/etc/os-release");
    std::string name = "unknown system";
    for (std::string line; std::getline(in, line);)
        if (line.starts_with("PRETTY_NAME=\"")) name = line.substr(13, line.size() - 14);
    utsname kernel{};
    if (uname(&kernel) == 0) name += fmt::format(", {} {} {}", kernel.sysname, kernel.release, kernel.machine);
    return name;
}

std::string commit() {
    const process::ProgramResult head =
        process::run_program({"git", "-C", ECODS_BENCH_SOURCE, "rev-parse", "--short=12", "HEAD"});
    if (head.status != 0) return "unknown";
    std::string text = head.out.substr(0, head.out.find('\n'));
    // Files of results change nothing that is measured.
    const process::ProgramResult changes = process::run_program(
        {"git", "-C", ECODS_BENCH_SOURCE, "status", "--porcelain", "--", ":/", ":(exclude,top)bench/results"});
    if (changes.status != 0 || !changes.out.empty()) text += ", with changes that are not committed";
    return text;
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    char text[32] = "";
    std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", std::gmtime(&now));
    return text;
}

}  // namespace

Table environment(const std::string& command) {
    Table table;
    table.header = {"what", "value"};
    table.text_columns = 2;
    table.rows = {
        {"command", command},
        {"date", today()},
        {"commit", commit()},
        {"processor", fmt::format("{}, {} threads", processor(), std::thread::hardware_concurrency())},
        {"instruction set", instruction_set_in_use()},
        {"system", system_name()},
        {"compiler", ECODS_BENCH_COMPILER},
        {"libraries",
         fmt::format("ECoDS {}.{}.{}, FCL {}, {}, CGAL {} (oracle, too), Eigen {}.{}.{}, GSL {}", ECODS_VERSION_MAJOR,
                     ECODS_VERSION_MINOR, ECODS_VERSION_PATCH, FCL_VERSION, ECODS_BENCH_PEERS, ECODS_BENCH_CGAL,
                     EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION, GSL_VERSION)},
    };
    return table;
}

}  // namespace ecods::bench
