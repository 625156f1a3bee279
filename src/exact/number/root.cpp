// Roots are isolated by sign changes of Bernstein coefficients (Collins and Akritas, Polynomial real root isolation
// using Descartes's rule of signs, SYMSAC 1976). For polynomials without multiple roots this terminates.
//
// A multiple root of a polynomial p of degree at most three is rational. If a cubic has a double root, it has only one,
// which is the root of the linear polynomial gcd(p, p'). A quadratic with a double root, or a cubic with a triple root,
// is a multiple of a power of a linear polynomial.
#include "exact/number/root.hpp"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

#include "base/assert.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::exact {
namespace {

constexpr int first_bits = 60;  // the first width to which roots are refined; such fractions fit into one limb

BinaryFraction next(const BinaryFraction& x) {
    return {x.m + Integer(std::int64_t{1}), x.bits};
}

int compare_fractions(const BinaryFraction& x, const BinaryFraction& y) {
    if (x.bits == y.bits) return compare(x.m, y.m);
    return x.bits < y.bits ? compare(x.m << (y.bits - x.bits), y.m) : compare(x.m, y.m << (x.bits - y.bits));
}

int first_sign(const Polynomial::Coefficients& coefficients) {
    for (const Integer& c : coefficients) {
        if (const int sign = c.sign()) return sign;
    }
    return 0;
}

// Returns the sign of the coefficients if all have the same sign; 0 if signs differ or a coefficient is zero.
int common_sign(const Polynomial::Coefficients& coefficients, int degree) {
    const int sign = coefficients[0].sign();
    for (int i = 1; i <= degree; ++i) {
        if (coefficients[static_cast<std::size_t>(i)].sign() != sign) return 0;
    }
    return sign;
}

// Returns the bits of the double nearest to (m + rest) / 2^bits, where rest = 0 if is_exact, and 0 < rest < 1
// otherwise. The number must be positive and at most 1. m must have at least 54 bits, or 2^-bits must be at most half
// the least double.
std::uint64_t nearest(const BinaryFraction& x, bool is_exact) {
    constexpr int least = -1074;
    const int width = x.m.bit_width();
    const int exponent = std::max(width - x.bits - 53, least);
    const int drop = exponent + x.bits;
    std::uint64_t kept = 0;
    if (drop <= 0) {
        ECODS_ASSERT(is_exact);
        kept = (x.m << -drop).limbs()[0];
    } else {
        const Integer whole = x.m >> drop;
        kept = whole.is_zero() ? 0 : whole.limbs()[0];
        const Integer half = Integer(std::int64_t{1}) << (drop - 1);
        const int side = compare(x.m - (whole << drop), half);
        if (side > 0 || (side == 0 && (!is_exact || (kept & 1) != 0))) ++kept;
    }
    // A carry out of the digits increases the exponent, as it should.
    return (static_cast<std::uint64_t>(exponent - least) << 52) + kept;
}

// Appends the root of `linear`, which has degree 1, to `roots` if it is in (0, 1].
void add_rational(Polynomial linear, std::vector<Root>& roots) {
    const Polynomial::Coefficients ends = linear.on_interval({});
    if (ends[0].is_zero()) return;
    if (ends[1].is_zero()) {
        roots.emplace_back(BinaryFraction{Integer(std::int64_t{1}), 0});
    } else if (ends[0].sign() != ends[1].sign()) {
        const int sign = ends[0].sign();
        Polynomial local = linear;
        roots.emplace_back(std::move(linear), BinaryFraction{}, std::move(local), sign);
    }
}

// Returns the roots in (0, 1] of p, which must have a multiple root. d is gcd(p, p'), of degree at least 1.
std::vector<Root> multiple_roots(const Polynomial& p, const Polynomial& d) {
    std::vector<Root> roots;
    const Integer two(std::int64_t{2}), three(std::int64_t{3});
    if (p.degree() == 2) {
        add_rational({p[1], two * p[2]}, roots);
    } else if (d.degree() == 2) {
        add_rational({p[2], three * p[3]}, roots);
    } else {
        // The sum of the three roots is -p2 / p3. The double root is -d0 / d1, so the single root is -p2 / p3 + 2 d0 /
        // d1.
        add_rational(d, roots);
        add_rational({p[2] * d[1] - two * (d[0] * p[3]), p[3] * d[1]}, roots);
        if (roots.size() == 2 && compare(roots[0], roots[1]) > 0) std::swap(roots[0], roots[1]);
    }
    return roots;
}

// Returns k > 0 such that p has no root in (2^-k, 1]; 0 if no such k is found.
//
// Suppose that a term p_j s^j is larger than all other terms together at s = 2^-k and at s = 1. Then it is larger at
// all s between: each ratio |p_i s^i| / |p_j s^j| is a convex function of log s. At s = 1 the ratio is less than 1/4 if
// p_i has at least three bits less than p_j. At s = 2^-k and for i < j it is less than 1/4 if k (j - i) is at most the
// number of bits beyond these three. For i > j the ratio is smaller at 2^-k than at 1.
int bits_without_roots(const Polynomial& p) {
    for (int j = 1; j <= p.degree(); ++j) {
        const int width = p[j].bit_width();
        int least = std::numeric_limits<int>::max();
        for (int i = 0; i <= p.degree(); ++i) {
            if (i == j || p[i].is_zero()) continue;
            const int shorter_by = width - 3 - p[i].bit_width();
            least = std::min(least, i < j ? shorter_by / (j - i) : shorter_by < 0 ? 0 : least);
        }
        if (least > 0 && least < std::numeric_limits<int>::max()) return least;
    }
    return 0;
}

// Returns the roots of p in (0, 1]. p must have no multiple roots.
std::vector<Root> simple_roots(const Polynomial& p) {
    std::vector<Root> roots;
    const int degree = p.degree();
    struct Open {
        BinaryFraction from;
        Polynomial local;
    };
    std::vector<Open> open;  // the leftmost interval is last
    open.emplace_back().local = p;
    while (!open.empty()) {
        Open top = std::move(open.back());
        open.pop_back();
        // Skips the part above 2^-bits, which contains no root. So the depth of subdivision depends on the number of
        // roots and their distances from each other, not on their distances from 0.
        if (const int bits = bits_without_roots(top.local); bits > 0) {
            top.from = {top.from.m << bits, top.from.bits + bits};
            top.local = top.local.moved_to({{}, bits});
        }
        const Polynomial::Coefficients c = top.local.on_unit_interval();
        const int changes = sign_changes(c, degree);
        if (changes <= 1) {
            const bool ends_at_root = c[static_cast<std::size_t>(degree)].is_zero();
            BinaryFraction end = next(top.from);
            if (changes == 1) roots.emplace_back(p, std::move(top.from), std::move(top.local), first_sign(c));
            if (ends_at_root) roots.emplace_back(std::move(end));
            continue;
        }
        // A root at the middle belongs to the left half, as its end.
        const BinaryFraction left{{}, 1}, right{Integer(std::int64_t{1}), 1};
        const BinaryFraction middle{top.from.m + top.from.m, top.from.bits + 1};
        open.push_back({next(middle), top.local.moved_to(right)});
        open.push_back({middle, top.local.moved_to(left)});
    }
    return roots;
}

}  // namespace

