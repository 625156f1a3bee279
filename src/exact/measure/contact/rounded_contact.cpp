#include "exact/measure/contact/rounded_contact.hpp"

#include <initializer_list>
#include <utility>

#include "base/double_key.hpp"
#include "exact/measure/round/round_root_sum.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::exact {
namespace {

// Linear is a linear function of time: slope * time + begin.
struct Linear {
    ScaledInteger slope, begin;

    friend Linear operator-(const Linear& a, const Linear& b) { return {a.slope - b.slope, a.begin - b.begin}; }
};
bool are_from_zero(const RootSum& time, std::initializer_list<Linear> numbers) {
    for (const Linear& each : numbers) {
        if (sign(affine(each.slope, time, each.begin)) < 0) return false;
    }
    return true;
}

// Replaces `best` by the end at `time` if `time` is less than best's and direction is 1, or greater and direction is
// -1. If both times are equal, keeps the features in `best`.
void take(std::optional<RoundedContact::End>& best, const std::optional<RootSum>& time, const FeaturePair& f,
          int direction) {
    if (!time) return;
    const double rounded = round_signed(*time);
    if (best) {
        const std::int64_t key = key_of(rounded), best_key = key_of(best->rounded);
        const int order = key < best_key ? -1 : key > best_key ? 1 : compare(*time, best->time);
        if (order * direction >= 0) return;
    }
    best = RoundedContact::End{*time, rounded, f};
}

}  // namespace

RoundedContact::RoundedContact(const std::array<ScaledLongVector, 6>& corners, const ScaledLongVector& motion,
                               const ExactSum& p)
    : corners_(corners), motion_(motion), p_(p.scaled()) {
    for (std::size_t side = 0; side < 2; ++side) {
        for (std::size_t i = 1; i < 3; ++i) {
            for (std::size_t j = 0; j < i; ++j) {
                is_copy_[side][i] = is_copy_[side][i] || is_zero(minus(corner(side, i), corner(side, j)));
            }
        }
    }
}

std::optional<RoundedContact::Interval> RoundedContact::interval() const {
    std::optional<End> first, last;
    for (const FeaturePair& f : feature_pairs) {
        if (is_repeated(f)) continue;
        const Times times = times_of(piece_of(f));
        take(first, times.enter, f, 1);
        take(last, times.leave, f, -1);
    }
    if (!first || !last) return std::nullopt;
    return Interval{*std::move(first), *std::move(last)};
}

// Returns true if an earlier pair of features has the same piece, because a corner equals an earlier corner of its
// triangle.
bool RoundedContact::is_repeated(const FeaturePair& f) const noexcept {
    return (f.has_vertex(0) && is_copy_[0][f.a]) || (f.has_vertex(1) && is_copy_[1][f.b]);
}

RoundedContact::Piece RoundedContact::piece_of(const FeaturePair& f) const {
    Piece piece;
    piece.w = minus(corner(0, f.a), corner(1, f.b));
    const auto side_of = [&](std::size_t side, std::size_t from, std::size_t to) {
        return side == 0 ? minus(corner(0, from), corner(0, to)) : minus(corner(1, to), corner(1, from));
    };
    const std::size_t other = 1 - f.vertex_side, at = f.corner(other);
    switch (f.kind) {
        case FeatureKind::vertex_vertex:
            break;
        case FeatureKind::vertex_edge:
            piece.dimension = 1;
            piece.u = side_of(other, at, at + 1);
            break;
        case FeatureKind::vertex_face:
            piece.dimension = 2;
            piece.is_triangle = true;
            piece.u = side_of(other, at, at + 1);
            piece.v = side_of(other, at, at + 2);
            break;
        case FeatureKind::edge_edge:
            piece.dimension = 2;
            piece.u = side_of(0, f.a, f.a + 1u);
            piece.v = side_of(1, f.b, f.b + 1u);
            break;
    }
    return piece;
}

RoundedContact::Times RoundedContact::times_of(const Piece& piece) const {
    return piece.dimension == 0 ? of_ball(piece) : piece.dimension == 1 ? of_cylinder(piece) : of_plate(piece);
}

RoundedContact::Times RoundedContact::of_ball(const Piece& piece) const {
    const ScaledLongVector across = cross(motion_, piece.w);
    const ScaledInteger dd = dot(motion_, motion_), y = p_ * p_ * dd - dot(across, across);
    if (y.sign() < 0) return {};
    const ScaledInteger x = -dot(motion_, piece.w);
    return {root_quotient(x, y, dd, true), root_quotient(x, y, dd, false)};
}

RoundedContact::Times RoundedContact::of_cylinder(const Piece& piece) const {
    const ScaledLongVector across = cross(motion_, piece.u);
    const ScaledInteger z = dot(across, across), volume = dot(across, piece.w), uu = dot(piece.u, piece.u);
    if (z.sign() == 0) return {};
    const ScaledInteger rest = p_ * p_ * z - volume * volume;
    if (rest.sign() < 0) return {};
    const ScaledInteger y = uu * rest;
    const ScaledInteger x = -dot(across, cross(piece.w, piece.u));
    const Linear foot{dot(motion_, piece.u), dot(piece.w, piece.u)}, whole{{}, uu};
    const auto on_piece = [&](bool is_subtracted) -> std::optional<RootSum> {
        const RootSum time = root_quotient(x, y, z, is_subtracted);
        if (!are_from_zero(time, {foot, whole - foot})) return std::nullopt;
        return time;
    };
    return {on_piece(true), on_piece(false)};
}

RoundedContact::Times RoundedContact::of_plate(const Piece& piece) const {
    const ScaledLongVector n = cross(piece.u, piece.v);
    const ScaledInteger speed = dot(n, motion_), nn = dot(n, n);
    if (speed.sign() == 0) return {};
    const ScaledInteger height = dot(n, piece.w), y = p_ * p_ * nn;
    const ScaledInteger x = speed.sign() > 0 ? -height : height, z = speed.sign() > 0 ? speed : -speed;
    const ScaledLongVector along_u = cross(piece.v, n), along_v = cross(n, piece.u);
    const Linear at_u{dot(motion_, along_u), dot(piece.w, along_u)}, at_v{dot(motion_, along_v), dot(piece.w, along_v)};
    const Linear whole{{}, nn};
    const auto on_piece = [&](bool is_subtracted) -> std::optional<RootSum> {
        const RootSum time = root_quotient(x, y, z, is_subtracted);
        const bool is_on = piece.is_triangle ? are_from_zero(time, {at_u, at_v, whole - at_u - at_v})
                                             : are_from_zero(time, {at_u, at_v, whole - at_u, whole - at_v});
        if (!is_on) return std::nullopt;
        return time;
    };
    return {on_piece(true), on_piece(false)};
}

}  // namespace ecods::exact
