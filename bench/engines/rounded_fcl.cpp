// FCL's collide() and distance() of two shapes, by the solver that treats pairs of spheres, capsules and boxes by
// formulas where it has any.
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <memory>

#include "engines/fcl_bodies.hpp"
#include "engines/rounded_engine.hpp"

namespace ecods::bench {

namespace {

std::shared_ptr<fcl::CollisionGeometryd> to_fcl(const RoundBody& body) {
    if (body.kind == RoundKind::sphere) return std::make_shared<fcl::Sphered>(body.radius);
    if (body.kind == RoundKind::capsule) return std::make_shared<fcl::Capsuled>(body.radius, 2 * body.size);
    return std::make_shared<fcl::Boxd>(2 * body.size, 2 * body.size, 2 * body.size);
}

class RoundFcl final : public Round::Engine {
  public:
    explicit RoundFcl(const RoundWorkload& workload) : question_(workload.question) {
        for (const RoundBody& body : workload.bodies) shapes_.push_back(to_fcl(body));
    }

    RoundAnswer ask(const RoundQuery& query, std::size_t /*index*/) override {
        const fcl::CollisionGeometryd *const a = shapes_[query.a.body_index].get(), *const b =
                                                                                        shapes_[query.b.body_index]
                                                                                            .get();
        const fcl::Transform3d at_a = bench::to_fcl(query.a.pose), at_b = bench::to_fcl(query.b.pose);
        if (question_ == RoundQuestion::intersects) {
            fcl::CollisionResultd result;
            return {fcl::collide(a, at_a, b, at_b, fcl::CollisionRequestd(), result) > 0 ? 1.0 : 0.0};
        }
        fcl::DistanceRequestd request;
        request.enable_nearest_points = question_ != RoundQuestion::distance;
        request.enable_signed_distance = question_ == RoundQuestion::signed_distance;
        fcl::DistanceResultd result;
        fcl::distance(a, at_a, b, at_b, request, result);
        RoundAnswer answer{result.min_distance};
        if (question_ != RoundQuestion::closest) return answer;
        for (std::size_t k = 0; k < 6; ++k) {
            answer.points[k] = result.nearest_points[k / 3][static_cast<Eigen::Index>(k % 3)];
        }
        return answer;
    }

  private:
    RoundQuestion question_;
    std::vector<std::shared_ptr<fcl::CollisionGeometryd>> shapes_;
};

}  // namespace

std::vector<RoundMaker> fcl_round() {
    return {{.name = round_fcl,
             .use = "Sphere, Capsule, Box; collide(), or distance(), with points and sign where these are asked for; "
                    "double",
             .set_up = makes<RoundFcl>()}};
}

}  // namespace ecods::bench
