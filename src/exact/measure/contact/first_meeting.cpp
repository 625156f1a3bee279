#include "exact/measure/contact/first_meeting.hpp"

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

#include "base/assert.hpp"

namespace ecods::exact {
namespace {

// Whether the features belong to a corner and all of the other triangle, or to two edges with their ends.
struct CornerAndTriangle {
    std::size_t side, corner;

    bool has(const FeaturePair& pair) const noexcept { return pair.has_vertex(side) && pair.corner(side) == corner; }
};
struct TwoEdges {
    std::size_t a, b;

    bool has(const FeaturePair& pair) const noexcept {
        const auto is_end = [](std::size_t corner, std::size_t edge) {
            return corner == edge || corner == next_corner(edge);
        };
        switch (pair.kind) {
            case FeatureKind::vertex_vertex:
                return is_end(pair.a, a) && is_end(pair.b, b);
            case FeatureKind::vertex_edge:
                return pair.vertex_side == 0 ? is_end(pair.a, a) && pair.b == b : pair.a == a && is_end(pair.b, b);
            case FeatureKind::vertex_face:
                return false;
            case FeatureKind::edge_edge:
                return pair.a == a && pair.b == b;
        }
        return false;
    }
};

class MeetingSearch {
  public:
    MeetingSearch(MovingTriangles& triangles, FeatureSet features, const TimeCells* cells)
        : triangles_(triangles), features_(features), cells_(cells) {}

    PartialAnswer run() {
        for (std::size_t side = 0; side < 2; ++side) {
            for (std::size_t corner = 0; corner < 3; ++corner) add(CornerAndTriangle{side, corner});
        }
        for (std::size_t a = 0; a < 3; ++a) {
            for (std::size_t b = 0; b < 3; ++b) add(TwoEdges{a, b});
        }
        if (!is_known_ || !first_) return {is_known_, std::nullopt};
        TrianglesAtRoot then(triangles_, *first_);
        for (std::size_t k = 0; k < feature_pairs.size(); ++k) {
            if (!may_meet(k) || !then.share_point(feature_pairs[k])) continue;
            const double time = first_->round();
            return {true, Meeting{time, first_->is_above(time), feature_pairs[k]}};
        }
        ECODS_ASSERT(false);
        return {false, std::nullopt};
    }

  private:
    bool may_meet(std::size_t pair) const noexcept { return features_ >> pair & 1; }
    template <class Part>
    bool may_meet(const Part& part) const noexcept {
        for (std::size_t k = 0; k < feature_pairs.size(); ++k) {
            if (may_meet(k) && part.has(feature_pairs[k])) return true;
        }
        return false;
    }

    void add(const CornerAndTriangle& part) {
        if (!may_meet(part)) return;
        const Polynomial volume = triangles_.corner_volume(part.side, part.corner);
        if (!volume.is_zero()) return try_roots(volume, part);
        for (std::size_t edge = 0; edge < 3; ++edge) add_in_plane({part.side, part.corner, edge}, part);
    }
    void add(const TwoEdges& part) {
        if (!may_meet(part)) return;
        const Polynomial volume = triangles_.edge_volume(part.a, part.b);
        if (!volume.is_zero()) try_roots(volume, part);
    }

    void add_in_plane(const CornerAndEdge& which, const CornerAndTriangle& part) {
        for (const Polynomial& coordinate : triangles_.turn(which)) {
            if (!coordinate.is_zero()) return try_roots(coordinate, part);
        }
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Polynomial difference = which.side == 0 ? triangles_.difference(which.corner, which.edge, axis)
                                                          : triangles_.difference(which.edge, which.corner, axis);
            if (!difference.is_zero()) return try_roots(difference, part);
        }
    }

    std::vector<Root> roots_of(const Polynomial& p) {
        if (cells_ == nullptr) return roots_in_unit_interval(p);
        auto roots = simple_roots_in(p, {Integer(cells_->m), cells_->bits}, cells_->count);
        is_known_ = is_known_ && roots;
        return roots ? std::move(*roots) : std::vector<Root>();
    }

    // Keeps the first root at which the part meets, if it is before what is known.
    template <class Part>
    void try_roots(const Polynomial& p, const Part& part) {
        for (Root& time : roots_of(p)) {
            if (first_ && compare(time, *first_) >= 0) return;
            TrianglesAtRoot then(triangles_, time);
            for (std::size_t k = 0; k < feature_pairs.size(); ++k) {
                if (!may_meet(k) || !part.has(feature_pairs[k]) || !then.share_point(feature_pairs[k])) continue;
                first_ = std::move(time);
                return;
            }
        }
    }

    MovingTriangles& triangles_;
    FeatureSet features_;
    const TimeCells* cells_;  // null: all of the time
    bool is_known_ = true;
    std::optional<Root> first_;
};

}  // namespace

std::optional<Meeting> first_meeting(MovingTriangles& triangles) {
    return MeetingSearch(triangles, all_features, nullptr).run().meeting;
}

PartialAnswer first_meeting_in(MovingTriangles& triangles, const TimeCells& cells, FeatureSet features) {
    return MeetingSearch(triangles, features, &cells).run();
}

// Powers of two that are normal numbers, and integers below 2^53: all of it is exact.
TimeSpan TimeCells::span() const noexcept {
    const double unit = std::bit_cast<double>(static_cast<std::uint64_t>(1023 - bits) << 52);
    return {static_cast<double>(m) * unit, static_cast<double>(m + count) * unit};
}

std::optional<TimeCells> cells_around(const TimeSpan& time) noexcept {
    constexpr int bits_min = 21, bits_max = 900, relative = 44;
    // As powers of two: not below the length, and not below the time by more than so many bits, so that m has 45.
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

}  // namespace ecods::exact
