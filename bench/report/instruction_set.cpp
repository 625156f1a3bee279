#include "report/instruction_set.hpp"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#include "environment/instruction_sets.hpp"
#include "simd/instruction_set.hpp"

namespace ecods::bench {

namespace {

constexpr const char* variable = "GLIBC_TUNABLES";

std::string tunables_for(InstructionSet set) {
    const std::string beyond_avx2 = "-AVX512F,-AVX512VL,-AVX512BW,-AVX512CD,-AVX512DQ";
    return "glibc.cpu.hwcaps=" + (set == InstructionSet::avx2 ? beyond_avx2 : beyond_avx2 + ",-AVX2,-AVX,-FMA,-BMI2");
}

}  // namespace

void use_instruction_set(const std::string& name, char** arguments) {
    if (name == "native") return;
    const InstructionSet set = std::min(name == "avx2" ? InstructionSet::avx2 : InstructionSet::baseline,
                                        environment::widest_instruction_set());
    limit_instruction_set(set);
    const std::string tunables = tunables_for(set);
    const char* now = std::getenv(variable);
    if (now != nullptr && now == tunables) return;
    setenv(variable, tunables.c_str(), 1);
    execv("/proc/self/exe", arguments);
    throw std::runtime_error("cannot start again with another instruction set");
}

std::string instruction_set_in_use() {
    const std::string own = environment::name(instruction_set());
    const char* now = std::getenv(variable);
    if (now == nullptr) return "native (ECoDS: " + own + ")";
    return "ECoDS and Embree: " + own + ", the C library: " + now;
}

}  // namespace ecods::bench
