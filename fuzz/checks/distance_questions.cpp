#include "fuzz/checks/distance_questions.hpp"

#include "fuzz/base/failure.hpp"
#include "fuzz/checks/any_pair.hpp"
#include "judge/text.hpp"
#include "scenes/random.hpp"

namespace ecods::fuzz {
namespace {

constexpr std::size_t pairs_a_frame = 2;
// Pairs of triangles; the oracle judges some thousand of them in a millisecond.
constexpr std::size_t triangle_pairs_max = 100000;

}  // namespace

void DistanceQuestions::choose(const World& world, const Truth& truth, std::uint32_t seed) {
    chosen_.clear();
    const AnyPair pairs(world, truth);
    scenes::Random random(seed);
    for (std::size_t i = 0; i < pairs_a_frame; ++i) {
        const auto pair = pairs.draw(random, triangle_pairs_max);
        if (!pair) continue;
        const auto& [a, b] = *pair;
        const auto shape_a = surface_shape(world.shape(a->id)), shape_b = surface_shape(world.shape(b->id));
        const Posed<MeshShape> posed_a(*shape_a, a->pose), posed_b(*shape_b, b->pose);
        const bool asks_all = random.below(4) == 0;
        chosen_.push_back({shape_a, shape_b,
                           judge::DistanceTruth(posed_a, posed_b, {.has_bounds = asks_all, .has_lists = asks_all})});
    }
}

void DistanceQuestions::check(Counters& counters) {
    for (const Chosen& chosen : chosen_) {
        ++counters["checked: distances of bodies"];
        ++counters["distances: " + judge::text(chosen.truth.closest().kind)];
        const auto wrong = chosen.truth.ask(memory_, witness_);
        if (wrong)
            throw CheckFailed(wrong->question.substr(0, wrong->question.find(" 0x")), wrong->expected, wrong->got);
    }
}

}  // namespace ecods::fuzz
