// Who meets on the way, against the oracle.
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "check_oracle.hpp"
#include "judge/cast_truth.hpp"
#include "judge/text.hpp"
#include "oracle/first_contact.hpp"

namespace ecods::check {

void OracleJudge::check_meetings(const SceneWorld& world, const FrameAnswer& answer) {
    if (answer.frame == 0) return;
    for (std::size_t a = 0; a < scene_.bodies.size(); ++a) {
        for (std::size_t b = a + 1; b < scene_.bodies.size(); ++b) {
            ++report_.moves;
            const auto way_of = [&](std::size_t body) {
                oracle::Soup before = judge::soup(world.posed(body));
                before.pose = world.pose_before(body);
                return oracle::MovingSoup{before, world.pose(body)};
            };
            const auto exact = judge::to_first_contact(oracle::first_contact(way_of(a), way_of(b)));
            const auto listed = std::ranges::find_if(
                answer.meetings, [&](const MeetingAnswer& pair) { return pair.a == a && pair.b == b; });
            const auto found = listed == answer.meetings.end() ? std::nullopt : std::optional(listed->contact);
            if (judge::is_same(found, exact)) continue;
            differ(answer, scene_.bodies[a].name + ", " + scene_.bodies[b].name,
                   fmt::format("on the way {}, but exactly {}", judge::text(found), judge::text(exact)));
        }
    }
}

void OracleJudge::check_casts(const SceneWorld& world, const FrameAnswer& answer) {
    for (std::size_t a = 0; a < scene_.bodies.size(); ++a) {
        if (!scene_.bodies[a].motion) continue;
        ++report_.moves;
        std::optional<FirstContact> first;
        std::size_t met = 0;
        for (std::size_t b = 0; b < scene_.bodies.size(); ++b) {
            if (b == a) continue;
            const auto exact = judge::to_first_contact(oracle::first_contact(
                judge::soup(world.posed(a)), *scene_.bodies[a].motion, judge::soup(world.posed(b))));
            if (!exact || (first && first->time <= exact->time)) continue;
            first = exact;
            met = b;
        }
        const auto listed = std::ranges::find_if(answer.casts, [&](const MeetingAnswer& cast) { return cast.a == a; });
        const bool is_listed = listed != answer.casts.end();
        const auto found = is_listed ? std::optional(listed->contact) : std::nullopt;
        if (judge::is_same(found, first) && (!is_listed || listed->b == met)) continue;
        differ(answer, scene_.bodies[a].name,
               fmt::format("cast, {}, but exactly {}", judge::text(found), judge::text(first)));
    }
}

}  // namespace ecods::check
