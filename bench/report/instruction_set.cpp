#include "report/instruction_set.hpp"

#include <unistd.h>

#include <cstdlib>
#include <stdexcept>

namespace ecods::bench {

namespace {

constexpr const char* variable = "GLIBC_TUNABLES";

std::string tunables_for(const std::string& instruction_set) {
    const std::string beyond_avx2 = "-AVX512F,-AVX512VL,-AVX512BW,-AVX512CD,-AVX512DQ";
    return "glibc.cpu.hwcaps=" + (instruction_set == "avx2" ? beyond_avx2 : beyond_avx2 + ",-AVX2,-AVX,-FMA,-BMI2");
}

}  // namespace

void start_again_with(const std::string& instruction_set, char** arguments) {
    if (instruction_set == "native") return;
    const std::string tunables = tunables_for(instruction_set);
    const char* now = std::getenv(variable);
    if (now != nullptr && now == tunables) return;
    setenv(variable, tunables.c_str(), 1);
    execv("/proc/self/exe", arguments);
    throw std::runtime_error("cannot start again with another instruction set");
}

std::string instruction_set_in_use() {
    const char* now = std::getenv(variable);
    if (now == nullptr) return "native";
    return std::string("the C library's: ") + now + "; that of ECoDS and of Embree: native";
}

}  // namespace ecods::bench
