#include "judge/turn_and_straight_truth.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "ecods/turn.hpp"
#include "judge/text.hpp"
#include "judge/turn_truth.hpp"
#include "oracle/float_environment.hpp"
#include "oracle/turn_subdivision.hpp"

namespace ecods::judge {
namespace {

oracle::TurningSoup soup_of(const Posed<MeshShape>& a, const Motion& motion) {
    if (const auto* const turn = std::get_if<Turn>(&motion)) return turning_soup({*a.what, a.pose, *turn});
    return turning_soup({*a.what, a.pose, Turn{{}, Vec3::Zero(), std::get<Translation>(motion).by}});
}

// A turn comes first whatever the order is; of a translation and a straight motion, the first one does.
std::optional<oracle::ExactContact> in_other_order(std::optional<oracle::ExactContact> exact, bool turns) {
    if (!exact) return exact;
    if (turns) {
        std::swap(exact->a, exact->b);
    } else {
        std::swap(exact->a, exact->b_first);
        std::swap(exact->b, exact->a_second);
    }
    return exact;
}

}  // namespace

// The limit is compared with the real time.
TurnAndStraightTruth::TurnAndStraightTruth(const Posed<MeshShape>& a, const Motion& motion_of_a,
                                           const Moving<MeshShape>& b)
    : a_(a),
      b_(*b.what, b.from),
      motion_of_a_(motion_of_a),
      motion_of_b_(Straight{b.to}),
      of_a_(soup_of(a, motion_of_a)),
      of_b_{soup(b_), b.to} {
    exact_ = oracle::first_contact(of_a_, of_b_);
    const auto contact = to_first_contact(exact_),
               other = to_first_contact(in_other_order(exact_, std::holds_alternative<Turn>(motion_of_a)));
    add("cast", 1, contact, other);
    if (!exact_) return;
    const oracle::FloatEnvironment environment;
    const double time = exact_->rounded;
    for (const double limit : {time, time > 0 ? neighbour(time, -1) : 0, time / 2, std::min(1.0, neighbour(time, 1))}) {
        const bool is_within = exact_->time.compare(mpq_class(limit)) <= 0;
        add(fmt::format("cast up to {:a}", limit), limit, is_within ? contact : std::nullopt,
            is_within ? other : std::nullopt);
    }
}

void TurnAndStraightTruth::add(const std::string& name, double max_time, const std::optional<FirstContact>& expected,
                               const std::optional<FirstContact>& swapped) {
    questions_.push_back({name,
                          [=, a = a_, b = b_, of_a = motion_of_a_, of_b = motion_of_b_](const Ask& ask) {
                              return cast(a, of_a, b, of_b, max_time, ask);
                          },
                          expected});
    questions_.push_back({name + ", swapped",
                          [=, a = a_, b = b_, of_a = motion_of_a_, of_b = motion_of_b_](const Ask& ask) {
                              return cast(b, of_b, a, of_a, max_time, ask);
                          },
                          swapped});
}

std::optional<std::string> TurnAndStraightTruth::contradiction() const {
    return oracle::contradiction(oracle::TurnSubdivision(of_a_, of_b_), exact_);
}

}  // namespace ecods::judge
