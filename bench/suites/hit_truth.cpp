#include "suites/hit_truth.hpp"

#include <algorithm>
#include <deque>
#include <utility>

#include "ecods/world.hpp"
#include "harness/turns.hpp"
#include "judge/hit_truth.hpp"

namespace ecods::bench {

namespace {

// The library's hits: a world's where there are several bodies.
class Hits {
  public:
    explicit Hits(const scenes::SegmentWorkload& workload)
        : workload_(workload), shape_(workload.meshes.front().mesh), first_triangles_(first_triangles(workload)) {
        if (workload.bodies.size() == 1) return;
        for (const scenes::MeshAt& body : workload.bodies)
            bodies_.push_back(world_.create_body(workload.meshes[body.mesh_index].mesh, body.pose));
        world_.update();
    }

    std::vector<Hit> of(const Segment& segment) {
        if (bodies_.empty()) return all_hits(segment, {shape_, workload_.bodies.front().pose}, memory_);
        std::vector<Hit> hits;
        for (const BodyHit& of_body : world_.all_hits(segment, memory_)) {
            const auto body = std::lower_bound(bodies_.begin(), bodies_.end(), of_body.body);
            hits.push_back(of_body.hit);
            hits.back().feature.triangle += first_triangles_[static_cast<std::size_t>(body - bodies_.begin())];
        }
        return hits;
    }

  private:
    const scenes::SegmentWorkload& workload_;
    MeshShape shape_;
    World world_;
    std::vector<BodyId> bodies_;  // ascending
    std::vector<std::uint32_t> first_triangles_;
    QueryMemory memory_;
};

// Whether they may meet: doubtful ones do.
bool is_near(const Segment& segment, const Vec3& middle, double radius) {
    const Vec3 arm = segment.b - segment.a, to = middle - segment.a;
    const double along = arm.squaredNorm() > 0 ? std::clamp(to.dot(arm) / arm.squaredNorm(), 0.0, 1.0) : 0;
    return (to - along * arm).norm() <= 1.01 * radius + 0.01;
}

// Farther from its origin no vertex of the mesh is.
double reach_of(const Mesh& mesh) {
    double reach = 0;
    for (const Vec3& v : mesh.vertices()) reach = std::max(reach, v.norm());
    return reach;
}

// Of all bodies, as the library writes it.
std::vector<Hit> ask_oracle(const scenes::SegmentWorkload& workload, const Segment& segment) {
    const std::vector<std::uint32_t> firsts = first_triangles(workload);
    std::deque<MeshShape> shapes;
    std::vector<double> reaches;
    for (const scenes::NamedMesh& named : workload.meshes) {
        shapes.emplace_back(named.mesh);
        reaches.push_back(reach_of(*named.mesh));
    }
    std::vector<oracle::ExactHit> all;
    for (std::size_t i = 0; i < workload.bodies.size(); ++i) {
        const auto& [mesh_index, pose] = workload.bodies[i];
        if (!is_near(segment, pose.t, reaches[mesh_index])) continue;
        for (oracle::ExactHit& hit : judge::exact_hits(segment, {shapes[mesh_index], pose})) {
            hit.feature.triangle += firsts[i];
            all.push_back(std::move(hit));
        }
    }
    std::ranges::stable_sort(all, {}, &oracle::ExactHit::enter);
    for (std::size_t i = 0; i < all.size(); ++i) {
        const bool is_tie = i > 0 && all[i].enter == all[i - 1].enter;
        all[i].rank = i == 0 ? 0 : all[i - 1].rank + (is_tie ? 0 : 1);
    }
    return judge::to_hits(all);
}

}  // namespace

std::size_t HitTruth::hit_segment_count() const {
    return static_cast<std::size_t>(
        std::count_if(lists.begin(), lists.end(), [](const std::vector<Hit>& list) { return !list.empty(); }));
}

HitTruth find_hits(const scenes::SegmentWorkload& workload, std::size_t judged_count) {
    Hits hits(workload);
    HitTruth truth;
    const std::size_t count = workload.segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        truth.lists.push_back(hits.of(workload.segments[i]));
        if (!is_chosen(i, count, std::min(judged_count, count))) continue;
        ++truth.judged_count;
        const auto is_same = [](const Hit& x, const Hit& y) { return judge::is_same(x, y); };
        if (!std::ranges::equal(truth.lists.back(), ask_oracle(workload, workload.segments[i]), is_same))
            ++truth.wrong_count;
    }
    return truth;
}

}  // namespace ecods::bench
