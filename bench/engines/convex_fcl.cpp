// FCL's distance() and collide() of two Convex shapes, by either of its solvers.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <limits>
#include <vector>

#include "engines/convex_engine.hpp"
#include "engines/fcl_bodies.hpp"

namespace ecods::bench {

namespace {

class ConvexFcl final : public Convex::Engine {
  public:
    ConvexFcl(const scenes::ConvexWorkload& workload, fcl::GJKSolverType solver)
        : question_(workload.question), collision_(1, true) {
        distance_.gjk_solver_type = solver;
        collision_.gjk_solver_type = solver;
        for (const scenes::NamedMesh& named : workload.meshes) shapes_.push_back(to_fcl_convex(*named.mesh));
    }

    ConvexAnswer ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        const fcl::Convexd *a = shapes_[query.a.mesh_index].get(), *b = shapes_[query.b.mesh_index].get();
        const fcl::Transform3d at_a = to_fcl(query.a.pose), at_b = to_fcl(query.b.pose);
        if (question_ == scenes::ConvexQuestion::distance) {
            fcl::DistanceResultd result;
            fcl::distance(a, at_a, b, at_b, distance_, result);
            return {result.min_distance};
        }
        fcl::CollisionResultd result;
        if (fcl::collide(a, at_a, b, at_b, collision_, result) == 0) return {std::numeric_limits<double>::quiet_NaN()};
        const fcl::Contactd& contact = result.getContact(0);
        // GST_INDEP gives it as a negative number.
        return {std::abs(contact.penetration_depth), {contact.normal.x(), contact.normal.y(), contact.normal.z()}};
    }

  private:
    scenes::ConvexQuestion question_;
    fcl::DistanceRequestd distance_;
    fcl::CollisionRequestd collision_;
    std::vector<std::shared_ptr<fcl::Convexd>> shapes_;
};

}  // namespace

std::vector<ConvexMaker> fcl_convex(scenes::ConvexQuestion question) {
    const bool is_depth = question == scenes::ConvexQuestion::depth;
    return {{.name = convex_distance_yardstick,
             .use = is_depth ? "Convex, collide() with contacts, GST_LIBCCD, its default (MPR); double"
                             : "Convex, distance() with GST_LIBCCD, without points; double",
             .set_up = makes<ConvexFcl>(fcl::GST_LIBCCD)},
            {.name = "FCL indep",
             .use = is_depth ? "Convex, collide() with contacts, GST_INDEP; double"
                             : "Convex, distance() with GST_INDEP; double",
             .set_up = makes<ConvexFcl>(fcl::GST_INDEP)}};
}

}  // namespace ecods::bench
