// libccd by itself: its GJK with EPA, and its Minkowski portal refinement.
#include <ccd/ccd.h>

#include <limits>
#include <vector>

#include "engines/convex_engine.hpp"

namespace ecods::bench {

namespace {

struct PosedVertices {
    const Mesh* mesh;
    const Pose* pose;
};

ccd_vec3_t to_ccd(const Vec3& v) {
    ccd_vec3_t result;
    ccdVec3Set(&result, v.x(), v.y(), v.z());
    return result;
}

// All vertices are looked at, in the mesh's own coordinates.
void find_support(const void* object, const ccd_vec3_t* direction, ccd_vec3_t* point) {
    const auto& [mesh, pose] = *static_cast<const PosedVertices*>(object);
    const Vec3 along = pose->R.transpose() * Vec3(direction->v[0], direction->v[1], direction->v[2]);
    const Vec3* best = nullptr;
    double most = -std::numeric_limits<double>::infinity();
    for (const Vec3& v : mesh->vertices()) {
        const double reach = along.dot(v);
        if (reach > most) most = reach, best = &v;
    }
    *point = to_ccd(pose->R * *best + pose->t);
}

// The models are made around their origin.
void find_center(const void* object, ccd_vec3_t* center) {
    *center = to_ccd(static_cast<const PosedVertices*>(object)->pose->t);
}

class ConvexCcd final : public Convex::Engine {
  public:
    using Penetration = int (*)(const void*, const void*, const ccd_t*, ccd_real_t*, ccd_vec3_t*, ccd_vec3_t*);

    ConvexCcd(const scenes::ConvexWorkload& workload, Penetration penetration)
        : workload_(workload), penetration_(penetration) {
        CCD_INIT(&ccd_);
        ccd_.support1 = ccd_.support2 = find_support;
        ccd_.center1 = ccd_.center2 = find_center;
        ccd_.max_iterations = 1000;
    }

    ConvexAnswer ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        const PosedVertices a = posed(query.a), b = posed(query.b);
        double depth = 0;
        ccd_vec3_t direction, point;
        if (penetration_(&a, &b, &ccd_, &depth, &direction, &point) != 0)
            return {std::numeric_limits<double>::quiet_NaN()};
        return {depth, {direction.v[0], direction.v[1], direction.v[2]}};
    }

  private:
    PosedVertices posed(const scenes::MeshAt& at) const {
        return {workload_.meshes[at.mesh_index].mesh.get(), &at.pose};
    }

    const scenes::ConvexWorkload& workload_;
    Penetration penetration_;
    ccd_t ccd_;
};

}  // namespace

std::vector<ConvexMaker> ccd_convex(scenes::ConvexQuestion question) {
    if (question == scenes::ConvexQuestion::distance) return {};
    return {{.name = convex_depth_yardstick,
             .use = "ccdGJKPenetration, all vertices asked by the support functions; double",
             .set_up = makes<ConvexCcd>(ccdGJKPenetration)},
            {.name = "libccd MPR",
             .use = "ccdMPRPenetration, the same support functions; double",
             .set_up = makes<ConvexCcd>(ccdMPRPenetration)}};
}

}  // namespace ecods::bench
