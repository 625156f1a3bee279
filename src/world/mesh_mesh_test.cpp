#include "world/mesh_mesh_test.hpp"

#include "ecods/distance.hpp"
#include "query/intersection/mesh_intersection_test.hpp"

namespace ecods {
namespace {

class MeshMeshTest final : public MeshIntersectionTest {
  public:
    bool answers(Question /*question*/) const noexcept override { return true; }

    double distance(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const override {
        return ecods::distance(mesh_of(a), mesh_of(b), memory);
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double d, QueryMemory& memory) const override {
        return ecods::within(mesh_of(a), mesh_of(b), d, memory);
    }
    bool within_again(const Posed<Shape>& a, const Posed<Shape>& b, double d, QueryMemory& memory,
                      PairWitness& witness) const override {
        return ecods::within(mesh_of(a), mesh_of(b), d, memory, witness);
    }
    ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, QueryMemory& memory) const override {
        return ecods::closest(mesh_of(a), mesh_of(b), memory);
    }

  private:
    static Posed<MeshShape> mesh_of(const Posed<Shape>& posed) {
        return {static_cast<const MeshShape&>(*posed.what), posed.pose};
    }
};

}  // namespace

std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test() {
    return std::make_shared<MeshMeshTest>();
}

}  // namespace ecods
