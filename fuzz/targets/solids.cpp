// What is said of two posed solids, and whether meshes bound one, against the oracle.
#include "ecods/solid.hpp"

#include "fuzz/targets/bytes.hpp"
#include "fuzz/targets/require.hpp"
#include "judge/solid_truth.hpp"
#include "scenes/lattice_mesh.hpp"

namespace {

using ecods::Mesh;
using ecods::fuzz::Bytes;
using ecods::fuzz::require_right;

// Some cells of a grid of 3 by 3 by 2, bounded by triangles as a byte says.
std::shared_ptr<const Mesh> cells(Bytes& bytes) {
    ecods::scenes::Cells cells;
    for (int row = 0; row < 6; ++row) {
        const std::uint32_t bits = bytes.below(8);
        for (int x = 0; x < 3; ++x) {
            if ((bits >> x & 1) != 0) cells.push_back({x, row % 3, row / 3});
        }
    }
    if (cells.empty()) cells.push_back({0, 0, 0});
    cells = ecods::scenes::sorted(std::move(cells));
    ecods::scenes::Random random(bytes.byte());
    const bool merges_faces = bytes.below(2) == 0;
    return ecods::scenes::place_at(ecods::scenes::boundary(cells, merges_faces, random), {}, random).mesh;
}

// Solids all of them, if their corners are not in one plane.
std::shared_ptr<const Mesh> tetrahedron(Bytes& bytes) {
    const std::vector<ecods::Vec3> corners{bytes.point(), bytes.point(), bytes.point(), bytes.point()};
    return Mesh::create(corners, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
}

std::shared_ptr<const Mesh> any_mesh(Bytes& bytes) {
    const std::uint32_t choice = bytes.below(4);
    return choice < 2 ? cells(bytes) : choice == 2 ? tetrahedron(bytes) : bytes.mesh(8, 12);
}

bool is_solid(const Mesh& mesh) {
    return !ecods::oracle::open_edge(mesh) && ecods::oracle::self_intersections(mesh).empty() &&
           !ecods::oracle::bounds_nothing(mesh);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ecods;
    Bytes bytes(data, size);
    const Pose pose_a = bytes.pose(), pose_b = bytes.pose();
    const auto a = any_mesh(bytes), b = any_mesh(bytes);
    require_right(judge::ask_whether_solid(*a));
    require_right(judge::ask_whether_solid(*b));
    if (!is_solid(*a) || !is_solid(*b)) return 0;
    const Solid solid_a(a), solid_b(b);
    const Vec3 points[] = {bytes.point(), bytes.point()};
    QueryMemory memory;
    require_right(judge::SolidTruth({solid_a, pose_a}, {solid_b, pose_b}, points).ask(memory));
    return 0;
}
