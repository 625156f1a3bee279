// LineTriangle computes in exact integers the points that a line (a segment or ray) shares with a triangle.
//
// All points are relative to the beginning of the line, so the line's points are s d, 0 <= s <= end. With corners p, q
// and r, and n = (q - p) x (r - p), the line crosses the triangle's plane at s = n . p / n . d, and
//     det(d, q, r) + det(d, r, p) + det(d, p, q) = n . d.
// The three determinants are the barycentric coordinates of the crossing, times n . d. So the crossing is in the
// triangle if and only if no two of them have opposite signs. If n . d = 0, there is a common point only if line and
// triangle are in one plane. Then the line's part in the triangle is spanned by its parts in the edges; this also holds
// for triangles of zero area.
//
// Widths. With coordinates below 2^k, n . p, n . d and the three determinants are determinants of three differences,
// below 2^(3k + 6). Parameters are fractions of such determinants, or of shorter numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>

#include "ecods/results.hpp"
#include "exact/measure/round/fraction.hpp"
#include "exact/measure/round/limb_vectors.hpp"

namespace ecods::exact {

// A LineHit describes the common points of line and triangle: the line's points at parameters from `enter` to `leave`.
struct LineHit {
    Fraction enter;
    Fraction leave;
    bool is_along = false;  // true if enter and leave differ
    // `feature` is the feature of lowest dimension that contains all common points, and `corner` the lowest corner that
    // names it.
    Feature::Kind feature = Feature::Kind::face;
    std::uint32_t corner = 0;
    int facing = 0;           // the sign of n . d
    std::uint32_t entry = 3;  // if is_along: the corner at `enter`; 3 if none is known
};

template <int L>
class LineTriangle {
  public:
    static constexpr int coordinate_bits = 64 * L - 3;
    static_assert(minor_bits(coordinate_bits) <= 128 * L - 1);
    static_assert(determinant_bits(coordinate_bits) <= 192 * L - 1);
    static_assert(L <= limb_count_max);

    using Vector = LimbVector<L>;
    using Corners = std::array<Vector, 3>;

    // Takes the line's direction d, the triangle's corners relative to the line's beginning, and the parameter `end` of
    // the line's last point: infinity or any number >= 0. The references d and corners must remain valid while the
    // object is used.
    LineTriangle(const Vector& d, const Corners& corners, double end) noexcept : d_(d), corner_(corners), end_(end) {}

    // Returns true and sets `hit` if line and triangle share a point; otherwise returns false, and `hit` has no
    // meaning.
    bool find(LineHit& hit) const noexcept {
        if (is_zero_vector<L>(d_)) return find_point(hit);
        const Weights weights = find_weights();
        int most = 0, least = 0;
        std::array<int, 3> signs;
        for (std::size_t i = 0; i < 3; ++i) {
            signs[i] = sign<3 * L>(weights[i]);
            most = std::max(most, signs[i]);
            least = std::min(least, signs[i]);
        }
        if (most > 0 && least < 0) return false;
        // Seen along d, all corners are on one line through the origin, so line and triangle are in one plane.
        if (most == 0 && least == 0) return find_in_plane(hit);
        hit.facing = most + least;
        hit.is_along = false;
        name_feature(signs, hit);
        if (!set_crossing(weights, hit)) return false;
        if (compare(hit.enter.ref(), end_) > 0) return false;
        hit.leave = hit.enter;
        return true;
    }

    // Sets `at` to the parameter of the point in which the line crosses the triangle's plane, and returns the sign of n
    // . d. The line must cross the plane, at a parameter that is not negative.
    int find_crossing(Fraction& at) const noexcept {
        const LimbVector<2 * L> n = normal();
        const Magnitude<3 * L> den = dot<2 * L, L>(n, d_);
        set(at, dot<2 * L, L>(n, corner_[0]), den);
        return sign<3 * L>(den);
    }

  private:
    // A Ratio is a parameter of the line. It may be negative.
    using Ratio = exact::Ratio<2 * L>;
    // A Part is the interval [low, high] of the parameters of the line's points on an edge. It may be empty.
    struct Part {
        bool is_empty = true;
        Ratio low, high;
    };
    // corner[i] is the parameter of corner i if has_corner[i] (it is on the line); edge[i] is the part of the edge from
    // corner i.
    struct Parts {
        std::array<bool, 3> has_corner{};
        std::array<Ratio, 3> corner;
        std::array<Part, 3> edge;
    };

