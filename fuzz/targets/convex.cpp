// How far two posed convex solids are from each other, or how deep in each other, against the oracle; and hulls.
#include <tuple>
#include <vector>

#include "ecods/error.hpp"
#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"
#include "judge/convex_truth.hpp"

namespace {

using ecods::Mesh;
using ecods::fuzz::Bytes;
using ecods::fuzz::require_right;

// Nothing if the points are in one plane.
std::shared_ptr<const Mesh> hull(Bytes& bytes) {
    std::vector<ecods::Vec3> points(4 + bytes.below(6));
    for (ecods::Vec3& p : points) p = bytes.point();
    require_right(ecods::judge::ask_for_hull(points));
    try {
        return ecods::convex_hull(points);
    } catch (const ecods::NotSolid&) {
        return nullptr;
    }
}

bool is_regular(const ecods::Pose& pose) {
    const ecods::ConvexSolid cube(std::vector<ecods::Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}});
    ecods::QueryMemory memory;
    try {
        std::ignore = ecods::depth({cube, pose}, {cube, pose}, memory);
        return true;
    } catch (const ecods::SingularPose&) {
        return false;
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ecods;
    Bytes bytes(data, size);
    const Pose pose_a = bytes.pose();
    const Pose pose_b = bytes.below(2) == 0 ? pose_a : bytes.pose();
    const auto mesh_a = hull(bytes), mesh_b = hull(bytes);
    if (!mesh_a || !mesh_b || !is_regular(pose_a) || !is_regular(pose_b)) return 0;
    const ConvexSolid a(mesh_a), b(mesh_b);
    QueryMemory memory;
    PairWitness witness{bytes.below(3), bytes.below(3)};
    require_right(judge::ConvexTruth({a, pose_a}, {b, pose_b}).ask(memory, witness));
    return 0;
}
