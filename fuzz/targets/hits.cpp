// What a segment or a ray meets of a posed mesh, against the oracle.
#include "ecods/hit.hpp"

#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"
#include "judge/hit_truth.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ecods;
    ecods::fuzz::Bytes bytes(data, size);
    const Pose pose = bytes.pose();
    const MeshShape shape(bytes.mesh(8, 6));
    const Segment segment{bytes.point(), bytes.point()};
    judge::HitLine line = segment;
    if (bytes.below(2) == 0 && segment.b != Vec3::Zero()) {
        line = Ray{segment.a, segment.b, bytes.below(2) == 0 ? std::abs(bytes.number()) : HUGE_VAL};
    }
    const judge::HitTruth truth(line, {shape, pose});
    QueryMemory memory;
    PairWitness witness{bytes.below(3), bytes.below(8)};
    ecods::fuzz::require_right(truth.ask(memory, witness));
    return 0;
}