    static int compare(const FractionRef& x, double y) noexcept { return exact::compare(x, y); }
    static int compare(const Ratio& x, const Ratio& y) noexcept { return exact::compare(x, y); }
    static int compare(const Ratio& x, const Fraction& y) noexcept {
        return x.sign() < 0 ? -1 : exact::compare(x.size(), y.ref());
    }

    // Sets `to` to num / den, which must not be negative.
    template <int M>
    static void set(Fraction& to, const Magnitude<M>& num, const Magnitude<M>& den) noexcept {
        to.num.assign(num.limbs);
        to.den.assign(den.limbs);
    }

    // Returns an axis on which v is not zero. v must not be the zero vector.
    template <int M>
    static std::size_t axis_of(const LimbVector<M>& v) noexcept {
        std::size_t axis = 0;
        while (is_zero<M>(v[axis].limbs)) ++axis;
        return axis;
    }
    static Vector minus(const Vector& a, const Vector& b) noexcept {
        return {exact::minus<L>(a[0], b[0]), exact::minus<L>(a[1], b[1]), exact::minus<L>(a[2], b[2])};
    }
    LimbVector<2 * L> normal() const noexcept {
        return cross<L>(minus(corner_[1], corner_[0]), minus(corner_[2], corner_[0]));
    }

    using Weights = std::array<Magnitude<3 * L>, 3>;

    // Returns the barycentric coordinates of the crossing with the plane, times n . d.
    Weights find_weights() const noexcept {
        const LimbVector<2 *L> dp = cross<L>(d_, corner_[0]), dq = cross<L>(d_, corner_[1]);
        return {dot<2 * L, L>(dq, corner_[2]), negated<3 * L>(dot<2 * L, L>(dp, corner_[2])),
                dot<2 * L, L>(dp, corner_[1])};
    }

    // Sets hit.enter to the parameter of the crossing with the plane, as a fraction of numbers that are as short as
    // possible, and returns true. Returns false if the parameter is negative. hit.feature and hit.corner must have been
    // set.
    bool set_crossing(const Weights& weights, LineHit& hit) const noexcept {
        if (hit.feature == Feature::Kind::vertex) return set(hit.enter, on_line(corner_[hit.corner]));
        if (hit.feature == Feature::Kind::edge) {
            const Vector &p = corner_[hit.corner], e = minus(corner_[(hit.corner + 1) % 3], p);
            const LimbVector<2 * L> de = cross<L>(d_, e);
            const std::size_t axis = axis_of<2 * L>(de);
            return set(hit.enter, {cross<L>(p, e)[axis], de[axis]});
        }
        // n . p is computed as p . (q x r), and n . d as the sum of the weights.
        const Magnitude<3 * L> num = dot<2 * L, L>(cross<L>(corner_[1], corner_[2]), corner_[0]);
        if (sign<3 * L>(num) * hit.facing < 0) return false;
        Magnitude<3 * L> den = weights[0];
        for (const std::size_t i : {1u, 2u}) add_signed<3 * L>(den.limbs, weights[i].limbs, 0);
        set(hit.enter, num, den);
        return true;
    }
    static bool set(Fraction& to, const Ratio& at) noexcept {
        if (at.sign() < 0) return false;
        set(to, at.num, at.den);
        return true;
    }

    // Sets hit.feature and hit.corner from the signs of the barycentric coordinates: none zero, the face; one zero, the
    // edge opposite to that corner; two zero, the third corner.
    static void name_feature(const std::array<int, 3>& weights, LineHit& hit) noexcept {
        std::uint32_t zeros = 0, at_zero = 0, at_weight = 0;
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (weights[i] == 0) {
                ++zeros;
                at_zero = i;
            } else {
                at_weight = i;
            }
        }
        hit.feature = zeros == 0 ? Feature::Kind::face : zeros == 1 ? Feature::Kind::edge : Feature::Kind::vertex;
        hit.corner = zeros == 0 ? 0 : zeros == 1 ? (at_zero + 1) % 3 : at_weight;
    }

    bool find_in_plane(LineHit& hit) const noexcept {
        hit.facing = 0;
        Parts parts;
        find_parts(parts);
        const Ratio *low = nullptr, *high = nullptr;
        for (const Part& part : parts.edge) {
            if (part.is_empty) continue;
            if (low == nullptr || compare(part.low, *low) < 0) low = &part.low;
            if (high == nullptr || compare(part.high, *high) > 0) high = &part.high;
        }
        if (low == nullptr || high->sign() < 0) return false;
        if (low->sign() > 0) {
            set(hit.enter, low->num, low->den);
        } else {
            hit.enter = {};
        }
        set(hit.leave, high->num, high->den);
        if (compare(hit.enter.ref(), end_) > 0) return false;
        if (compare(hit.leave.ref(), end_) > 0) hit.leave = fraction_of(end_);
        hit.is_along = exact::compare(hit.enter.ref(), hit.leave.ref()) != 0;
        name_feature(parts, hit);
        return true;
    }

