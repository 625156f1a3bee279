#include "fuzz/pairs/distances.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "fuzz/pairs/ask_distances.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "judge/distance_truth.hpp"
#include "scenes/distance_cases.hpp"

namespace ecods::fuzz {
namespace {

using judge::DistanceTruth;
using judge::Wrong;
using scenes::DistanceCase;
using scenes::Random;

// The same triangles, and the corners of each, in another order.
std::shared_ptr<const Mesh> shuffled(const Mesh& mesh, Random& random) {
    std::vector<Triangle> triangles(mesh.triangles().begin(), mesh.triangles().end());
    for (std::size_t i = triangles.size(); i > 1; --i) {
        std::swap(triangles[i - 1], triangles[random.below(static_cast<std::uint32_t>(i))]);
    }
    for (Triangle& triangle : triangles) {
        std::rotate(triangle.begin(), triangle.begin() + random.below(3), triangle.end());
        if (random.below(2) == 0) std::swap(triangle[0], triangle[1]);
    }
    return Mesh::create({mesh.vertices().begin(), mesh.vertices().end()}, std::move(triangles));
}

class Run : CaseRun {
  public:
    Run(std::uint32_t seed, Lie lie, DistanceCounts& counts) : CaseRun(seed, lie, counts.checks), counts_(counts) {}

    void check_one() {
        const auto families = scenes::distance_families();
        const scenes::DistanceFamily family = families[index_ % families.size()];
        family_ = scenes::name(family);
        const DistanceCase made = scenes::make_distance_case(family, random_);
        const MeshShape a(made.a), b(made.b);
        const bool asks_all = random_.below(8) == 0;
        const DistanceTruth truth({a, made.pose_a}, {b, made.pose_b}, {.has_bounds = asks_all, .has_lists = asks_all});
        ++counts_.distances;
        ++counts_.kinds[family_][static_cast<std::size_t>(truth.closest().kind)];
        require_recipe(made, truth);
        if (lie_) lie(made, truth);
        require_answers(made, truth, asks_all ? "all questions" : "distance, within and closest");
        if (random_.below(4) == 0) require_in_environment(made, [&] { return truth.ask(memory_, witness_); });
        if (random_.below(2) == 0) require_in_environment(made, [&] { return ask_triangles(made, random_); });
        if (random_.below(8) == 0) check_order(made, truth);
        ++index_;
    }

  private:
    void require_recipe(const DistanceCase& made, const DistanceTruth& truth) const {
        if (!made.distance) return;
        const double promised = has_wrong_recipe_ ? std::nextafter(*made.distance, HUGE_VAL) : *made.distance;
        require_known(promised == truth.distance(), "distance " + judge::text(promised), judge::text(truth.distance()),
                      made);
    }

    void lie(const DistanceCase& made, const DistanceTruth& truth) {
        if (truth.distance() == 0) return;
        const double next = std::nextafter(truth.distance(), HUGE_VAL);
        require(Wrong{"distance", judge::text(next), judge::text(truth.distance())}, made, "a lie");
    }

    // With a memory that other queries have used, and a witness of other bodies.
    void require_answers(const DistanceCase& made, const DistanceTruth& truth, const char* how) {
        require(truth.ask(memory_, witness_), made, how);
    }

    void check_order(const DistanceCase& made, const DistanceTruth& truth) {
        const MeshShape a(shuffled(*made.a, random_)), b(shuffled(*made.b, random_));
        const double d = distance({a, made.pose_a}, {b, made.pose_b}, memory_, witness_);
        const bool is_same = std::bit_cast<std::uint64_t>(d) == std::bit_cast<std::uint64_t>(truth.distance());
        require(
            is_same ? std::nullopt : std::optional(Wrong{"distance", judge::text(truth.distance()), judge::text(d)}),
            made, "triangles and corners in another order");
    }

    DistanceCounts& counts_;
    QueryMemory memory_;
    PairWitness witness_;
};

}  // namespace

void run_distances(std::uint32_t seed, Lie lie, DistanceCounts& counts) {
    Run run(seed, lie, counts);
    for (std::uint64_t i = 0; i < distances_per_run; ++i) run.check_one();
}

}  // namespace ecods::fuzz
