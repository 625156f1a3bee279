// The benchmark library's main, with the instruction sets of the run.
#include <benchmark/benchmark.h>

#include "environment/instruction_sets.hpp"

int main(int argc, char** argv) {
    ecods::environment::limit_by_variable_or_exit();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
