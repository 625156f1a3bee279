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

class HitCgal final : public HitEngine {
  public:
    explicit HitCgal(const scenes::PosedTriangles& all) {
        for (const Triangle& t : all.triangles)
            triangles_.emplace_back(to_cgal(all.vertices[t[0]]), to_cgal(all.vertices[t[1]]),
                                    to_cgal(all.vertices[t[2]]));
        tree_.insert(triangles_.cbegin(), triangles_.cend());
        tree_.build();
    }

    void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); ++i) answers[i] = first_hit(segments[i]);
    }

    void all_hits(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        triangles.clear();
        found_.clear();
        tree_.all_intersected_primitives(Kernel::Segment_3(to_cgal(segment.a), to_cgal(segment.b)),
                                         std::back_inserter(found_));
        for (const Triangles::const_iterator found : found_) triangles.push_back(index_of(found));
    }

  private:
    HitAnswer first_hit(const Segment& segment) const {
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
        return first > 1 ? HitAnswer{} : HitAnswer{first, index_of(hit->second)};
    }

    std::uint32_t index_of(Triangles::const_iterator found) const {
        return static_cast<std::uint32_t>(found - triangles_.cbegin());
    }

    Triangles triangles_;
    Tree tree_;
    std::vector<Triangles::const_iterator> found_;
};

}  // namespace

std::unique_ptr<HitEngine> set_up_hit_cgal(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitCgal>(posed_triangles(workload));
}

}  // namespace ecods::bench
