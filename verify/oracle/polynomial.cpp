#include "oracle/polynomial.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

namespace ecods::oracle {
namespace {

Polynomial derivative(const Polynomial& f) {
    std::vector<mpz_class> c;
    for (std::size_t i = 1; i <= f.degree(); ++i) c.push_back(f.coefficients()[i] * static_cast<unsigned long>(i));
    return Polynomial(std::move(c));
}

// Without the common divisor of its coefficients; no sign changes.
Polynomial primitive(const Polynomial& f) {
    mpz_class divisor = 0;
    for (const mpz_class& c : f.coefficients()) divisor = gcd(divisor, c);
    if (divisor <= 1) return f;
    std::vector<mpz_class> c = f.coefficients();
    for (mpz_class& x : c) x /= divisor;
    return Polynomial(std::move(c));
}

struct Division {
    Polynomial quotient, remainder;
};

// f times a positive number is quotient * g + remainder; g is not zero.
Division divide(Polynomial f, const Polynomial& g) {
    std::vector<mpz_class> quotient(f.degree() >= g.degree() ? f.degree() - g.degree() + 1 : 0);
    const mpz_class& lead = g.coefficients().back();
    const mpz_class size = abs(lead);
    while (!f.is_zero() && f.degree() >= g.degree()) {
        const std::size_t by = f.degree() - g.degree();
        const mpz_class factor = f.coefficients().back() * sgn(lead);
        std::vector<mpz_class> c = f.coefficients();
        for (mpz_class& x : c) x *= size;
        for (std::size_t i = 0; i <= g.degree(); ++i) c[i + by] -= factor * g.coefficients()[i];
        for (mpz_class& q : quotient) q *= size;
        quotient[by] += factor;
        f = Polynomial(std::move(c));
        if (f.is_constant() && g.is_constant()) break;
    }
    return {Polynomial(std::move(quotient)), std::move(f)};
}

// The roots of f, each once.
Polynomial without_double_roots(const Polynomial& f) {
    const Polynomial common = gcd(f, derivative(f));
    return common.is_constant() ? primitive(f) : primitive(divide(f, common).quotient);
}

class Sturm {
  public:
    explicit Sturm(const Polynomial& f) : sequence_{f, derivative(f)} {
        while (!sequence_.back().is_constant()) {
            const Polynomial rest = divide(sequence_[sequence_.size() - 2], sequence_.back()).remainder;
            if (rest.is_zero()) break;
            sequence_.push_back(primitive(-rest));
        }
    }
    // How many roots are between low / 2^bits and (low + 1) / 2^bits, which are none.
    int count(const mpz_class& low, unsigned long bits) const { return changes(low, bits) - changes(low + 1, bits); }

  private:
    int changes(const mpz_class& num, unsigned long bits) const {
        int last = 0, count = 0;
        for (const Polynomial& f : sequence_) {
            const int sign = f.sign_at(num, bits);
            count += sign * last < 0;
            if (sign != 0) last = sign;
        }
        return count;
    }

