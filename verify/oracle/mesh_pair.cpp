#include <CGAL/box_intersection_d.h>

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "oracle/float_environment.hpp"
#include "oracle/mesh_impl.hpp"
#include "oracle/oracle.hpp"
#include "oracle/simplex_pair.hpp"

namespace ecods::oracle {
namespace {

using TriangleBox = CGAL::Box_intersection_d::Box_with_info_d<double, 3, std::uint32_t>;

// The boxes of those triangles that reach into `region`.
std::vector<TriangleBox> boxes_in(const OracleMesh::Impl& mesh, const Aabb& region) {
    std::vector<TriangleBox> boxes;
    const auto count = static_cast<std::uint32_t>(mesh.mesh->triangles().size());
    for (std::uint32_t triangle = 0; triangle < count; ++triangle) {
        Aabb box = mesh.triangle_box(triangle);
        if (boxes_overlap(box, region)) boxes.emplace_back(box.min.data(), box.max.data(), triangle);
    }
    return boxes;
}

// CGAL takes the largest double for infinity; boxes near it go another way.
bool is_moderate(const Aabb& box) {
    const double limit = std::ldexp(1.0, 1000);
    return (box.min.array() > -limit).all() && (box.max.array() < limit).all();
}

// The pairs of triangles whose certified boxes overlap, ascending.
std::vector<TrianglePair> candidates(const OracleMesh::Impl& a, const OracleMesh::Impl& b) {
    std::vector<TrianglePair> pairs;
    if (!boxes_overlap(a.outer_box, b.outer_box)) return pairs;
    std::vector<TriangleBox> boxes_a = boxes_in(a, b.outer_box);
    std::vector<TriangleBox> boxes_b = boxes_in(b, a.outer_box);
    const auto report = [&pairs](const TriangleBox& x, const TriangleBox& y) { pairs.push_back({x.info(), y.info()}); };
    if (is_moderate(a.outer_box) && is_moderate(b.outer_box)) {
        CGAL::box_intersection_d(boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(), report,
                                 std::ptrdiff_t{10}, CGAL::Box_intersection_d::CLOSED);
    } else {
        CGAL::box_intersection_all_pairs_d(boxes_a.begin(), boxes_a.end(), boxes_b.begin(), boxes_b.end(), report,
                                           CGAL::Box_intersection_d::CLOSED);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    return pairs;
}

// The simplices of a mesh that were asked for. A triangle is in many candidates, and may need exact numbers in each.
class SimplexMemory {
  public:
    explicit SimplexMemory(const OracleMesh::Impl& mesh) : mesh_(mesh) {}

    Simplex& get(std::uint32_t triangle) {
        const auto entry = simplices_.find(triangle);
        return entry != simplices_.end() ? entry->second
                                         : simplices_.emplace(triangle, mesh_.simplex(triangle)).first->second;
    }

  private:
    const OracleMesh::Impl& mesh_;
    std::unordered_map<std::uint32_t, Simplex> simplices_;
};

// Goes through the pairs of triangles that share a point, ascending.
class PairWalk {
  public:
    PairWalk(const OracleMesh::Impl& a, const OracleMesh::Impl& b)
        : memory_a_(a), memory_b_(b), pairs_(candidates(a, b)) {}

    // Goes to the next pair; false at the end.
    bool next() {
        while (next_ < pairs_.size()) {
            const TrianglePair& candidate = pairs_[next_++];
            if (intersects(memory_a_.get(candidate.a), memory_b_.get(candidate.b))) return true;
        }
        return false;
    }

    const TrianglePair& pair() const { return pairs_[next_ - 1]; }

    Relation relation() {
        return is_crossing(memory_a_.get(pair().a), memory_b_.get(pair().b)) ? Relation::crossing : Relation::touching;
    }

  private:
    FloatEnvironment environment_;
    SimplexMemory memory_a_;
    SimplexMemory memory_b_;
    std::vector<TrianglePair> pairs_;
    std::size_t next_ = 0;
};

}  // namespace

Relation triangle_triangle(const Pose& pose_a, const std::array<Vec3, 3>& a, const Pose& pose_b,
                           const std::array<Vec3, 3>& b) {
    const FloatEnvironment environment;
    const auto simplex = [](const Pose& pose, const std::array<Vec3, 3>& corners) {
        return make_simplex(
            pose, corners,
            {posed_point<IntervalKernel>(pose, corners[0]), posed_point<IntervalKernel>(pose, corners[1]),
             posed_point<IntervalKernel>(pose, corners[2])});
    };
    Simplex simplex_a = simplex(pose_a, a);
    Simplex simplex_b = simplex(pose_b, b);
    if (!intersects(simplex_a, simplex_b)) return Relation::apart;
    return is_crossing(simplex_a, simplex_b) ? Relation::crossing : Relation::touching;
}

bool intersects(const OracleMesh& a, const OracleMesh& b) {
    PairWalk walk(a.impl(), b.impl());
    return walk.next();
}

Relation relation(const OracleMesh& a, const OracleMesh& b) {
    Relation strongest = Relation::apart;
    PairWalk walk(a.impl(), b.impl());
    while (strongest != Relation::crossing && walk.next()) strongest = walk.relation();
    return strongest;
}

Verdict verdict(const OracleMesh& a, const OracleMesh& b) {
    Verdict verdict;
    PairWalk walk(a.impl(), b.impl());
    while (walk.next()) {
        verdict.triangles.push_back(walk.pair());
        if (verdict.relation != Relation::crossing) verdict.relation = walk.relation();
    }
    return verdict;
}

std::vector<TrianglePair> intersecting_triangles(const OracleMesh& a, const OracleMesh& b) {
    std::vector<TrianglePair> pairs;
    PairWalk walk(a.impl(), b.impl());
    while (walk.next()) pairs.push_back(walk.pair());
    return pairs;
}

}  // namespace ecods::oracle
