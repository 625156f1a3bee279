// When two posed meshes on their way first share a point, against the oracle.
#include "ecods/cast.hpp"

#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"
#include "judge/cast_truth.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ecods;
    ecods::fuzz::Bytes bytes(data, size);
    const bool is_translation = bytes.below(2) == 0;
    const Pose a = bytes.pose(), b = bytes.pose();
    const MeshShape first(bytes.mesh(6, 2)), second(bytes.mesh(6, 2));
    const auto truth = [&]() -> judge::CastTruth {
        if (is_translation) return {{first, a}, bytes.point(), {second, b}, 4};
        const Pose to_a = bytes.pose(), to_b = bytes.below(2) == 0 ? b : bytes.pose();
        return {Moving<MeshShape>(first, a, to_a), Moving<MeshShape>(second, b, to_b), 4};
    }();
    QueryMemory memory;
    PairWitness witness{bytes.below(3), bytes.below(3)};
    ecods::fuzz::require_right(truth.ask(memory, witness));
    return 0;
}
