// ecods_clash_building: writes a building as OBJ, of which every relation is known (scenes/building/building.hpp).
#include <CLI/CLI.hpp>
#include <iostream>
#include <vector>

#include "programs/command_line.hpp"
#include "programs/run_main.hpp"
#include "scenes/building/building.hpp"

namespace ecods::clash {
namespace {

int run(int argc, char** argv) {
    std::vector<int> bays{10, 8, 5};
    CLI::App app("Writes a building as OBJ, 25 parts a bay and storey, to standard output.", "ecods_clash_building");
    app.add_option("SIZE", bays, "Bays along x and y, and storeys; 10 8 5 is the default: 10,000 parts")
        ->expected(3)
        ->check(CLI::Range(1, 100));
    if (const auto status = programs::parse(app, argc, argv)) return *status;
    scenes::write_obj(std::cout, scenes::make_building(bays[0], bays[1], bays[2]));
    return 0;
}

}  // namespace
}  // namespace ecods::clash

int main(int argc, char** argv) {
    return ecods::programs::run_main("ecods_clash_building", argc, argv, &ecods::clash::run);
}