std::vector<Root> roots_in_unit_interval(Polynomial p) {
    p.drop_zeros();
    const int degree = p.degree();
    if (degree <= 0) return {};
    const Polynomial::Coefficients c = p.on_interval({});
    const int changes = sign_changes(c, degree);
    if (changes == 0 && !c[static_cast<std::size_t>(degree)].is_zero()) return {};
    if (changes >= 2) {
        const Polynomial divisor = gcd(p, derivative(p));
        if (divisor.degree() > 0) return multiple_roots(p, divisor);
    }
    return simple_roots(p);
}

std::optional<std::vector<Root>> simple_roots_in(Polynomial p, BinaryFraction from, int count) {
    std::vector<Root> roots;
    const int degree = p.degree();
    if (degree <= 0) return roots;
    p.drop_zeros();
    for (int i = 0; i < count; ++i) {
        Polynomial local = p.moved_to(from);
        const Polynomial::Coefficients c = local.on_unit_interval();
        const int changes = sign_changes(c, degree);
        if (changes > 1) return std::nullopt;
        BinaryFraction end = next(from);
        if (changes == 1) roots.emplace_back(p, from, std::move(local), first_sign(c));
        if (c[static_cast<std::size_t>(degree)].is_zero()) roots.emplace_back(end);
        from = std::move(end);
    }
    return roots;
}

Root::Root(BinaryFraction value) : from_(std::move(value)), is_fraction_(true) {}

Root::Root(Polynomial p, BinaryFraction from, Polynomial local, int sign_below)
    : p_(std::move(p)), from_(std::move(from)), local_(std::move(local)), sign_below_(sign_below) {}

void Root::set_fraction(const BinaryFraction& part) {
    from_ = {(from_.m << part.bits) + part.m, from_.bits + part.bits};
    is_fraction_ = true;
    p_ = local_ = {};
}

void Root::move_to(const BinaryFraction& part) {
    from_ = {(from_.m << part.bits) + part.m, from_.bits + part.bits};
    local_ = local_.moved_to(part);
    local_.drop_zeros();
}

