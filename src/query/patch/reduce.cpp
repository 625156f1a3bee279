// This derivation bounds the errors of areas and distances in doubles. Let each coordinate of a point be off by at most
// u' X, with u' = 2^-52 and X the largest magnitude of a coordinate, and let differences from the first point have
// coordinates of at most D. A difference is off by 2 u' X + u' D on each axis: less than e = 4 u' X + 2^-400, since D
// <= 2 X. The true difference is at most W = D + 2 e. An area is the triple product of the normal n and two
// differences: six products of three factors. Each product is off by 2 W e + u' W^2 for its factors, and 6 u' W^2 for
// its roundings. With W <= 3 X, so u' W <= 0.75 e, all six are off by less than 44 W e. A sum of t areas is off by t
// times as much, and by t u' of 6 t W^2 for its own roundings. Two sums differ for certain if their difference is more
// than twice this error. The square of a distance across the normal is the sum of the squares of three sums of two
// products: the coordinates of the cross product of n and a difference. Each coordinate is at most 2 W and off by 2 e +
// 8 u' W, which is at most 8 e; each square is off by 36 W e; the sum of all three squares, which is at most 12 W^2 and
// has three roundings, by less than 150 W e, and the difference of two such sums by less than 300 W e.
// Claim: verify/proofs/patch_areas.py
#include "query/patch/reduce.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/arithmetic.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::patches {
namespace {

using exact::cross;
using exact::dot;
using exact::minus;

// Quotient is the fraction num / den, with den > 0.
struct Quotient {
    ScaledInteger num, den{1.0};
};

// Triangles computes the areas of the triangles that the first point makes with two other points, seen along the
// normal, in doubles and exactly. Let exact point i be N_i / d_i, and M_i = N_i d_0 - N_0 d_i. The area of triangle (0,
// i, j), times 2 |n| d_0^2, is [n, M_i, M_j] / (d_i d_j); this factor is left out everywhere. A sum of areas has only
// the denominators of its own points.
class Triangles {
  public:
    Triangles(const std::vector<Vec3>& points, const Vec3& normal, const ExactCorners& exact, std::size_t count)
        : exact_(exact), normal_{normal.x(), normal.y(), normal.z()} {
        double most = 0, size = 0;
        for (const Vec3& p : points) {
            const Vec3 from_first = p - points.front();
            at_.push_back({from_first.x(), from_first.y(), from_first.z()});
            most = std::max(most, p.cwiseAbs().maxCoeff());
            size = std::max(size, from_first.cwiseAbs().maxCoeff());
        }
        long_.resize(points.size());
        // Sums and products of larger numbers may overflow.
        const double e = most <= 0x1p300 ? 4 * two_u * most + 0x1p-400 : std::numeric_limits<double>::infinity();
        const auto terms = static_cast<double>(count);
        off_ = (size + 2 * e) * e;
        of_sums_ = 2 * terms * (44 + 6 * terms) * off_ * (1 + 16 * two_u);
    }

    std::size_t size() const noexcept { return at_.size(); }

    double area(std::size_t i, std::size_t j) const noexcept { return dot(normal_, cross(at_[i], at_[j])); }
    // Returns the sign of the difference x - y of two sums of areas; 0 if doubles do not decide.
    int compare(double x, double y) const noexcept { return x - y > of_sums_ ? 1 : y - x > of_sums_ ? -1 : 0; }
    Quotient exact_area(std::size_t i, std::size_t j) const {
        const Long &x = at(i), &y = at(j);
        return {-dot(x.from_first, cross(exact_normal(), y.from_first)), x.den * y.den};
    }

    // Returns the sign of the difference of two distances from the first point, measured across the normal: that of
    // point i minus that of point j.
    int compare_across(std::size_t i, std::size_t j) const {
        constexpr double factor = 300;
        const auto square = [&](std::size_t k) {
            const auto across = cross(normal_, at_[k]);
            return dot(across, across);
        };
        const double difference = square(i) - square(j), off = factor * off_ * (1 + 16 * two_u);
        if (std::abs(difference) > off) return difference > 0 ? 1 : -1;
        const Quotient x = exact_across(i), y = exact_across(j);
        return (x.num * y.den - y.num * x.den).sign();
    }

  private:
    struct Long {
        ScaledLongVector from_first;
        ScaledInteger den;
    };

