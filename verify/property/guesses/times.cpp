// The times at which nodes and triangles may first share a point: of a body that is translated, in windows of any
// length; of two that go from pose to pose, from any time on and up to any; and the features that may meet then.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/next.hpp"
#include "base/outward.hpp"
#include "bvh/axes/motion_axes.hpp"
#include "bvh/axes/swept_axes.hpp"
#include "exact/measure/contact/bound_meeting.hpp"
#include "exact/measure/contact/possible_features.hpp"
#include "oracle/first_contact.hpp"
#include "property/guesses/features.hpp"
#include "property/guesses/soups.hpp"
#include "query/cast/moving_pairs.hpp"

namespace ecods::guesses {
namespace {

using Contact = std::optional<oracle::ExactContact>;

// The first of all pairs, and those of each.
struct Contacts {
    std::vector<Contact> contacts;

    template <class Find>
    Contacts(const Trees& trees, const Find& find) {
        for (std::uint32_t i = 0; i < trees.count_a; ++i) {
            for (std::uint32_t j = 0; j < trees.count_b; ++j) contacts.push_back(find(i, j));
        }
    }
    bool is_any_up_to(double time) {
        return std::ranges::any_of(contacts, [&](Contact& c) { return c && c->time.compare(mpq_class(time)) <= 0; });
    }
};

// Lower bounds of times, infinite for pairs that the walk does not come to.
template <class Mask>
std::vector<float> bounds_of(const Trees& trees, const Mask& mask) {
    std::vector<float> result(trees.pair_count(), std::numeric_limits<float>::infinity());
    alignas(32) LaneBounds times;
    trees.reached([&](const auto& x, const auto& y) {
        const std::uint64_t found = mask(x, y, times);
        if constexpr (both_leaves<std::remove_cvref_t<decltype(x)>, std::remove_cvref_t<decltype(y)>>) {
            for (LanePairs lanes(found); lanes.more(); lanes.next()) {
                result[trees.number(x.triangle[lanes.i()], y.triangle[lanes.j()])] =
                    times[tree_width * lanes.i() + lanes.j()];
            }
        }
        return found;
    });
    return result;
}

}  // namespace

void ask_swept(Case& c) {
    const Trees trees(c.random, c.random.below(6) == 0 ? 12 : 4);
    const Bodies& bodies = trees.bodies;
    const Vec3 motion = some_motion(c.random, bodies);
    Contacts truth(trees, [&](std::uint32_t i, std::uint32_t j) {
        return oracle::first_contact(soup_of(*bodies.a, bodies.pose_a, i), motion,
                                     soup_of(*bodies.b, bodies.pose_b, j));
    });
    // A window up to 1, up to a time, or to one at which a pair meets.
    double latest = c.random.below(2) == 0 ? 1 : c.random.uniform(0, 1);
    const Contact& some = truth.contacts[c.random.below(static_cast<std::uint32_t>(truth.contacts.size()))];
    if (some && c.random.below(2) == 0) latest = some->rounded;
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        std::vector<float> bounds, limits;
        const bool may_meet = in_mode(mode, [&] {
            SweptAxes axes;
            if (!axes.bind(trees.posed_a(), trees.posed_b(), trees.d(), motion, latest)) return false;
            const float limit = axes.window_above(latest);
            bounds = bounds_of(trees, [&](const auto& x, const auto& y, LaneBounds& times) {
                return swept_mask(axes.sets(), limit, x, y, times);
            });
            for (const Contact& contact : truth.contacts)
                limits.push_back(contact ? axes.window_above(contact->rounded) : 0);
            return true;
        });
        if (!may_meet) {
            c.require(!truth.is_any_up_to(latest), "roots that meet are said not to", where);
            ++c.tally.telling;
            return;
        }
        for (std::size_t k = 0; k < bounds.size(); ++k) {
            const bool meets = truth.contacts[k] && truth.contacts[k]->rounded <= latest;
            c.require(!meets || bounds[k] <= limits[k], "a bound above the time of contact, or a pair is dropped",
                      where);
            c.tally.telling += bounds[k] > 0;
        }
    });
}

namespace {

// Two bodies from pose to pose.
struct Moves {
    Pose to_a, to_b;

