// How far two posed meshes are from each other, against the oracle.
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
    ecods::fuzz::require_right(truth.ask(memory, witness));
    return 0;
}