    std::vector<Polynomial> sequence_;
};

// Takes the root x out of f, which has it once.
void divide_out(Polynomial& f, const mpq_class& x) {
    f = primitive(divide(f, Polynomial({-x.get_num(), x.get_den()})).quotient);
}

mpq_class double_of_bits(std::uint64_t bits) {
    return {std::bit_cast<double>(bits)};
}

}  // namespace

Polynomial::Polynomial(std::vector<mpz_class> coefficients) : c_(std::move(coefficients)) {
    while (!c_.empty() && sgn(c_.back()) == 0) c_.pop_back();
}

int Polynomial::sign_at(const mpq_class& x) const {
    mpz_class sum = 0, power = 1;
    for (std::size_t i = c_.size(); i-- > 0;) {
        sum = sum * x.get_num() + c_[i] * power;
        power *= x.get_den();
    }
    return sgn(sum);
}

int Polynomial::sign_at(const mpz_class& num, unsigned long bits) const {
    mpz_class sum = 0;
    for (std::size_t i = c_.size(); i-- > 0;) sum = sum * num + (c_[i] << (bits * (c_.size() - 1 - i)));
    return sgn(sum);
}

Polynomial operator+(const Polynomial& f, const Polynomial& g) {
    std::vector<mpz_class> c(std::max(f.c_.size(), g.c_.size()));
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = f.coefficient(i) + g.coefficient(i);
    return Polynomial(std::move(c));
}

Polynomial operator-(const Polynomial& f, const Polynomial& g) {
    std::vector<mpz_class> c(std::max(f.c_.size(), g.c_.size()));
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = f.coefficient(i) - g.coefficient(i);
    return Polynomial(std::move(c));
}

Polynomial operator*(const Polynomial& f, const Polynomial& g) {
    if (f.is_zero() || g.is_zero()) return {};
    std::vector<mpz_class> c(f.c_.size() + g.c_.size() - 1);
    for (std::size_t i = 0; i < f.c_.size(); ++i) {
        for (std::size_t j = 0; j < g.c_.size(); ++j) c[i + j] += f.c_[i] * g.c_[j];
    }
    return Polynomial(std::move(c));
}

Polynomial gcd(const Polynomial& f, const Polynomial& g) {
    Polynomial a = primitive(f), b = primitive(g);
    while (!b.is_zero()) {
        if (b.is_constant()) return Polynomial(1);
        a = primitive(divide(std::move(a), b).remainder);
        std::swap(a, b);
    }
    return a;
}

Polynomial without_factor(Polynomial f, const Polynomial& g) {
    const Polynomial divisor = primitive(g);
    while (f.degree() >= divisor.degree()) {
        Division division = divide(f, divisor);
        if (!division.remainder.is_zero()) break;
        f = primitive(division.quotient);
    }
    return f;
}

// Of a root from 0 to 2^-bits: to the powers of two beside it, which may be far below.
void Root::find_exponent() {
    const auto is_below = [&](unsigned long bits) {
        const int sign = polynomial_.sign_at(1, bits);
        if (sign == 0) {
            number_ = mpq_class(1, mpz_class(1) << bits);
            sign_at_low_ = 0;
        }
        return sign != sign_at_low_;
    };
    unsigned long above = bits_, below = 2 * bits_;  // the root is below 2^-above and, soon, above 2^-below
    for (; is_below(below); below *= 2) above = below;
    while (!is_exact() && below - above > 1) {
        const unsigned long middle = above + (below - above) / 2;
        (is_below(middle) ? above : below) = middle;
    }
    low_ = 1;
    bits_ = below;
}

void Root::halve() {
    if (low_ == 0 && bits_ >= 16) return find_exponent();
    low_ *= 2;
    ++bits_;
    const int sign = polynomial_.sign_at(low_ + 1, bits_);
    if (sign == 0) {
        number_ = mpq_class(low_ + 1, mpz_class(1) << bits_);
        number_.canonicalize();
        sign_at_low_ = 0;
    } else if (sign == sign_at_low_) {
        ++low_;
    }
}

mpq_class Root::end(int which) const {
    mpq_class x(low_ + which, mpz_class(1) << bits_);
    x.canonicalize();
    return x;
}

bool Root::is_root_of(const Polynomial& common) const {
    return !common.is_constant() && common.sign_at(low_, bits_) * common.sign_at(low_ + 1, bits_) < 0;
}

int Root::compare(const mpq_class& x) const {
    if (is_exact()) return cmp(number_, x);
    if (x <= end(0)) return 1;
    if (x >= end(1)) return -1;
    const int sign = polynomial_.sign_at(x);
    return sign == 0 ? 0 : sign == sign_at_low_ ? 1 : -1;
}

int Root::compare(Root& other) {
    if (other.is_exact()) return compare(other.number_);
    if (is_exact()) return -other.compare(number_);
    const auto is_open = [&] { return end(0) < other.end(1) && other.end(0) < end(1); };
    // Most roots differ early; of one that both have the divisor of both has it, where both are.
    bool may_be_equal = true;
    for (int i = 0; is_open(); ++i) {
        Root& wider = bits_ < other.bits_ ? *this : other;
        if (may_be_equal && i >= 32 && bits_ == other.bits_) {
            if (low_ == other.low_ && is_root_of(gcd(polynomial_, other.polynomial_))) return 0;
            may_be_equal = false;
        }
        wider.halve();
        if (is_exact()) return -other.compare(number_);
        if (other.is_exact()) return compare(other.number_);
    }
    return end(0) < other.end(0) ? -1 : 1;
}

// What is positive of g grows from 0 to 1, and so does what is negative: so they bound g between the ends.
int Root::sign_around(const Polynomial& g) const {
    mpz_class least = 0, most = 0;  // times 2^(bits * degree)
    const mpz_class high = low_ + 1;
    const std::vector<mpz_class>& c = g.coefficients();
    for (const bool is_positive : {true, false}) {
        mpz_class at_low = 0, at_high = 0;
        for (std::size_t i = c.size(); i-- > 0;) {
            at_low *= low_;
            at_high *= high;
            if ((sgn(c[i]) > 0) != is_positive) continue;
            const mpz_class scaled = c[i] << (bits_ * (c.size() - 1 - i));
            at_low += scaled;
            at_high += scaled;
        }
        least += is_positive ? at_low : at_high;
        most += is_positive ? at_high : at_low;
    }
    return sgn(least) > 0 ? 1 : sgn(most) < 0 ? -1 : 0;
}

int Root::sign_of(const Polynomial& g) {
    if (g.is_constant()) return g.is_zero() ? 0 : sgn(g.coefficients()[0]);
    for (int round = 0;; ++round) {
        if (is_exact()) return g.sign_at(number_);
        if (const int sign = sign_around(g); sign != 0) return sign;
        if (round == 2 && is_root_of(gcd(polynomial_, g))) return 0;
        for (int i = 0; i < 20 && !is_exact(); ++i) halve();
    }
}

double Root::nearest() const {
    if (compare(mpq_class(0)) == 0) return 0;
    Root narrow = *this;
    for (int i = 0; i < 64 && !narrow.is_exact(); ++i) narrow.halve();
    // The last double that is not above the root: from that below the lower end on, and before the one above the
    // upper.
    const auto bits_below = [](const mpq_class& x) { return std::bit_cast<std::uint64_t>(x.get_d()); };
    std::uint64_t low = bits_below(narrow.low());
    std::uint64_t high = bits_below(narrow.is_exact() ? narrow.number_ : narrow.end(1)) + 1;
    while (high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        (narrow.compare(double_of_bits(middle)) >= 0 ? low : high) = middle;
    }
    const int above = narrow.compare((double_of_bits(low) + double_of_bits(low + 1)) / 2);
    const bool is_up = above > 0 || (above == 0 && low % 2 == 1) || low == 0;
    return std::bit_cast<double>(low + (is_up ? 1 : 0));
}

bool has_one_sign(const Polynomial& f) {
    if (f.degree() > 3) return false;
    const mpz_class c0 = f.coefficient(0), c1 = f.coefficient(1), c2 = f.coefficient(2), c3 = f.coefficient(3);
    const int sign = sgn(c0);  // of the first of the Bernstein coefficients, between which its values are
    return sign != 0 && sgn(mpz_class(3 * c0 + c1)) == sign && sgn(mpz_class(3 * c0 + 2 * c1 + c2)) == sign &&
           sgn(mpz_class(c0 + c1 + c2 + c3)) == sign;
}

std::vector<Root> roots_to_one(const Polynomial& f) {
    std::vector<Root> roots;
    if (f.is_constant() || has_one_sign(f)) return roots;
    Polynomial rest = without_double_roots(f);
    for (const int end : {0, 1}) {
        if (rest.sign_at(end) != 0) continue;
        roots.emplace_back(mpq_class(end));
        divide_out(rest, end);
    }
    struct Open {
        mpz_class low;
        unsigned long bits;
    };
    std::vector<Open> open{{0, 0}};
    Sturm sturm(rest);
    while (!open.empty() && !rest.is_constant()) {
        const auto [low, bits] = open.back();
        open.pop_back();
        const int count = sturm.count(low, bits);
        if (count == 0) continue;
        if (rest.degree() == 1) {
            mpq_class number(-rest.coefficient(0), rest.coefficient(1));
            number.canonicalize();
            roots.emplace_back(number);
            break;
        }
        if (count == 1) {
            roots.emplace_back(rest, low, bits);
            continue;
        }
        const mpz_class middle = 2 * low + 1;
        if (rest.sign_at(middle, bits + 1) == 0) {
            mpq_class number(middle, mpz_class(1) << (bits + 1));
            roots.emplace_back(number);
            divide_out(rest, number);
            sturm = Sturm(rest);
        }
        open.push_back({2 * low, bits + 1});
        open.push_back({middle, bits + 1});
    }
    std::ranges::sort(roots, [](const Root& a, const Root& b) {
        Root x = a, y = b;
        return x.compare(y) < 0;
    });
    return roots;
}

}  // namespace ecods::oracle