    static void name_feature(const Parts& parts, LineHit& hit) noexcept {
        std::uint32_t entry = 0;
        while (entry < 3 && (!parts.has_corner[entry] || compare(parts.corner[entry], hit.enter) != 0)) ++entry;
        hit.entry = entry;
        if (!hit.is_along && entry < 3) {
            hit.feature = Feature::Kind::vertex;
            hit.corner = entry;
            return;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Part& part = parts.edge[i];
            if (part.is_empty || compare(part.low, hit.enter) > 0 || compare(part.high, hit.leave) < 0) continue;
            hit.feature = Feature::Kind::edge;
            hit.corner = i;
            return;
        }
        hit.feature = Feature::Kind::face;
        hit.corner = 0;
    }

    void find_parts(Parts& parts) const noexcept {
        for (std::size_t i = 0; i < 3; ++i) {
            parts.has_corner[i] = is_parallel<L>(corner_[i], d_);
            if (parts.has_corner[i]) parts.corner[i] = on_line(corner_[i]);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            Part& part = parts.edge[i];
            if (parts.has_corner[i] && parts.has_corner[j]) {
                const bool is_turned = compare(parts.corner[j], parts.corner[i]) < 0;
                part = {false, parts.corner[is_turned ? j : i], parts.corner[is_turned ? i : j]};
            } else if (parts.has_corner[i] || parts.has_corner[j]) {
                const Ratio& at = parts.corner[parts.has_corner[i] ? i : j];
                part = {false, at, at};
            } else {
                find_crossing(corner_[i], corner_[j], part);
            }
        }
    }

    // Returns the parameter of p, which must be on the line.
    Ratio on_line(const Vector& p) const noexcept {
        const std::size_t axis = axis_of<L>(d_);
        return {widened<2 * L>(p[axis]), widened<2 * L>(d_[axis])};
    }

    // Sets `part` to the point in which the line crosses the open edge from p to q; leaves it empty if there is none.
    // Neither p nor q is on the line. With e = q - p, s d = p + t e: its cross products with e and with d are s (d x e)
    // = p x e and t (d x e) = p x d.
    void find_crossing(const Vector& p, const Vector& q, Part& part) const noexcept {
        const Vector e = minus(q, p);
        const LimbVector<2 * L> de = cross<L>(d_, e);
        if (is_zero_vector<2 * L>(de) || sign<3 * L>(dot<2 * L, L>(de, p)) != 0) return;
        const std::size_t axis = axis_of<2 * L>(de);
        const Ratio t{cross<L>(p, d_)[axis], de[axis]};
        if (t.sign() <= 0 || exact::compare(t.size(), 1.0) >= 0) return;
        const Ratio s{cross<L>(p, e)[axis], de[axis]};
        part = {false, s, s};
    }

    // Returns the result of find() for a line that is a single point, the origin, and sets `hit`.
    bool find_point(LineHit& hit) const noexcept {
        const LimbVector<2 * L> n = normal();
        if (sign<3 * L>(dot<2 * L, L>(n, corner_[0])) != 0) return false;
        hit.facing = 0;
        hit.enter = {};
        hit.leave = {};
        hit.is_along = false;
        for (std::uint32_t i = 0; i < 3; ++i) {
            if (!is_zero_vector<L>(corner_[i])) continue;
            hit.feature = Feature::Kind::vertex;
            hit.corner = i;
            return true;
        }
        for (std::uint32_t i = 0; i < 3; ++i) {
            const Vector &p = corner_[i], &q = corner_[(i + 1) % 3];
            if (!is_parallel<L>(p, q) || sign<2 * L>(dot<L, L>(p, q)) > 0) continue;
            hit.feature = Feature::Kind::edge;
            hit.corner = i;
            return true;
        }
        for (std::size_t i = 0; i < 3; ++i) {
            const LimbVector<2 * L> side = cross<L>(corner_[i], corner_[(i + 1) % 3]);
            if (sign<4 * L>(dot<2 * L, 2 * L>(side, n)) <= 0) return false;
        }
        hit.feature = Feature::Kind::face;
        hit.corner = 0;
        return true;
    }

    const Vector& d_;
    const Corners& corner_;
    double end_;
};

}  // namespace ecods::exact
