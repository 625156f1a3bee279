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
    // How many roots are between two numbers that are none.
    int count(const mpq_class& low, const mpq_class& high) const { return changes(low) - changes(high); }

  private:
    int changes(const mpq_class& x) const {
        int last = 0, count = 0;
        for (const Polynomial& f : sequence_) {
            const int sign = f.sign_at(x);
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

void Root::halve() {
    const mpq_class middle = (low_ + high_) / 2;
    const int sign = polynomial_.sign_at(middle);
    if (sign == 0) {
        low_ = high_ = middle;
    } else {
        (sign == polynomial_.sign_at(low_) ? low_ : high_) = middle;
    }
}

int Root::compare(const mpq_class& x) const {
    if (is_exact()) return cmp(low_, x);
    if (x <= low_) return 1;
    if (x >= high_) return -1;
    const int sign = polynomial_.sign_at(x);
    return sign == 0 ? 0 : sign == polynomial_.sign_at(low_) ? 1 : -1;
}

int Root::compare(Root& other) {
    if (other.is_exact()) return compare(other.low_);
    if (is_exact()) return -other.compare(low_);
    // A common root between the ends of both, which are roots of neither's divisor.
    const mpq_class from = std::max(low_, other.low_), to = std::min(high_, other.high_);
    if (from < to) {
        const Polynomial common = gcd(polynomial_, other.polynomial_);
        if (!common.is_constant() && common.sign_at(from) * common.sign_at(to) < 0) return 0;
    }
    while (low_ < other.high_ && other.low_ < high_) {
        halve();
        if (is_exact()) return -other.compare(low_);
        other.halve();
        if (other.is_exact()) return compare(other.low_);
    }
    return low_ < other.low_ ? -1 : 1;
}

int Root::sign_of(const Polynomial& g) {
    if (g.is_constant()) return g.is_zero() ? 0 : sgn(g.coefficients()[0]);
    if (is_exact()) return g.sign_at(low_);
    const Polynomial common = gcd(polynomial_, g);
    if (!common.is_constant() && common.sign_at(low_) * common.sign_at(high_) < 0) return 0;
    // What is positive of g grows from 0 to 1, and so does what is negative: so they bound g between the ends.
    const auto part = [&](const mpq_class& x, bool is_positive) {
        mpq_class sum = 0;
        for (std::size_t i = g.coefficients().size(); i-- > 0;) {
            sum *= x;
            if ((sgn(g.coefficients()[i]) > 0) == is_positive) sum += g.coefficients()[i];
        }
        return sum;
    };
    for (;;) {
        if (is_exact()) return g.sign_at(low_);
        if (part(low_, true) + part(high_, false) > 0) return 1;
        if (part(high_, true) + part(low_, false) < 0) return -1;
        for (int i = 0; i < 8 && !is_exact(); ++i) halve();
    }
}

double Root::nearest() const {
    if (compare(mpq_class(0)) == 0) return 0;
    // The last double that is not above the root.
    std::uint64_t low = 0, high = std::bit_cast<std::uint64_t>(1.0) + 1;
    while (high - low > 1) {
        const std::uint64_t middle = low + (high - low) / 2;
        (compare(double_of_bits(middle)) >= 0 ? low : high) = middle;
    }
    const int above = compare((double_of_bits(low) + double_of_bits(low + 1)) / 2);
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
    std::vector<std::pair<mpq_class, mpq_class>> open{{0, 1}};
    Sturm sturm(rest);
    while (!open.empty() && !rest.is_constant()) {
        const auto [low, high] = open.back();
        open.pop_back();
        const int count = sturm.count(low, high);
        if (count == 0) continue;
        if (count == 1) {
            roots.emplace_back(rest, low, high);
            continue;
        }
        const mpq_class middle = (low + high) / 2;
        if (rest.sign_at(middle) == 0) {
            roots.emplace_back(middle);
            divide_out(rest, middle);
            sturm = Sturm(rest);
        }
        open.emplace_back(low, middle);
        open.emplace_back(middle, high);
    }
    std::ranges::sort(roots, [](const Root& a, const Root& b) {
        Root x = a, y = b;
        return x.compare(y) < 0;
    });
    return roots;
}

}  // namespace ecods::oracle
