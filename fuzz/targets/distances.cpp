// How far two posed meshes are from each other, against the oracle.
#include <string>

#include "ecods/distance.hpp"
#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"
#include "judge/distance_truth.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ecods;
    ecods::fuzz::Bytes bytes(data, size);
    const Pose pose_a = bytes.pose();
    const Pose pose_b = bytes.below(2) == 0 ? pose_a : bytes.pose();
    const MeshShape a(bytes.mesh(8, 4)), b(bytes.mesh(8, 4));
    const judge::DistanceTruth truth({a, pose_a}, {b, pose_b});
    QueryMemory memory;
    PairWitness witness{bytes.below(3), bytes.below(3)};
    const auto wrong = truth.ask(memory, witness);
    const std::string what = wrong ? wrong->question + ": expected " + wrong->expected + ", got " + wrong->got : "";
    ecods::fuzz::require(!wrong, what.c_str());
    return 0;
}
