#include "exact/measure/contact/first_meeting.hpp"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "base/assert.hpp"
#include "exact/measure/contact/moving_triangles.hpp"

namespace ecods::exact {
namespace {

template <class P>
class MeetingSearch {
  public:
    MeetingSearch(RelativePositionOf<P>& triangles, FeatureSet features, const TimeCells* cells)
        : triangles_(triangles), features_(features), cells_(cells) {}

    PartialAnswer run() {
        for (const FeaturePair& pair : feature_pairs) {
            if (pair.kind == FeatureKind::vertex_face || pair.kind == FeatureKind::edge_edge) add(pair);
        }
        if (!is_known_ || !first_) return {is_known_, std::nullopt};
        const FeaturePair* const shared = first_shared(features_, *first_);
        ECODS_ASSERT(shared != nullptr);
        if (shared == nullptr) return {false, std::nullopt};
        const double time = first_->round();
        return {true, Meeting{time, first_->is_above(time), *shared}};
    }

  private:
    // Returns the pairs in features_ whose corners all belong to `four`, which is a corner and a triangle, or two
    // edges.
    FeatureSet part_of(const FeaturePair& four) const noexcept {
        const CornerPairs pairs = corner_pairs(four);
        FeatureSet result = 0;
        for (FeatureSet rest = features_; rest != 0; rest &= rest - 1) {
            if ((corners_of_features[first_of(rest)] & ~pairs) == 0) result |= rest & -rest;
        }
        return result;
    }
    static std::size_t first_of(FeatureSet features) noexcept {
        return static_cast<std::size_t>(std::countr_zero(features));
    }

    // Returns the first pair in `features` that shares a point at `time`; null if no pair shares one.
    const FeaturePair* first_shared(FeatureSet features, RootOf<P>& time) {
        TrianglesAtRoot then(triangles_, time);
        for (; features != 0; features &= features - 1) {
            const FeaturePair& pair = feature_pairs[first_of(features)];
            if (then.share_point(pair)) return &pair;
        }
        return nullptr;
    }

    void add(const FeaturePair& four) {
        const FeatureSet part = part_of(four);
        if (part == 0) return;
        const bool has_corner = four.kind == FeatureKind::vertex_face;
        const std::size_t side = four.vertex_side, corner = four.corner(side);
        const P volume = has_corner ? triangles_.corner_volume(side, corner) : triangles_.edge_volume(four.a, four.b);
        if (!volume.is_zero()) return try_roots(volume, part);
        if (!has_corner) return;
        for (std::size_t edge = 0; edge < 3; ++edge) add_in_plane({side, corner, edge}, part);
    }

    void add_in_plane(const CornerAndEdge& which, FeatureSet part) {
        for (const P& coordinate : triangles_.turn(which)) {
            if (!coordinate.is_zero()) return try_roots(coordinate, part);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const P difference = which.side == 0 ? triangles_.difference(which.corner, which.edge, axis)
                                                 : triangles_.difference(which.edge, which.corner, axis);
            if (!difference.is_zero()) return try_roots(difference, part);
        }
    }

    std::vector<RootOf<P>> roots_of(const P& p) {
        if (cells_ == nullptr) return roots_in_unit_interval(p);
        auto roots = simple_roots_in(p, {Integer(cells_->m), cells_->bits}, cells_->count);
        is_known_ = is_known_ && roots;
        return roots ? std::move(*roots) : std::vector<RootOf<P>>();
    }

    // Sets first_ to the first root of p at which one of the pairs in `part` shares a point, if that root is before
    // first_.
    void try_roots(const P& p, FeatureSet part) {
        for (RootOf<P>& time : roots_of(p)) {
            if (first_ && compare(time, *first_) >= 0) return;
            if (first_shared(part, time) == nullptr) continue;
            first_ = std::move(time);
            return;
        }
    }

    RelativePositionOf<P>& triangles_;
    FeatureSet features_;
    const TimeCells* cells_;  // null: all times in [0, 1]
    bool is_known_ = true;
    std::optional<RootOf<P>> first_;
};

}  // namespace

template <class P>
std::optional<Meeting> first_meeting(RelativePositionOf<P>& triangles) {
    return MeetingSearch(triangles, all_features, nullptr).run().meeting;
}

template <class P>
PartialAnswer first_meeting_in(RelativePositionOf<P>& triangles, const TimeCells& cells, FeatureSet features) {
    return MeetingSearch(triangles, features, &cells).run();
}

// Returns the interval of the cells, computed without rounding: the unit is a power of two that is a normal number, and
// the integers are below 2^53.
TimeSpan TimeCells::span() const noexcept {
    const double unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - bits) << 52);
    return {static_cast<double>(m) * unit, static_cast<double>(m + count) * unit};
}

std::optional<TimeCells> cells_around(const TimeSpan& time) noexcept {
    constexpr int bits_min = 21, bits_max = 900, relative = 44;
    // 2^unit is at least the length of `time`, and at least 2^-44 of the power of two in time.to, so that m has at most
    // 45 bits.
    const auto exponent = [](double x) { return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023; };
    const int unit = std::max(exponent(time.to - time.from) + 1, exponent(time.to) - relative);
    const int bits = -unit;
    if (bits < bits_min || bits > bits_max) return std::nullopt;
    const Dyadic from = decode(time.from);
    const int shift = from.e + bits;
    const std::int64_t m = from.m == 0 || shift <= -63 ? 0 : shift >= 0 ? from.m << shift : from.m >> -shift;
    const std::int64_t last = (std::int64_t{1} << std::min(bits, 62)) - 1;
    return TimeCells{std::min(m, last), bits, m < last ? 2 : 1};
}

template std::optional<Meeting> first_meeting(RelativePosition&);
template std::optional<Meeting> first_meeting(RelativePositionOf<Quintic>&);
template PartialAnswer first_meeting_in(RelativePosition&, const TimeCells&, FeatureSet);
template PartialAnswer first_meeting_in(RelativePositionOf<Quintic>&, const TimeCells&, FeatureSet);

}  // namespace ecods::exact
