// FCL's distance() and collide() of two Convex shapes, by either of its solvers.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <limits>
#include <vector>

#include "engines/convex_engine.hpp"
#include "engines/fcl_bodies.hpp"
#include "engines/fcl_convex.hpp"

namespace ecods::bench {

namespace {

class ConvexFcl final : public ConvexEngine {
  public:
    ConvexFcl(const scenes::ConvexWorkload& workload, fcl::GJKSolverType solver)
        : question_(workload.question), collision_(1, true) {
        distance_.gjk_solver_type = solver;
        collision_.gjk_solver_type = solver;
        for (const scenes::NamedMesh& named : workload.pairs.meshes) shapes_.push_back(to_fcl_convex(*named.mesh));
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
        return {std::abs(contact.penetration_depth), contact.normal};
    }

  private:
    scenes::ConvexQuestion question_;
    fcl::DistanceRequestd distance_;
    fcl::CollisionRequestd collision_;
    std::vector<std::shared_ptr<fcl::Convexd>> shapes_;
};

}  // namespace

std::unique_ptr<ConvexEngine> set_up_convex_fcl_libccd(const scenes::ConvexWorkload& workload) {
    return std::make_unique<ConvexFcl>(workload, fcl::GST_LIBCCD);
}

std::unique_ptr<ConvexEngine> set_up_convex_fcl_indep(const scenes::ConvexWorkload& workload) {
    return std::make_unique<ConvexFcl>(workload, fcl::GST_INDEP);
}

}  // namespace ecods::bench
