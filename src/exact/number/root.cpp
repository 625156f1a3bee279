// Roots are isolated by sign changes of Bernstein coefficients (Collins and Akritas, Polynomial real root isolation
// using Descartes's rule of signs, SYMSAC 1976). The isolation terminates for polynomials without multiple roots.
//
// A polynomial p with multiple roots is the product of polynomials without multiple roots, one for each multiplicity,
// which divisions by greatest common divisors find (Musser, Multivariate polynomial factorization, 1975).
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

template <std::size_t count>
int first_sign(const std::array<Integer, count>& coefficients) {
    for (const Integer& c : coefficients) {
        if (const int sign = c.sign()) return sign;
    }
    return 0;
}

// Returns the sign of the coefficients if all have the same sign; 0 if signs differ or a coefficient is zero.
template <std::size_t count>
int common_sign(const std::array<Integer, count>& coefficients, int degree) {
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

// Returns k > 0 such that p has no root in (2^-k, 1]; 0 if no such k is found.
//
// Suppose that a term p_j s^j is larger than all other terms together at s = 2^-k and at s = 1. Then it is larger at
// all s between: each ratio |p_i s^i| / |p_j s^j| is a convex function of log s. At s = 1 the ratio is less than 1/4 if
// p_i has at least three bits less than p_j. At s = 2^-k and for i < j it is less than 1/4 if k (j - i) is at most the
// number of bits beyond these three. For i > j the ratio at 2^-k is smaller than at 1.
template <class P>
int bits_without_roots(const P& p) {
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
template <class P>
std::vector<RootOf<P>> simple_roots(const P& p) {
    std::vector<RootOf<P>> roots;
    const int degree = p.degree();
    struct Open {
        BinaryFraction from;
        P local;
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
        const auto c = top.local.on_unit_interval();
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

// Appends to `roots` the roots in (0, 1] of p, which must have no multiple roots. `roots` must not contain a root of p
// yet.
template <class P>
void add_simple_roots(const P& p, std::vector<RootOf<P>>& roots) {
    for (RootOf<P>& root : simple_roots(p)) {
        auto next = roots.end();
        while (next != roots.begin() && compare(*(next - 1), root) > 0) --next;
        roots.insert(next, std::move(root));
    }
}

// Returns the roots in (0, 1] of p. d is gcd(p, p'), of degree at least 1: its roots have one multiplicity less.
template <class P>
std::vector<RootOf<P>> multiple_roots(const P& p, P d) {
    std::vector<RootOf<P>> roots;
    for (P all = quotient(p, d); all.degree() > 0;) {
        // `all` has the roots that have not been found, each once; `again` has the common roots of `all` and d.
        P again = gcd(all, d);
        if (again.degree() < all.degree()) add_simple_roots(quotient(all, again), roots);
        if (again.degree() > 0) d = quotient(d, again);
        all = std::move(again);
    }
    return roots;
}

}  // namespace

template <class P>
std::vector<RootOf<P>> roots_in_unit_interval(P p) {
    p.drop_zeros();
    const int degree = p.degree();
    if (degree <= 0) return {};
    const auto c = p.on_interval({});
    const int changes = sign_changes(c, degree);
    if (changes == 0 && !c[static_cast<std::size_t>(degree)].is_zero()) return {};
    if (changes >= 2) {
        const P slope = derivative(p);
        if (!are_coprime(p, slope)) {
            P divisor = gcd(p, slope);
            if (divisor.degree() > 0) return multiple_roots(p, std::move(divisor));
        }
    }
    return simple_roots(p);
}

template <class P>
std::optional<std::vector<RootOf<P>>> simple_roots_in(P p, BinaryFraction from, int count) {
    std::vector<RootOf<P>> roots;
    const int degree = p.degree();
    if (degree <= 0) return roots;
    p.drop_zeros();
    for (int i = 0; i < count; ++i) {
        P local = p.moved_to(from);
        const auto c = local.on_unit_interval();
        const int changes = sign_changes(c, degree);
        if (changes > 1) return std::nullopt;
        BinaryFraction end = next(from);
        if (changes == 1) roots.emplace_back(p, from, std::move(local), first_sign(c));
        if (c[static_cast<std::size_t>(degree)].is_zero()) roots.emplace_back(end);
        from = std::move(end);
    }
    return roots;
}

template <class P>
RootOf<P>::RootOf(BinaryFraction value) : from_(std::move(value)), is_fraction_(true) {}

template <class P>
RootOf<P>::RootOf(P p, BinaryFraction from, P local, int sign_below)
    : p_(std::move(p)), from_(std::move(from)), local_(std::move(local)), sign_below_(sign_below) {}

template <class P>
void RootOf<P>::set_fraction(const BinaryFraction& part) {
    from_ = {(from_.m << part.bits) + part.m, from_.bits + part.bits};
    is_fraction_ = true;
    p_ = local_ = {};
}

template <class P>
void RootOf<P>::move_to(const BinaryFraction& part) {
    from_ = {(from_.m << part.bits) + part.m, from_.bits + part.bits};
    local_ = local_.moved_to(part);
    local_.drop_zeros();
}

// Returns the part in which the linear interpolation between the values at both ends is zero, from the values' leading
// bits. The values have opposite signs, or one value is zero.
template <class P>
std::int64_t RootOf<P>::guess(int bits) const {
    constexpr int kept = 60;
    const Integer& first = local_[0];
    Integer last = first;
    for (int i = 1; i <= P::degree_max; ++i) last = last + local_[i];
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

// Shortens the interval by quadratic interval refinement (Abbott 2014). If the guessed one of 2^gain_ parts contains
// the root, as happens if the polynomial is nearly linear, the interval becomes that part, and gain_ is doubled.
// Otherwise the interval and gain_ are halved.
template <class P>
void RootOf<P>::shorten() {
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

template <class P>
void RootOf<P>::refine(int bits) {
    while (!is_fraction_ && from_.bits < bits) shorten();
}

// Returns true if this number is a root of the divisor, which has either this root alone or no root in the interval.
// The number of sign changes exceeds the number of the divisor's roots by an even number, so an odd count proves the
// root.
template <class P>
bool RootOf<P>::is_root_of_divisor(const P& divisor) const {
    const int degree = divisor.degree();
    return degree > 0 && sign_changes(divisor.on_interval(from_), degree) % 2 == 1;
}

template <class P>
int RootOf<P>::sign_of(const P& g) {
    const int degree = g.degree();
    if (degree <= 0) return degree < 0 ? 0 : g[0].sign();
    for (int bits = first_bits; !is_fraction_; bits *= 2) {
        if (p_.degree() == 1) return g.sign_at_root_of(p_);
        if (const int sign = common_sign(g.on_interval(from_), degree)) return sign;
        if (bits == 2 * first_bits && !are_coprime(p_, g) && is_root_of_divisor(gcd(p_, g))) return 0;
        refine(bits);
    }
    return g.sign_at(from_);
}

template <class P>
int RootOf<P>::compare_with_fraction(RootOf& x, const BinaryFraction& y) {
    if (x.is_fraction_) return compare_fractions(x.from_, y);
    if (compare_fractions(y, x.from_) <= 0) return 1;
    if (compare_fractions(y, next(x.from_)) >= 0) return -1;
    const int sign = x.p_.sign_at(y);
    return sign == 0 ? 0 : sign == x.sign_below_ ? 1 : -1;
}

template <class P>
int RootOf<P>::compare_roots(RootOf& x, RootOf& y) {
    for (int bits = first_bits;; bits *= 2) {
        if (y.is_fraction_) return compare_with_fraction(x, y.from_);
        if (x.is_fraction_) return -compare_with_fraction(y, x.from_);
        if (compare_fractions(x.from_, next(y.from_)) >= 0) return 1;
        if (compare_fractions(next(x.from_), y.from_) <= 0) return -1;
        // Both intervals come from repeated halving. If they overlap, one contains the other.
        const RootOf& inner = x.from_.bits >= y.from_.bits ? x : y;
        if (bits == 2 * first_bits && !are_coprime(x.p_, y.p_) && inner.is_root_of_divisor(gcd(x.p_, y.p_))) {
            return 0;
        }
        x.refine(bits);
        y.refine(bits);
    }
}

template <class P>
double RootOf<P>::round() {
    // The midpoint of two neighbouring doubles has 54 digits, or is a multiple of 2^-1075. So no midpoint lies strictly
    // inside an interval whose ends have that many digits.
    constexpr int digits = 54, bits_max = 1075;
    while (!is_fraction_ && from_.m.bit_width() < digits && from_.bits < bits_max) shorten();
    if (from_.m.is_zero()) return std::bit_cast<double>(std::uint64_t{1});
    return std::bit_cast<double>(std::max<std::uint64_t>(nearest(from_, is_fraction_), 1));
}

template <class P>
bool RootOf<P>::is_above(double x) {
    const Dyadic d = decode(x);
    const Integer m(d.m);
    return compare_with_fraction(*this, d.e < 0 ? BinaryFraction{m, -d.e} : BinaryFraction{m << d.e, 0}) > 0;
}

template class RootOf<Polynomial>;
template class RootOf<Quintic>;
template std::vector<Root> roots_in_unit_interval(Polynomial);
template std::vector<RootOf<Quintic>> roots_in_unit_interval(Quintic);
template std::optional<std::vector<Root>> simple_roots_in(Polynomial, BinaryFraction, int);
template std::optional<std::vector<RootOf<Quintic>>> simple_roots_in(Quintic, BinaryFraction, int);

}  // namespace ecods::exact
