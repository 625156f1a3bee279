// certificate_samples FOLDER [COUNT [SEED [CHECKER]]]: of each case N.cert, and N.a.mesh and N.b.mesh, or of a world
// all N.*.mesh; prints their names.
//
// certificate_samples FOLDER gaps COUNT: NAME.QUESTION.cert of pairs a small distance apart, and NAME.mesh (times.py).
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

#include "certificates/samples/samples.hpp"

namespace {

void write_mesh(const std::filesystem::path& path, const ecods::MeshShape& shape) {
    std::ofstream file(path, std::ios::binary);
    ecods::write_certified_mesh(file, shape);
}

void write_gaps(const std::filesystem::path& folder, std::size_t count) {
    ecods::certificates::make_gap_samples(count, 5, [&](const ecods::certificates::Sample& sample) {
        const auto mesh = folder / (sample.name.substr(0, sample.name.find('.')) + ".mesh");
        if (!std::filesystem::exists(mesh)) write_mesh(mesh, *sample.a);
        std::ofstream file(folder / (sample.name + ".cert"), std::ios::binary | std::ios::app);
        sample.certificate.write(file);
    });
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::cerr << "usage: certificate_samples FOLDER [COUNT [SEED [CHECKER]]]\n"
                     "       certificate_samples FOLDER gaps COUNT\n";
        return 2;
    }
    const std::filesystem::path folder = argv[1];
    std::filesystem::create_directories(folder);
    if (argc == 4 && std::string(argv[2]) == "gaps") {
        write_gaps(folder, std::strtoul(argv[3], nullptr, 10));
        return 0;
    }
    const std::size_t count = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 2;
    const auto seed = static_cast<std::uint32_t>(argc > 3 ? std::strtoul(argv[3], nullptr, 10) : 1);
    std::size_t number = 0;
    std::shared_ptr<const ecods::MeshShape> last;
    ecods::certificates::make_samples(count, seed, [&](const ecods::certificates::Sample& sample) {
        const bool is_new = sample.a != last;
        if (is_new) {
            ++number;
            last = sample.a;
            write_mesh(folder / (std::to_string(number) + ".a.mesh"), *sample.a);
            if (sample.b) write_mesh(folder / (std::to_string(number) + ".b.mesh"), *sample.b);
            std::cout << number << ' ' << sample.name << '\n';
        }
        std::ofstream file(folder / (std::to_string(number) + ".cert"),
                           is_new ? std::ios::binary : std::ios::binary | std::ios::app);
        sample.certificate.write(file);
    });
    ecods::certificates::make_worlds(count, seed, [&](const ecods::WorldCertificate& world) {
        ++number;
        std::size_t mesh = 0;
        for (const auto& shape : world.shapes()) {
            write_mesh(folder / (std::to_string(number) + '.' + std::to_string(mesh++) + ".mesh"), *shape);
        }
        std::ofstream file(folder / (std::to_string(number) + ".cert"), std::ios::binary);
        world.write(file);
        std::cout << number << " world, " << world.colliding_count() << " colliding, " << world.close_count()
                  << " close, " << world.apart_count() << " apart\n";
    });
    if (argc <= 4) return 0;
    // Of each case, all certificates at once.
    for (std::size_t k = 1; k <= number; ++k) {
        const std::string base = (folder / std::to_string(k)).string();
        const std::string command = std::string(argv[4]) + ' ' + base + ".cert " + base + ".*.mesh > " + base + ".said";
        if (std::system(command.c_str()) == 0) continue;
        std::cerr << base << ".cert is refused\n";
        return 1;
    }
    return 0;
}
