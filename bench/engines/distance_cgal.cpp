// CGAL's AABB tree of doubles: the closest point of a mesh to a point.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <cmath>
#include <vector>

#include "engines/distance_engine.hpp"

namespace ecods::bench {

namespace {

class DistanceCgal final : public Distance::Engine {
    using Kernel = CGAL::Simple_cartesian<double>;
    using Triangles = std::vector<Kernel::Triangle_3>;
    using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
    using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

  public:
    explicit DistanceCgal(const scenes::DistanceWorkload& workload) {
        const Mesh& mesh = *workload.meshes[1].mesh;
        for (const Triangle& t : mesh.triangles()) {
            triangles_.emplace_back(point_of(mesh.vertices()[t[0]]), point_of(mesh.vertices()[t[1]]),
                                    point_of(mesh.vertices()[t[2]]));
        }
        tree_.insert(triangles_.cbegin(), triangles_.cend());
        tree_.build();
        tree_.accelerate_distance_queries();
    }

    double ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        const Kernel::Point_3 point = point_of(query.a.pose.t);
        return std::sqrt(CGAL::squared_distance(point, tree_.closest_point(point)));
    }

  private:
    static Kernel::Point_3 point_of(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

    Triangles triangles_;
    Tree tree_;
};

}  // namespace

std::vector<DistanceMaker> cgal_distance() {
    return {{.name = "CGAL tree of doubles",
             .use = "AABB_tree::closest_point() of a point, with the tree's own hints; in doubles",
             .traits = {.is_for_points = true},
             .set_up = makes<DistanceCgal>()}};
}

}  // namespace ecods::bench
