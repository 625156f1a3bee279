#include "judge/both_turn_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "judge/text.hpp"
#include "judge/turn_truth.hpp"
#include "oracle/float_environment.hpp"
#include "oracle/turn_subdivision.hpp"

namespace ecods::judge {

// The limit is compared with the real time.
BothTurnTruth::BothTurnTruth(const Turning<MeshShape>& a, const Turning<MeshShape>& b)
    : of_a_(turning_soup(a)), of_b_(turning_soup(b)) {
    exact_ = oracle::first_contact(of_a_, of_b_);
    add("cast", a, b, 1, exact_);
    auto swapped = exact_;
    if (swapped) {
        std::swap(swapped->a, swapped->b_first);
        std::swap(swapped->b, swapped->a_second);
    }
    add("cast, swapped", b, a, 1, swapped);
    if (!exact_) return;
    const oracle::FloatEnvironment environment;
    const double time = exact_->rounded;
    for (const double limit : {time, time > 0 ? neighbour(time, -1) : 0, time / 2, std::min(1.0, neighbour(time, 1))}) {
        const bool is_within = exact_->time.compare(mpq_class(limit)) <= 0;
        add(fmt::format("cast up to {:a}", limit), a, b, limit, is_within ? exact_ : std::nullopt);
    }
}

void BothTurnTruth::add(const std::string& name, const Turning<MeshShape>& a, const Turning<MeshShape>& b,
                        double max_time, const std::optional<oracle::ExactContact>& expected) {
    questions_.push_back({name, [=](const Ask& ask) { return cast(a, b, max_time, ask); }, to_first_contact(expected)});
}

std::optional<std::string> BothTurnTruth::contradiction() const {
    return oracle::contradiction(oracle::TurnSubdivision(of_a_, of_b_), exact_);
}

}  // namespace ecods::judge
