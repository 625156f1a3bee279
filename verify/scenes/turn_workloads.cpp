#include "scenes/turn_workloads.hpp"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <utility>

#include "ecods/intersection.hpp"
#include "scenes/approach.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::scenes {

namespace {

double dot(const Vec3& a, const Vec3& b) {
    return (a.x() * b.x() + a.y() * b.y()) + a.z() * b.z();
}

class Turns {
  public:
    Turns(NamedMesh mesh, std::uint32_t seed)
        : mesh_(std::move(mesh)), random_(seed), approach_(mesh_.mesh, mesh_.mesh) {}

    TurnWorkload workload(const std::string& end, int degrees, double beyond, std::size_t count) {
        TurnWorkload workload{mesh_.name + ", " + std::to_string(degrees) + " degrees, " + end, {mesh_}, {}};
        while (workload.queries.size() < count) {
            if (const auto query = draw(degrees * std::numbers::pi / 180, beyond)) workload.queries.push_back(*query);
        }
        return workload;
    }

  private:
    // Turns back from the end, at which the middle of a goes against the line.
    std::optional<TurnQuery> draw(double angle, double beyond) {
        approach_.resting = random_.rotation().toRotationMatrix();
        approach_.moving = random_.rotation().toRotationMatrix();
        const Vec3 line = approach_.line = random_.direction(), any = random_.direction();
        const double diameter = approach_.diameter();
        const auto stop = approach_.stop_at(1e-4 * diameter);
        const Vec3 across = any - dot(any, line) * line;
        if (!stop || dot(across, across) < 0.01) return std::nullopt;
        const double distance = *stop - beyond * diameter;
        const MeshQuery end = approach_.at(distance);
        const Vec3 aside = across / std::sqrt(dot(across, across)), axis = line.cross(aside);
        const Vec3 pivot = distance * line - diameter * aside;
        TurnQuery query{end.b, end.a, about(axis, angle, pivot), Pose()};
        query.a.pose = pose_at(end.b.pose, about(axis, -angle, pivot), 1);
        query.a_end = pose_at(query.a.pose, query.turn, 1);
        if (intersects({shape_, query.a.pose}, {shape_, query.b.pose}, memory_)) return std::nullopt;
        return query;
    }

    NamedMesh mesh_;
    Random random_;
    Approach approach_;
    MeshShape shape_{mesh_.mesh};
    QueryMemory memory_;
};

}  // namespace

std::vector<TurnWorkload> turn_workloads(WorkloadSize size) {
    const bool is_tiny = size == WorkloadSize::tiny;
    struct Case {
        NamedMesh mesh;
        std::size_t count;
    };
    std::vector<Case> cases = {{{"torus 320", torus(16, 10, 0.4)}, 40}};
    if (!is_tiny) {
        cases.push_back({{"ship", ship()}, 40});
        cases.push_back({{"torus 1280", torus(32, 20, 0.4)}, 20});
        cases.push_back({{"torus 5000", torus(50, 50, 0.4)}, 12});
        cases.push_back({{"torus 100k", torus(400, 125, 0.4)}, 12});
    }
    std::vector<TurnWorkload> workloads;
    for (const auto& [mesh, full_count] : cases) {
        const std::size_t count = is_tiny ? 2 : full_count;
        for (const int degrees : {30, 90}) {
            Turns turns(mesh, 23);
            workloads.push_back(turns.workload("into contact", degrees, 0.05, count));
            workloads.push_back(turns.workload("to a gap of 1e-4", degrees, 0, count));
        }
    }
    return workloads;
}

}  // namespace ecods::scenes
