// What most libraries would be at best: vertices are rounded when they are posed, and everything after that is exact.
#include "fuzz/engines/rounded.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "ecods/primitives.hpp"

namespace ecods::fuzz {
namespace {

std::vector<std::array<Vec3, 3>> posed_triangles(const Mesh& mesh, const Pose& pose) {
    std::vector<std::array<Vec3, 3>> triangles;
    for (const Triangle& t : mesh.triangles()) {
        const auto corner = [&](std::size_t k) -> Vec3 { return pose.R * mesh.vertices()[t[k]] + pose.t; };
        triangles.push_back({corner(0), corner(1), corner(2)});
    }
    return triangles;
}

bool boxes_overlap(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
    for (int k = 0; k < 3; ++k) {
        if (std::max({a[0][k], a[1][k], a[2][k]}) < std::min({b[0][k], b[1][k], b[2][k]}) ||
            std::max({b[0][k], b[1][k], b[2][k]}) < std::min({a[0][k], a[1][k], a[2][k]})) {
            return false;
        }
    }
    return true;
}

class Rounded final : public EngineUnderTest {
  public:
    explicit Rounded(std::span<const scenes::NamedMesh> meshes) : meshes_(meshes) {}

    bool intersects(const scenes::MeshQuery& query) override {
        const Pose nowhere;
        const auto b = posed_triangles(*meshes_[query.b.mesh_index].mesh, query.b.pose);
        for (const auto& x : posed_triangles(*meshes_[query.a.mesh_index].mesh, query.a.pose)) {
            for (const auto& y : b) {
                if (boxes_overlap(x, y) && triangle_triangle({nowhere, x}, {nowhere, y}) != Relation::apart) {
                    return true;
                }
            }
        }
        return false;
    }

  private:
    std::span<const scenes::NamedMesh> meshes_;
};

}  // namespace

std::unique_ptr<EngineUnderTest> make_rounded(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<Rounded>(meshes);
}

}  // namespace ecods::fuzz