// Interpolates linearly between the values at both ends, by their leading bits. The values have opposite signs, or one
// of them is zero.
std::int64_t Root::guess(int bits) const {
    constexpr int kept = 60;
    const Integer &first = local_[0], last = local_[0] + local_[1] + local_[2] + local_[3];
    const int drop = std::max(0, std::max(first.bit_width(), last.bit_width()) - kept);
    const auto leading = [&](const Integer& x) -> std::uint64_t {
        const Integer high = x >> drop;
        return high.is_zero() ? 0 : high.limbs()[0];
    };
    const std::uint64_t a = leading(first), b = leading(last);
    if (a == 0 && b == 0) return 0;
    const auto part = static_cast<std::int64_t>((Uint128{a} << bits) / (Uint128{a} + b));
    return std::min(part, (std::int64_t{1} << bits) - 1);
}

// Uses quadratic interval refinement (Abbott 2014). If the guessed one of 2^gain_ parts contains the root, the interval
// becomes that part, and gain_ is doubled: so it is where the polynomial is nearly linear. Otherwise the interval and
// gain_ are halved.
void Root::shorten() {
    constexpr int gain_max = 48;
    const auto is_below = [&](std::int64_t m, int bits, int& sign) {
        sign = local_.sign_at({Integer(m), bits});
        return sign == sign_below_;
    };
    const std::int64_t m = guess(gain_), count = std::int64_t{1} << gain_;
    int begin = sign_below_, end = -sign_below_;
    if (m > 0 && !is_below(m, gain_, begin) && begin == 0) return set_fraction({Integer(m), gain_});
    if (begin == sign_below_ && m + 1 < count && !is_below(m + 1, gain_, end) && end == 0) {
        return set_fraction({Integer(m + 1), gain_});
    }
    if (begin == sign_below_ && end != sign_below_) {
        move_to({Integer(m), gain_});
        gain_ = std::min(2 * gain_, gain_max);
        return;
    }
    gain_ = std::max(1, gain_ / 2);
    int middle = 0;
    const bool is_right = is_below(1, 1, middle);
    if (middle == 0) return set_fraction({Integer(std::int64_t{1}), 1});
    move_to({Integer(std::int64_t{is_right}), 1});
}

void Root::refine(int bits) {
    while (!is_fraction_ && from_.bits < bits) shorten();
}

// In the interval the divisor has either this root alone or no root. The number of sign changes exceeds the number of
// its roots by an even number, so an odd count means that it has the root.
bool Root::is_root_of_divisor(const Polynomial& divisor) const {
    const int degree = divisor.degree();
    return degree > 0 && sign_changes(divisor.on_interval(from_), degree) % 2 == 1;
}

int Root::sign_of(const Polynomial& g) {
    const int degree = g.degree();
    if (degree <= 0) return degree < 0 ? 0 : g[0].sign();
    for (int bits = first_bits; !is_fraction_; bits *= 2) {
        if (p_.degree() == 1) return g.sign_at_root_of(p_);
        if (const int sign = common_sign(g.on_interval(from_), degree)) return sign;
        if (bits == 2 * first_bits && is_root_of_divisor(gcd(p_, g))) return 0;
        refine(bits);
    }
    return g.sign_at(from_);
}

int Root::compare_with_fraction(Root& x, const BinaryFraction& y) {
    if (x.is_fraction_) return compare_fractions(x.from_, y);
    if (compare_fractions(y, x.from_) <= 0) return 1;
    if (compare_fractions(y, next(x.from_)) >= 0) return -1;
    const int sign = x.p_.sign_at(y);
    return sign == 0 ? 0 : sign == x.sign_below_ ? 1 : -1;
}

int compare(Root& x, Root& y) {
    for (int bits = first_bits;; bits *= 2) {
        if (y.is_fraction_) return Root::compare_with_fraction(x, y.from_);
        if (x.is_fraction_) return -Root::compare_with_fraction(y, x.from_);
        if (compare_fractions(x.from_, next(y.from_)) >= 0) return 1;
        if (compare_fractions(next(x.from_), y.from_) <= 0) return -1;
        // Both intervals come from repeated halving. If they overlap, one contains the other.
        const Root& inner = x.from_.bits >= y.from_.bits ? x : y;
        if (bits == 2 * first_bits && inner.is_root_of_divisor(gcd(x.p_, y.p_))) return 0;
        x.refine(bits);
        y.refine(bits);
    }
}

double Root::round() {
    // The midpoint of two neighbouring doubles has 54 digits, or is a multiple of 2^-1075. So no midpoint lies strictly
    // inside an interval whose ends have that many digits.
    constexpr int digits = 54, bits_max = 1075;
    while (!is_fraction_ && from_.m.bit_width() < digits && from_.bits < bits_max) shorten();
    if (from_.m.is_zero()) return std::bit_cast<double>(std::uint64_t{1});
    return std::bit_cast<double>(std::max<std::uint64_t>(nearest(from_, is_fraction_), 1));
}

bool Root::is_above(double x) {
    const Dyadic d = decode(x);
    const Integer m(d.m);
    return compare_with_fraction(*this, d.e < 0 ? BinaryFraction{m, -d.e} : BinaryFraction{m << d.e, 0}) > 0;
}

}  // namespace ecods::exact
