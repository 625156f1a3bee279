#include "world/mesh_mesh_test.hpp"

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "query/intersection/mesh_intersection_test.hpp"

namespace ecods {
namespace {

class MeshMeshTest final : public MeshIntersectionTest {
  public:
    bool answers(Question question) const noexcept override { return question != Question::hits; }

    double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::distance(mesh_of(a), mesh_of(b), ask);
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance, const Ask& ask) const override {
        return ecods::within(mesh_of(a), mesh_of(b), max_distance, ask);
    }
    ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::closest(mesh_of(a), mesh_of(b), ask);
    }

    std::vector<TriangleIntersection> intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                    const Ask& ask) const override {
        return ecods::intersections(mesh_of(a), mesh_of(b), ask);
    }
    std::vector<CloseFeatures> close_features(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance,
                                              const Ask& ask) const override {
        return ecods::close_features(mesh_of(a), mesh_of(b), max_distance, ask);
    }
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b, double max_time,
                                     const Ask& ask) const override {
        return ecods::cast(mesh_of(a), motion, mesh_of(b), max_time, ask);
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        return ecods::cast(mesh_of(a), mesh_of(b), max_time, ask);
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
