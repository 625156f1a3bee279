#include "query/intersection/mesh_mesh_test.hpp"

#include "ecods/intersection.hpp"

namespace ecods {
namespace {

PosedMesh as_mesh(const PosedShape& posed) {
    return {static_cast<const MeshShape&>(posed.shape), posed.pose};
}

class MeshMeshTest final : public TwoBodyTest {
  public:
    bool intersects(const PosedShape& a, const PosedShape& b, QueryMemory& memory) const override {
        return ecods::intersects(as_mesh(a), as_mesh(b), memory);
    }
    bool intersects_again(const PosedShape& a, const PosedShape& b, QueryMemory& memory,
                          PairWitness& witness) const override {
        return ecods::intersects(as_mesh(a), as_mesh(b), memory, witness);
    }
    Relation relation(const PosedShape& a, const PosedShape& b, QueryMemory& memory) const override {
        return ecods::relation(as_mesh(a), as_mesh(b), memory);
    }
    std::vector<TrianglePair> intersecting_triangles(const PosedShape& a, const PosedShape& b,
                                                     QueryMemory& memory) const override {
        return ecods::intersecting_triangles(as_mesh(a), as_mesh(b), memory);
    }
};

}  // namespace

std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test() {
    return std::make_shared<MeshMeshTest>();
}

}  // namespace ecods
