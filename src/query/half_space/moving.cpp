// Casts bodies that move from pose to pose against half spaces that are translated or at rest.
//
// The height of each vertex is then linear in time, because N does not change. Let c = r |N|, where r is the radius of
// a rounded body, and otherwise 0. A vertex with the height h0 > c at the start and h1 <= c at the end reaches the
// height c at the time (h0 - c) / (h0 - h1), which does not decrease if h0 or h1 grows.
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>

#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "base/next.hpp"
#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "exact/measure/round/round_root_sum.hpp"
#include "exact/number/root_sum.hpp"
#include "geometry/same_bits.hpp"
#include "query/body/posed_body.hpp"
#include "query/half_space/corners_below.hpp"
#include "query/half_space/round.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {
namespace half_spaces {
namespace {

// The factor 1 + slack covers the roundings of a quotient, of its divisor, and of the factor itself, in any rounding
// mode.
constexpr double slack = 0x1p-50;

// Returns bounds of h - c from bounds of h and c. One step outwards covers a rounding. A number flushed to zero is
// covered by the 2^-600 that bounds of heights include (heights.hpp).
HeightBounds above(const HeightBounds& h, const HeightBounds& c) noexcept {
    return {next_down(h.low - c.high), next_up(h.high - c.low)};
}

// TimeBounds are a lower and an upper bound of the time at which a vertex reaches the height c. If bounds of heights
// are infinite, the bounds of the time may be NaN, and then prove nothing.
struct TimeBounds {
    TimeBounds(const HeightBounds& h0, const HeightBounds& h1) noexcept {
        const double from = std::max(h0.low, 0.0), until = std::min(h1.high, 0.0);
        low = from / (from - h1.low) * (1 - slack);
        high = h0.high / (h0.high - until) * (1 + slack);
        if (!(h1.high <= 0) || !(h0.low > 0)) high = std::numeric_limits<double>::infinity();
    }

    double low, high;
};

// A FirstCorner is a corner that reaches the height c first, and its time: a quotient for c = 0, otherwise a sum with a
// root.
struct FirstCorner {
    Corner corner;
    std::optional<Quotient> quotient;
    exact::RootSum root;
};

class MovingHeights {
  public:
    MovingHeights(const Moving<MeshShape>& body, double radius, const Moving<HalfSpace>& half_space)
        : shape_(*boundary_of(Posed<MeshShape>(*body.what, body.from)).what),
          radius_(radius),
          start_plane_({*half_space.what, half_space.from}),
          end_plane_({*half_space.what, half_space.to}),
          start_(start_plane_, body.from),
          end_(end_plane_, body.to),
          reach_(has_radius() ? start_plane_.times_length(radius) : HeightBounds{0, 0}) {}

    // Returns the corner that reaches the height c first, and its time; of equal real times, the first by name. At the
    // start, all corners must be higher than c.
    std::optional<FirstCorner> find_first(QueryMemory& memory) const {
        std::vector<Memory::Candidate>& candidates = Memory::of(memory).candidates;
        candidates.clear();
        double latest = std::numeric_limits<double>::infinity();
        walk_below(
            BoxHeights(end_, MeshShapeAccess::tree(shape_).boxes), memory, [&] { return reach_.high; },
            [&](const Corner& corner) {
                const Vec3& v = shape_.mesh().vertices()[corner.vertex];
                const HeightBounds h1 = above(end_.bounds(v), reach_);
                const TimeBounds time(above(start_.bounds(v), reach_), h1);
                if (h1.low > 0 || time.low > latest) return false;
                latest = std::min(latest, time.high);
                candidates.push_back({corner, time.low});
                return false;
            });
        std::erase_if(candidates, [&](const Memory::Candidate& c) { return c.low > latest; });
        keep_one_a_vertex(candidates);
        std::optional<FirstCorner> first;
        for (const auto& [corner, low] : candidates) {
            std::optional<FirstCorner> next = time_of(corner);
            if (!next) continue;
            const int order = first ? compare_times(*next, *first) : -1;
            if (order > 0 || (order == 0 && first->corner.name() < corner.name())) continue;
            first = std::move(next);
        }
        return first;
    }

    // Return the sign of (time of the corner - `latest`), and the time, rounded once.
    int compare(const FirstCorner& first, double latest) const {
        return first.quotient ? exact::compare(first.quotient->ref(), latest)
                              : exact::compare(first.root, exact::ScaledInteger(latest));
    }
    double rounded(const FirstCorner& first) const {
        return first.quotient ? exact::round_fraction(first.quotient->ref()) : exact::round_signed(first.root);
    }

  private:
    bool has_radius() const noexcept { return key_of(radius_) != 0; }

    std::optional<FirstCorner> time_of(const Corner& corner) const {
        const Vec3& v = shape_.mesh().vertices()[corner.vertex];
        const exact::ScaledInteger h1 = end_.exact(v);
        const exact::ScaledInteger square = has_radius() ? start_plane_.exact().square : exact::ScaledInteger();
        if (h1.sign() > 0 && (!has_radius() || compare_ratio(h1, square, radius_) > 0)) return std::nullopt;
        const exact::ScaledInteger h0 = start_.exact(v);
        if (!has_radius()) return FirstCorner{corner, Quotient(h0, h0 - h1), {}};
        const exact::ScaledInteger r = radius_;
        return FirstCorner{corner, std::nullopt, exact::root_quotient(h0, r * r * square, h0 - h1, true)};
    }
    static int compare_times(const FirstCorner& a, const FirstCorner& b) {
        return a.quotient ? exact::compare(a.quotient->ref(), b.quotient->ref()) : exact::compare(a.root, b.root);
    }

    const MeshShape& shape_;
    double radius_;
    Plane start_plane_, end_plane_;
    Heights start_, end_;
    HeightBounds reach_;  // of c
};

template <class Body>
std::optional<FirstContact> cast_moving(const Moving<Body>& body, const MeshShape& core, double radius,
                                        const Moving<HalfSpace>& half_space, double max_time, const Ask& ask) {
    const double latest = require_time(max_time);
    if (!same_bits(half_space.from.R, half_space.to.R)) {
        throw NotSupported(Question::cast_moving, body.what->kind(), ShapeKind::half_space());
    }
    Asking asking(ask);
    const Ask in_memory(asking.memory());
    // A cast by a zero translation finds a point that body and half space share at the start.
    if (const auto at_start = cast(Posed<Body>(*body.what, body.from), Vec3::Zero(),
                                   Posed<HalfSpace>(*half_space.what, half_space.from), 0, in_memory)) {
        return at_start;
    }
    const MovingHeights heights({core, body.from, body.to}, radius, half_space);
    const auto first = heights.find_first(asking.memory());
    if (!first || heights.compare(*first, latest) > 0) return std::nullopt;
    FirstContact contact{heights.rounded(*first), ClosestKind::vertex_face, first->corner.feature(), plane_feature};
    PosedBody({core, body.from}).rename(contact.a);
    return contact;
}

}  // namespace
}  // namespace half_spaces

std::optional<FirstContact> cast(const Moving<MeshShape>& body, const Moving<HalfSpace>& half_space, double max_time,
                                 const Ask& ask) {
    return half_spaces::cast_moving(body, *body.what, 0, half_space, max_time, ask);
}
std::optional<FirstContact> cast(const Moving<Rounded>& body, const Moving<HalfSpace>& half_space, double max_time,
                                 const Ask& ask) {
    return half_spaces::cast_moving(body, body.what->core(), body.what->radius(), half_space, max_time, ask);
}

}  // namespace ecods
