// Answers casts of bodies between poses against half spaces that are translated or at rest.
//
// The height of each vertex is then linear in time, because N does not change. A vertex with the height h0 > 0 at the
// start and h1 <= 0 at the end reaches the plane at the time h0 / (h0 - h1), which does not decrease if h0 or h1 grows.
#include <algorithm>
#include <limits>
#include <optional>

#include "base/limits.hpp"
#include "ecods/error.hpp"
#include "ecods/half_space.hpp"
#include "geometry/same_bits.hpp"
#include "query/body/posed_body.hpp"
#include "query/half_space/corners_below.hpp"
#include "query/half_space/round.hpp"
#include "query/intersection/asking.hpp"

namespace ecods {
namespace half_spaces {
namespace {

// This factor covers the roundings of a quotient, of its divisor, and of the factor itself, in any rounding mode.
constexpr double slack = 0x1p-50;

// TimeBounds are a lower and an upper bound of the time. If bounds of heights are infinite, they may be NaN, and then
// prove nothing.
struct TimeBounds {
    TimeBounds(const HeightBounds& h0, const HeightBounds& h1) noexcept {
        const double from = std::max(h0.low, 0.0), until = std::min(h1.high, 0.0);
        low = from / (from - h1.low) * (1 - slack);
        high = h0.high / (h0.high - until) * (1 + slack);
        if (!(h1.high <= 0) || !(h0.low > 0)) high = std::numeric_limits<double>::infinity();
    }

    double low, high;
};

class MovingHeights {
  public:
    MovingHeights(const Moving<MeshShape>& body, const Moving<HalfSpace>& half_space)
        : shape_(*boundary_of(Posed<MeshShape>(*body.what, body.from)).what),
          start_plane_({*half_space.what, half_space.from}),
          end_plane_({*half_space.what, half_space.to}),
          start_(start_plane_, body.from),
          end_(end_plane_, body.to) {}

    const Heights& start() const noexcept { return start_; }
    const MeshShape& shape() const noexcept { return shape_; }

    // Returns the corner that reaches the plane first, and its time; of equal real times, the first by name. At the
    // start, all corners must be above the plane.
    std::optional<std::pair<Corner, Quotient>> find_first(QueryMemory& memory) const {
        std::vector<Memory::Candidate>& candidates = Memory::of(memory).candidates;
        candidates.clear();
        double latest = std::numeric_limits<double>::infinity();
        walk_below(
            BoxHeights(end_, MeshShapeAccess::tree(shape_).boxes), memory, [] { return 0.0; },
            [&](const Corner& corner) {
                const Vec3& v = shape_.mesh().vertices()[corner.vertex];
                const HeightBounds h1 = end_.bounds(v);
                const TimeBounds time(start_.bounds(v), h1);
                if (h1.low > 0 || time.low > latest) return false;
                latest = std::min(latest, time.high);
                candidates.push_back({corner, time.low});
                return false;
            });
        std::erase_if(candidates, [&](const Memory::Candidate& c) { return c.low > latest; });
        keep_one_a_vertex(candidates);
        std::optional<std::pair<Corner, Quotient>> first;
        for (const auto& [corner, low] : candidates) {
            const Vec3& v = shape_.mesh().vertices()[corner.vertex];
            const exact::ScaledInteger h1 = end_.exact(v);
            if (h1.sign() > 0) continue;
            const exact::ScaledInteger h0 = start_.exact(v);
            Quotient time(h0, h0 - h1);
            const int order = first ? exact::compare(time.ref(), first->second.ref()) : -1;
            if (order > 0 || (order == 0 && first->first.name() < corner.name())) continue;
            first.emplace(corner, std::move(time));
        }
        return first;
    }

  private:
    const MeshShape& shape_;
    Plane start_plane_, end_plane_;
    Heights start_, end_;
};

}  // namespace
}  // namespace half_spaces

std::optional<FirstContact> cast(const Moving<MeshShape>& body, const Moving<HalfSpace>& half_space, double max_time,
                                 const Ask& ask) {
    const double latest = require_time(max_time);
    if (!same_bits(half_space.from.R, half_space.to.R)) {
        throw NotSupported(Question::cast_moving, ShapeKind::mesh(), ShapeKind::half_space());
    }
    Asking asking(ask);
    QueryMemory& memory = asking.memory();
    ++QueryMemoryAccess::state(memory).counts.queries;
    const PosedBody posed({*body.what, body.from});
    const auto named = [&](const half_spaces::Corner& corner) {
        Feature feature = corner.feature();
        posed.rename(feature);
        return feature;
    };
    const half_spaces::MovingHeights heights(body, half_space);
    if (half_spaces::reaches_plane(heights.shape(), heights.start(), memory)) {
        const half_spaces::Corner lowest = half_spaces::find_lowest(heights.shape(), heights.start(), memory);
        return FirstContact{0, ClosestKind::contained, named(lowest), no_feature};
    }
    const auto first = heights.find_first(memory);
    if (!first || exact::compare(first->second.ref(), latest) > 0) return std::nullopt;
    return FirstContact{exact::round_fraction(first->second.ref()), ClosestKind::vertex_face, named(first->first),
                        half_spaces::plane_feature};
}

}  // namespace ecods
