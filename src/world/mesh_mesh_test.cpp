#include "world/mesh_mesh_test.hpp"

#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "query/cast/cast_until.hpp"
#include "query/intersection/mesh_intersection_test.hpp"

namespace ecods {
namespace {

class MeshMeshTest final : public MeshIntersectionTest {
  public:
    bool answers(Question question) const noexcept override { return question != Question::hits; }

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

    std::vector<TriangleIntersection> intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                    QueryMemory& memory) const override {
        return ecods::intersections(mesh_of(a), mesh_of(b), memory);
    }
    std::vector<CloseFeatures> close_features(const Posed<Shape>& a, const Posed<Shape>& b, double d,
                                              QueryMemory& memory) const override {
        return ecods::close_features(mesh_of(a), mesh_of(b), d, memory);
    }
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b, double time_max,
                                     QueryMemory& memory) const override {
        PairWitness witness;
        return cast_until(mesh_of(a), motion, mesh_of(b), time_max, memory, witness);
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double time_max,
                                            QueryMemory& memory) const override {
        PairWitness witness;
        return cast_until(mesh_of(a), mesh_of(b), time_max, memory, witness);
    }

  private:
    static Moving<MeshShape> mesh_of(const Moving<Shape>& moving) {
        return {static_cast<const MeshShape&>(*moving.what), moving.from, moving.to};
    }
    static Posed<MeshShape> mesh_of(const Posed<Shape>& posed) {
        return {static_cast<const MeshShape&>(*posed.what), posed.pose};
    }
};

}  // namespace

std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test() {
    return std::make_shared<MeshMeshTest>();
}

}  // namespace ecods