    Moves(Random& random, const Bodies& bodies) {
        const Vec3 way = some_motion(random, bodies);
        const double share = random.uniform(0, 1);
        to_a = some_end(random, bodies.pose_a, share * way);
        to_b = random.below(2) == 0 ? some_end(random, bodies.pose_b, (share - 1) * way) : bodies.pose_b;
    }
    Contact contact(const Bodies& bodies, std::uint32_t i, std::uint32_t j) const {
        return oracle::first_contact(oracle::MovingSoup{soup_of(*bodies.a, bodies.pose_a, i), to_a},
                                     oracle::MovingSoup{soup_of(*bodies.b, bodies.pose_b, j), to_b});
    }
};

}  // namespace

void ask_meeting(Case& c) {
    const Trees trees(c.random, c.random.below(6) == 0 ? 10 : 3);
    const Bodies& bodies = trees.bodies;
    const Moves moves(c.random, bodies);
    Contacts truth(trees, [&](std::uint32_t i, std::uint32_t j) { return moves.contact(bodies, i, j); });
    const std::size_t some = c.random.below(static_cast<std::uint32_t>(truth.contacts.size()));
    for_each_set_and_mode([&](const environment::FloatMode& mode, const std::string& where) {
        std::vector<float> bounds;
        std::vector<bool> at_limit;
        in_mode(mode, [&] {
            MotionAxes axes;
            axes.bind({trees.a, bodies.pose_a.R, moves.to_a.R}, {trees.b, bodies.pose_b.R, moves.to_b.R}, trees.d(),
                      moves.to_b.t - moves.to_a.t);
            const auto mask_up_to = [&](float limit) {
                return [&axes, limit](const auto& x, const auto& y, LaneBounds& times) {
                    return meeting_mask(axes.sets(), limit, NodeAtEnds(x, x), NodeAtEnds(y, y), times);
                };
            };
            bounds = bounds_of(trees, mask_up_to(1));
            if (!truth.contacts[some]) return;
            alignas(32) LaneBounds times;
            const auto mask = mask_up_to(round_up(truth.contacts[some]->rounded));
            at_limit = trees.reached([&](const auto& x, const auto& y) { return mask(x, y, times); });
        });
        for (std::size_t k = 0; k < bounds.size(); ++k) {
            Contact& contact = truth.contacts[k];
            c.require(!contact || (std::isfinite(bounds[k]) && contact->time.compare(mpq_class(bounds[k])) >= 0),
                      "a bound above the time of contact, or a pair is dropped", where);
            c.tally.telling += bounds[k] > 0;
        }
        if (truth.contacts[some]) c.require(at_limit[some], "a pair that meets at the limit is dropped", where);
    });
}

namespace {

using namespace exact;

// The rounded corners of the two triangles, with the bounds that a frame gives.
class RoundedCorners {
  public:
    RoundedCorners(const Bodies& bodies, const Moves& moves)
        : bodies_(bodies), moves_(moves), extent_a_(measure(*bodies.a)), extent_b_(measure(*bodies.b)) {}

    MovingPoints points() {
        const std::array<BodyRef, 4> all{{{bodies_.a.get(), &extent_a_, &bodies_.pose_a},
                                          {bodies_.b.get(), &extent_b_, &bodies_.pose_b},
                                          {bodies_.a.get(), &extent_a_, &moves_.to_a},
                                          {bodies_.b.get(), &extent_b_, &moves_.to_b}}};
        frame_.bind(all);
        MovingPoints result;
        for (std::size_t body = 0; body < 4; ++body) {
            for (std::uint32_t i = 0; i < 3; ++i) {
                (body < 2 ? result.start : result.end)[3 * (body % 2) + i] = frame_.rounded(body, i);
            }
        }
        result.start_error = std::max(frame_.delta(0), frame_.delta(1));
        result.end_error = std::max(frame_.delta(2), frame_.delta(3));
        return result;
    }

