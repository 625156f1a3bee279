// Who meets on the way, against the oracle.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "check_oracle.hpp"
#include "judge/cast_truth.hpp"
#include "judge/text.hpp"
#include "judge/turn_truth.hpp"
#include "oracle/first_contact.hpp"
#include "oracle/turn_subdivision.hpp"

namespace ecods::check {
namespace {

// First times of turns of so few pairs of triangles are proven a second time, by pieces of the time.
constexpr std::size_t proven_pairs_max = 64;

std::optional<MeetingAnswer> find(const std::vector<MeetingAnswer>& list, std::size_t a, std::optional<std::size_t> b) {
    const auto listed =
        std::ranges::find_if(list, [&](const MeetingAnswer& pair) { return pair.a == a && (!b || pair.b == *b); });
    return listed == list.end() ? std::nullopt : std::optional(*listed);
}

std::size_t count_of(const oracle::Soup& soup) {
    return soup.triangles.size();
}
std::size_t count_of(const oracle::MovingSoup& soup) {
    return soup.from.triangles.size();
}
std::size_t count_of(const oracle::TurningSoup& soup) {
    return soup.from.triangles.size();
}

std::optional<FirstContact> contact_of(const std::optional<MeetingAnswer>& listed) {
    return listed ? std::optional(listed->contact) : std::nullopt;
}

}  // namespace

void OracleJudge::check_meetings(const SceneWorld& world, const FrameAnswer& answer) {
    if (answer.frame == 0) return;
    for (std::size_t a = 0; a < scene_.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < scene_.bodies.size(); ++b) {
            const bool is_turned_second = !world.turn(a) && world.turn(b);
            is_turned_second ? check_meeting(world, answer, b, a) : check_meeting(world, answer, a, b);
        }
    }
}

// If one of two bodies turns, it is the first one.
void OracleJudge::check_meeting(const SceneWorld& world, const FrameAnswer& answer, std::size_t a, std::size_t b) {
    ++report_.moves;
    const std::string bodies = scene_.bodies[a].name + ", " + scene_.bodies[b].name;
    const auto before = [&](std::size_t body) {
        return judge::soup<MeshShape>({*world.posed(body).what, world.pose_before(body)});
    };
    const auto way_of = [&](std::size_t body) { return oracle::MovingSoup{before(body), world.pose(body)}; };
    const auto turned = [&](std::size_t body) {
        return judge::turning_soup({*world.posed(body).what, world.pose_before(body), *world.turn(body)});
    };
    const bool rests = world.pose_before(b) == world.pose(b);
    const auto exact = !world.turn(a)  ? judge::to_first_contact(oracle::first_contact(way_of(a), way_of(b)))
                       : world.turn(b) ? exact_turn(answer, turned(a), turned(b), bodies)
                       : rests         ? exact_turn(answer, turned(a), before(b), bodies)
                                       : exact_turn(answer, turned(a), way_of(b), bodies);
    const auto found = contact_of(find(answer.meetings, a, b));
    if (judge::is_same(found, exact)) return;
    differ(answer, bodies, fmt::format("on the way {}, but exactly {}", judge::text(found), judge::text(exact)));
}

// The other body rests, goes straight, or turns.
template <class Other>
std::optional<FirstContact> OracleJudge::exact_turn(const FrameAnswer& answer, const oracle::TurningSoup& a,
                                                    const Other& b, const std::string& bodies) {
    const auto exact = oracle::first_contact(a, b);
    const bool is_proven = count_of(a) * count_of(b) <= proven_pairs_max;
    const auto against = is_proven ? oracle::contradiction(oracle::TurnSubdivision(a, b), exact) : std::nullopt;
    if (against) differ(answer, bodies, "the oracle contradicts itself: " + *against);
    return judge::to_first_contact(exact);
}

// What body a with a motion or a turn exactly meets of body b.
std::optional<FirstContact> OracleJudge::exact_cast(const SceneWorld& world, const FrameAnswer& answer, std::size_t a,
                                                    std::size_t b) {
    const scenes::SceneBody& body = scene_.bodies[a];
    const Posed<MeshShape> start = world.posed(a);
    const oracle::Soup other = judge::soup(world.posed(b));
    if (body.motion) return judge::to_first_contact(oracle::first_contact(judge::soup(start), *body.motion, other));
    return exact_turn(answer, judge::turning_soup({*start.what, start.pose, *body.turn}), other, body.name);
}

void OracleJudge::check_casts(const SceneWorld& world, const FrameAnswer& answer) {
    for (std::size_t a = 0; a < scene_.bodies.size(); ++a) {
        if (!scene_.bodies[a].motion && !scene_.bodies[a].turn) continue;
        ++report_.moves;
        std::optional<FirstContact> first;
        std::size_t met = 0;
        for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
            if (b == a) continue;
            const auto exact = exact_cast(world, answer, a, b);
            if (!exact || (first && first->time <= exact->time)) continue;
            first = exact;
            met = b;
        }
        const auto listed = find(answer.casts, a, std::nullopt);
        const auto found = contact_of(listed);
        if (judge::is_same(found, first) && (!listed || listed->b == met)) continue;
        differ(answer, scene_.bodies[a].name,
               fmt::format("cast, {}, but exactly {}", judge::text(found), judge::text(first)));
    }
}

}  // namespace ecods::check
