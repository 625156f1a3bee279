// The loop that collide_many and distance_many are, in C++: what they are measured against (overhead.py).
// usage: ecods_python_loop SCENE     prints the seconds of each: intersects, distance
#include <chrono>
#include <cstdint>
#include <fstream>
#include <iostream>
#include <memory>
#include <tuple>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"

namespace {

using Body = ecods::Posed<ecods::MeshShape>;

template <class T>
std::vector<T> read(std::istream& in) {
    std::uint64_t count = 0;
    in.read(reinterpret_cast<char*>(&count), sizeof count);
    std::vector<T> values(count);
    in.read(reinterpret_cast<char*>(values.data()), static_cast<std::streamsize>(count * sizeof(T)));
    return values;
}

template <class Answer, class Question>
void time(const std::vector<double>& entries, const ecods::MeshShape& shape, const Question& question) {
    const auto begin = std::chrono::steady_clock::now();
    std::vector<Answer> answers(entries.size() / 16);
    ecods::QueryMemory memory;
    ecods::PairWitness witness;
    for (std::size_t i = 0; i < answers.size(); ++i) {
        const double* x = entries.data() + 16 * i;
        ecods::Pose pose;
        for (int k = 0; k < 9; ++k) pose.R(k / 3, k % 3) = x[4 * (k / 3) + k % 3];
        pose.t = {x[3], x[7], x[11]};
        answers[i] = static_cast<Answer>(question(Body(shape, pose), Body(shape, {}), {memory, witness}));
    }
    std::cout << std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count() << '\n';
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return 2;
    std::ifstream in(arguments[1], std::ios::binary);
    const auto vertices = read<double>(in);
    const auto faces = read<std::uint32_t>(in);
    const auto poses = read<double>(in);
    const ecods::MeshShape shape(ecods::Mesh::create(vertices, faces));
    ecods::QueryMemory memory;
    std::ignore = ecods::intersects({shape, {}}, {shape, {}}, memory);
    for (int run = 0; run < 3; ++run) {
        time<char>(poses, shape,
                   [](const Body& a, const Body& b, const ecods::Ask& ask) { return intersects(a, b, ask); });
        time<double>(poses, shape,
                     [](const Body& a, const Body& b, const ecods::Ask& ask) { return distance(a, b, ask); });
    }
}
