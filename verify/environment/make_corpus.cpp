// usage: make_corpus FILE     writes the corpus: some pairs of every hard family, and of every family of distances the
// first
//                             triangles

#include <cstdio>
#include <fstream>

#include "environment/corpus.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/hard_pairs.hpp"

namespace {

using namespace ecods;

double* write(double* out, const Pose& pose, const std::array<Vec3, 3>& corners) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) *out++ = pose.R(row, column);
    }
    for (int row = 0; row < 3; ++row) *out++ = pose.t[row];
    for (const Vec3& v : corners) {
        for (int k = 0; k < 3; ++k) *out++ = v[k];
    }
    return out;
}

std::array<Vec3, 3> first_triangle(const Mesh& mesh) {
    const Triangle& t = mesh.triangles()[0];
    return {mesh.vertices()[t[0]], mesh.vertices()[t[1]], mesh.vertices()[t[2]]};
}

void write(std::ofstream& file, const Pose& pose_a, const std::array<Vec3, 3>& a, const Pose& pose_b,
           const std::array<Vec3, 3>& b) {
    environment::PairRecord record;
    write(write(record.data(), pose_a, a), pose_b, b);
    file.write(reinterpret_cast<const char*>(record.data()), sizeof record);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fputs("usage: make_corpus FILE\n", stderr);
        return 2;
    }
    std::ofstream file(argv[1], std::ios::binary);
    scenes::Random random(2026);
    for (const scenes::HardFamily family : scenes::hard_families()) {
        for (int i = 0; i < 1000; ++i) {
            const scenes::PosedPair pair = scenes::make_pair(family, random);
            write(file, pair.pose_a, pair.a, pair.pose_b, pair.b);
        }
    }
    for (const scenes::DistanceFamily family : scenes::distance_families()) {
        for (int i = 0; i < 400; ++i) {
            const scenes::DistanceCase made = scenes::make_distance_case(family, random);
            write(file, made.pose_a, first_triangle(*made.a), made.pose_b, first_triangle(*made.b));
        }
    }
    return file ? 0 : 1;
}