  private:
    const Bodies& bodies_;
    const Moves& moves_;
    MeshExtent extent_a_, extent_b_;
    Frame frame_;
};

// Times about the contact: from one that is not after it, to one that is not before it.
TimeSpan around(Random& random, oracle::Root& time) {
    const double t = time.nearest();
    const double below = time.compare(mpq_class(t)) >= 0 ? t : next_down(t), above = below == t ? next_up(t) : t;
    const double shares[] = {0, 0.5 * below, below, std::max(0.0, below - some_power(random, -60, -2))};
    const double ends[] = {1, above, above + 0.5 * (1 - above), above + some_power(random, -60, -2)};
    return {std::max(0.0, shares[random.below(4)]), std::min(1.0, ends[random.below(4)])};
}

// Asks about the corners as they are rounded, as exact ones: no error of a pose hides those of the bound.
void ask_rounded(Case& c, MovingPoints points) {
    points.start_error = points.end_error = 0x1p-1000;
    const auto mesh = Mesh::create({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2}});
    const auto soup = [&](const Points<6>& at, std::size_t side, Pose& pose) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Point& p = at[3 * side + i];
            pose.R.col(static_cast<Eigen::Index>(i)) = Vec3(p[0], p[1], p[2]);
        }
        return soup_of(*mesh, pose);
    };
    Pose poses[4];
    const auto moving = [&](std::size_t side) {
        soup(points.end, side, poses[2 + side]);
        return oracle::MovingSoup{soup(points.start, side, poses[side]), poses[2 + side]};
    };
    const auto a = moving(0), b = moving(1);
    for (const Pose& pose : poses) {
        if (!pose.R.allFinite()) return;
    }
    Contact contact = oracle::first_contact(a, b);
    if (!contact) return;
    for_each_mode([&](const environment::FloatMode& mode) {
        for (const Effort effort : {Effort::coarse, Effort::fine}) {
            const TimeSpan time = around(c.random, contact->time);
            const auto bound = in_mode(mode, [&] { return bound_first_meeting(points, time.from, time.to, effort); });
            c.require(bound && contact->time.compare(mpq_class(bound->from)) >= 0,
                      "a bound above the time of exact corners", mode.name);
            c.tally.telling += bound && bound->from > time.from;
        }
    });
}

}  // namespace

void ask_moving(Case& c) {
    const Bodies bodies = some_bodies(c.random, 1);
    const Moves moves(c.random, bodies);
    Contact contact = moves.contact(bodies, 0, 0);
    const MeshShape a(bodies.a), b(bodies.b);
    const Moving<MeshShape> moving_a{a, bodies.pose_a, moves.to_a}, moving_b{b, bodies.pose_b, moves.to_b};
    const MeshAtEnds ends_a(moving_a), ends_b(moving_b);
    RoundedCorners corners(bodies, moves);
    ask_rounded(c, corners.points());
    for_each_mode([&](const environment::FloatMode& mode) {
        for (const Effort effort : {Effort::coarse, Effort::fine}) {
            TimeSpan time{0, c.random.below(2) == 0 ? 1 : c.random.uniform(0, 1)};
            if (contact) time = around(c.random, contact->time);
            const auto bound = in_mode(mode, [&] {
                CastCounts counts;
                MovingPairs pairs;
                pairs.bind(ends_a, ends_b, counts);
                return pairs.bound({0, 0}, time.from, time.to, effort);
            });
            c.require(bound || !contact, "triangles that meet are said not to", mode.name);
            c.tally.telling += !bound;
            if (!bound) continue;
            // A mode that flushes takes subnormal times for zero, which is earlier.
            const auto is_from = [&](double x, double least) { return x >= least || least < 0x1p-1022; };
            c.require(is_from(bound->from, time.from) && is_from(time.to, bound->to) && is_from(bound->to, bound->from),
                      "no part of the times", mode.name);
            c.require(!contact || contact->time.compare(mpq_class(bound->from)) >= 0, "a bound above the time",
                      mode.name);
            c.tally.telling += bound->from > time.from;
        }
        if (!contact || contact->kind == oracle::Closeness::intersecting) return;
        TimeSpan time = around(c.random, contact->time);
        const double t = contact->time.nearest();
        time.from = std::max(time.from, next_down(t - 0x1p-22));
        time.to = std::min(time.to, next_up(t + 0x1p-22));
        const FeatureSet features = in_mode(mode, [&] { return possible_features(corners.points(), time); });
        for (std::size_t k = 0; k < feature_pairs.size(); ++k) {
            if (!are_features(feature_pairs[k], *contact)) continue;
            c.require((features >> k & 1) != 0, "features that meet are said not to", mode.name);
            c.tally.telling += features != all_features;
        }
    });
}

}  // namespace ecods::guesses