    const ScaledLongVector& exact_normal() const {
        if (!long_normal_) long_normal_ = exact_.normal();
        return *long_normal_;
    }
    const Long& at(std::size_t i) const {
        if (!first_) first_ = exact_.point(0);
        if (!long_[i]) {
            const LongPoint p = exact_.point(i);
            long_[i].emplace().den = p.den;
            for (std::size_t k = 0; k < 3; ++k)
                long_[i]->from_first[k] = p.num[k] * first_->den - first_->num[k] * p.den;
        }
        return *long_[i];
    }
    // Returns the square of the distance of point i from the first point, measured across the normal n, times n.n
    // d_0^2: (M_i.M_i)(n.n) - (M_i.n)^2, divided by d_i^2.
    Quotient exact_across(std::size_t i) const {
        const ScaledLongVector &p = at(i).from_first, &n = exact_normal();
        const ScaledInteger along = dot(p, n);
        return {dot(p, p) * dot(n, n) - along * along, at(i).den * at(i).den};
    }

    const ExactCorners& exact_;
    exact::Point normal_;
    std::vector<exact::Point> at_;  // relative to the first point
    double off_ = 0, of_sums_ = 0;
    mutable std::vector<std::optional<Long>> long_;  // computed when they are needed
    mutable std::optional<LongPoint> first_;
    mutable std::optional<ScaledLongVector> long_normal_;
};

// links_[k][j] is the polygon of greatest area with k points that begins with point 0 and ends with point j: its area,
// and the point before j.
struct Link {
    double area = 0;
    std::size_t before = 0;
};
using Links = std::vector<Link>;  // by point

class Choice {
  public:
    Choice(const Triangles& triangles, std::size_t count) : triangles_(triangles) {
        const std::size_t m = triangles.size();
        links_.assign(count + 1, {});
        links_[2].assign(m, {});
        for (std::size_t length = 3; length <= count; ++length) {
            links_[length].assign(m, {});
            for (std::size_t j = length - 1; j < m; ++j) find_best(length, j);
        }
    }

    std::vector<std::size_t> best(std::size_t count) const {
        std::vector<std::size_t> best = points(count, count - 1, links_[count][count - 1].before);
        double area = links_[count][count - 1].area;
        for (std::size_t j = count; j < triangles_.size(); ++j) {
            const Link& link = links_[count][j];
            const int more = triangles_.compare(link.area, area);
            if (more < 0) continue;
            std::vector<std::size_t> other = points(count, j, link.before);
            if (more == 0 && !is_better(other, best)) continue;
            best = std::move(other);
            area = link.area;
        }
        return best;
    }

  private:
    void find_best(std::size_t length, std::size_t j) {
        Link& best = links_[length][j];
        for (std::size_t i = length - 2; i < j; ++i) {
            const Link link{links_[length - 1][i].area + triangles_.area(i, j), i};
            const int more = i == length - 2 ? 1 : triangles_.compare(link.area, best.area);
            if (more > 0 || (more == 0 && is_better(points(length, j, i), points(length, j, best.before)))) best = link;
        }
    }

    // Returns the best choice of `length` points whose last two points are `before` and `last`.
    std::vector<std::size_t> points(std::size_t length, std::size_t last, std::size_t before) const {
        std::vector<std::size_t> result(length);
        result[length - 1] = last;
        for (std::size_t k = length - 1; k > 1; --k) {
            result[k - 1] = before;
            before = links_[k][before].before;
        }
        return result;
    }

    // Returns true if polygon x has a greater area than y, or the same area and a lexicographically smaller list.
    // Exact.
    bool is_better(const std::vector<std::size_t>& x, const std::vector<std::size_t>& y) const {
        Quotient difference;
        const auto has = [](const std::vector<std::size_t>& points, std::size_t i, std::size_t j) {
            const auto found = std::ranges::find(points, i);
            return found != points.end() && found + 1 != points.end() && *(found + 1) == j;
        };
        const auto add = [&](const std::vector<std::size_t>& of, const std::vector<std::size_t>& other, bool is_minus) {
            for (std::size_t k = 2; k < of.size(); ++k) {
                if (has(other, of[k - 1], of[k])) continue;
                const Quotient area = triangles_.exact_area(of[k - 1], of[k]);
                const ScaledInteger part = area.num * difference.den;
                difference.num = difference.num * area.den + (is_minus ? -part : part);
                difference.den = difference.den * area.den;
            }
        };
        add(x, y, false);
        add(y, x, true);
        const int more = difference.num.sign();
        return more > 0 || (more == 0 && x < y);
    }

    const Triangles& triangles_;
    std::vector<Links> links_;  // by number of points
};

}  // namespace

std::vector<std::size_t> choose_corners(const std::vector<Vec3>& points, const Vec3& normal, const ExactCorners& exact,
                                        std::size_t count) {
    if (count == 1) return {0};
    const Triangles triangles(points, normal, exact, count);
    if (count > 2) return Choice(triangles, count).best(count);
    std::size_t furthest = 1;
    for (std::size_t i = 2; i < points.size(); ++i) {
        if (triangles.compare_across(i, furthest) > 0) furthest = i;
    }
    return {0, furthest};
}

}  // namespace ecods::patches
