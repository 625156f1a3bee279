#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "fuzz/pairs/ask_distances.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "judge/text.hpp"

namespace ecods::fuzz {
namespace {

using judge::DistanceTruth;
using judge::Wrong;
using scenes::DistanceCase;
using scenes::Random;
using Judged = judge::Judged<DistanceCase>;

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
    using CaseRun::CaseRun;

    void check_one() {
        DistanceCase made = next_family(scenes::distance_families()).make(random_);
        if (has_wrong_recipe_ && made.distance) *made.distance = std::nextafter(*made.distance, HUGE_VAL);
        const bool asks_all = random_.below(8) == 0;
        const Judged judged(made, {.has_bounds = asks_all, .has_lists = asks_all});
        take(made, judged.truth);
        if (const double d = judged.truth.distance(); lie_ && d != 0) {
            fail({"distance", judge::text(std::nextafter(d, HUGE_VAL)), judge::text(d)}, made, "a lie");
        }
        require_answers(made, judged, asks_all ? "all questions" : "distance, within and closest");
        if (random_.below(4) == 0) require_answers_in_environment(made, judged);
        if (random_.below(2) == 0) require_in_environment(made, [&] { return ask_triangles(made, random_); });
        if (random_.below(8) == 0) check_order(made, judged.truth);
        ++index_;
    }

  private:
    void check_order(const DistanceCase& made, const DistanceTruth& truth) {
        const MeshShape a(shuffled(*made.a, random_)), b(shuffled(*made.b, random_));
        const double d = distance({a, made.pose_a}, {b, made.pose_b}, {memory_, witness_});
        std::optional<Wrong> wrong;
        if (!judge::same_bits(d, truth.distance())) {
            wrong = Wrong{"distance", judge::text(truth.distance()), judge::text(d)};
        }
        require(wrong, made, "triangles and corners in another order");
    }
};

}  // namespace

void run_distances(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 1000, &Run::check_one);
}

}  // namespace ecods::fuzz
