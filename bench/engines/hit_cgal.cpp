// CGAL's AABB tree. Its first_intersection() takes rays only.
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <iterator>

#include "engines/hit_engine.hpp"

namespace ecods::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangles = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Triangles::const_iterator>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

Kernel::Point_3 to_cgal(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

class HitCgal final : public FirstHits::Engine, public HitLists {
  public:
    explicit HitCgal(const scenes::SegmentWorkload& workload) {
        const scenes::PosedTriangles all = posed_triangles(workload);
        for (const Triangle& t : all.triangles)
            triangles_.emplace_back(to_cgal(all.vertices[t[0]]), to_cgal(all.vertices[t[1]]),
                                    to_cgal(all.vertices[t[2]]));
        tree_.insert(triangles_.cbegin(), triangles_.cend());
        tree_.build();
    }

    HitAnswer ask(const Segment& segment, std::size_t /*index*/) override {
        const Kernel::Point_3 from = to_cgal(segment.a), to = to_cgal(segment.b);
        const auto hit = tree_.first_intersection(Kernel::Ray_3(from, to));
        if (!hit) return {};
        const Kernel::Vector_3 arm = to - from;
        const auto parameter = [&](const Kernel::Point_3& point) { return (point - from) * arm / (arm * arm); };
        double first = 0;
        if (const auto* const point = boost::get<Kernel::Point_3>(&hit->first)) {
            first = parameter(*point);
        } else if (const auto* const part = boost::get<Kernel::Segment_3>(&hit->first)) {
            first = std::min(parameter(part->source()), parameter(part->target()));
        } else {
            return {};
        }
        return first > 1 ? HitAnswer{} : HitAnswer{first, static_cast<double>(index_of(hit->second))};
    }

    void list(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        triangles.clear();
        found_.clear();
        tree_.all_intersected_primitives(Kernel::Segment_3(to_cgal(segment.a), to_cgal(segment.b)),
                                         std::back_inserter(found_));
        for (const Triangles::const_iterator found : found_) triangles.push_back(index_of(found));
    }

  private:
    std::uint32_t index_of(Triangles::const_iterator found) const {
        return static_cast<std::uint32_t>(found - triangles_.cbegin());
    }

    Triangles triangles_;
    Tree tree_;
    std::vector<Triangles::const_iterator> found_;
};

}  // namespace

std::vector<HitMaker> cgal_hits() {
    return {{.name = "CGAL Epick",
             .use = "AABB_tree::first_intersection() of the ray, dropped behind the segment's end, and "
                    "all_intersected_primitives() of the segment; predicates exact on rounded vertices, points double",
             .has_lists = true,
             .traits = {.bodies = HitBodies::one},
             .set_up = makes<HitCgal>()}};
}

}  // namespace ecods::bench
