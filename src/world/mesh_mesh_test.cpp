#include "world/mesh_mesh_test.hpp"

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "ecods/turn.hpp"
#include "query/body/posed_body.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/solid/solid_parts.hpp"

namespace ecods {
namespace {

class MeshMeshTest final : public TwoBodyTest {
  public:
    explicit MeshMeshTest(PosedBody::Meaning meaning) : is_of_surfaces_(meaning == PosedBody::Meaning::surface) {}

    bool answers(Question question) const noexcept override { return question != Question::hits; }

    // Tests two surfaces, which are the most frequent bodies, without copying their poses.
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        if (is_of_surfaces_ || are_surfaces(*mesh_in(a), *mesh_in(b))) return surface::intersects(a, b, ask);
        return ecods::intersects(mesh_of(a), mesh_of(b), ask);
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::relation(mesh_of(a), mesh_of(b), ask);
    }
    std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                     const Ask& ask) const override {
        return ecods::intersecting_triangles(mesh_of(a), mesh_of(b), ask);
    }

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
    std::optional<FirstContact> cast_any_motion(const Posed<Shape>& a, const Motion& motion_of_a, const Posed<Shape>& b,
                                                const Motion& motion_of_b, double max_time,
                                                const Ask& ask) const override {
        return ecods::cast(mesh_of(a), motion_of_a, mesh_of(b), motion_of_b, max_time, ask);
    }

  private:
    template <class PosedOrMoving>
    static const MeshShape* mesh_in(const PosedOrMoving& body) noexcept {
        return static_cast<const MeshShape*>(body.what);
    }
    const MeshShape& meant(const MeshShape& shape) const {
        const bool is_meant = !is_of_surfaces_ || shape.form() == MeshForm::surface;
        return is_meant ? shape : *SolidAccess::surface(static_cast<const Solid&>(shape));
    }
    Moving<MeshShape> mesh_of(const Moving<Shape>& moving) const {
        return {meant(*mesh_in(moving)), moving.from, moving.to};
    }
    Posed<MeshShape> mesh_of(const Posed<Shape>& posed) const { return {meant(*mesh_in(posed)), posed.pose}; }

    bool is_of_surfaces_;
};

}  // namespace

std::shared_ptr<const TwoBodyTest> make_mesh_mesh_test() {
    return std::make_shared<MeshMeshTest>(PosedBody::Meaning::set);
}

std::shared_ptr<const TwoBodyTest> make_surface_surface_test() {
    return std::make_shared<MeshMeshTest>(PosedBody::Meaning::surface);
}

}  // namespace ecods
