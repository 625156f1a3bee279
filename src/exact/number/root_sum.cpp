#include "exact/number/root_sum.hpp"

#include "base/assert.hpp"

namespace ecods::exact {

RootSum root_sum(const ScaledInteger& whole, const Integer& den, const ScaledInteger& length,
                 const ScaledInteger& square) {
    ECODS_ASSERT(square.e() % 2 == 0);
    RootSum sum;
    sum.x = whole.m();
    sum.z = den;
    sum.e = whole.e();
    sum.y = length.m() * length.m();
    sum.w = square.m();
    sum.f = length.e() - square.e() / 2;
    sum.is_subtracted = length.sign() < 0;
    return sum;
}

RootSum root_quotient(const ScaledInteger& x, const ScaledInteger& y, const ScaledInteger& z, bool is_subtracted) {
    ECODS_ASSERT(y.e() % 2 == 0);
    RootSum sum;
    sum.x = x.m();
    sum.z = z.m();
    sum.e = x.e() - z.e();
    sum.y = y.m();
    sum.w = z.m() * z.m();
    sum.f = y.e() / 2 - z.e();
    sum.is_subtracted = is_subtracted;
    return sum;
}

int compare_parts(const RootSum& sum) {
    return compare_shifted((sum.x * sum.x * sum.w).limbs(), 2 * (sum.e - sum.f), (sum.y * sum.z * sum.z).limbs());
}

int sign(const RootSum& sum) {
    const int of_x = sum.x.sign(), of_root = sum.root_sign();
    if (of_x == 0 || of_root == 0 || of_x == of_root) return of_x != 0 ? of_x : of_root;
    return of_x * compare_parts(sum);
}

RootSum affine(const ScaledInteger& factor, const RootSum& sum, const ScaledInteger& more) {
    RootSum result = sum;
    const ScaledInteger x = ScaledInteger(sum.x, sum.e) * factor + ScaledInteger(sum.z, 0) * more;
    result.x = x.m();
    result.e = x.e();
    result.y = sum.y * factor.m() * factor.m();
    result.f = sum.f + factor.e();
    result.is_subtracted = sum.is_subtracted != (factor.sign() < 0);
    return result;
}

int compare(const RootSum& a, const ScaledInteger& b) {
    return sign(affine(ScaledInteger(1.0), a, -b));
}

// Returns the sign of a - b. All numbers are multiplied by z z', where a has z and w, and b has z' and w'; squares are
// multiplied by (z z')^2 w w'.
int compare(const RootSum& a, const RootSum& b) {
    const Integer zz = a.z * b.z, scale = zz * zz;
    const ScaledInteger u = ScaledInteger(a.x * b.z, a.e) - ScaledInteger(b.x * a.z, b.e);
    const ScaledInteger uu = u * u * ScaledInteger(a.w * b.w, 0);
    const ScaledInteger rr(a.y * scale * b.w, 2 * a.f), qq(b.y * scale * a.w, 2 * b.f);
    const int of_r = a.root_sign(), of_q = b.root_sign();
    const int first = u.sign() * of_r >= 0 ? (u.sign() != 0 ? u.sign() : of_r) : u.sign() * compare(uu, rr);
    if (first != of_q) return first < of_q ? -1 : 1;
    if (first == 0) return 0;
    const ScaledInteger rest = uu + rr - qq;
    const int of_rest = rest.sign(), of_product = u.sign() * of_r;
    if (of_rest * of_product >= 0) return first * (of_rest != 0 ? of_rest : of_product);
    return first * of_rest * compare(rest * rest, ScaledInteger(4.0) * uu * rr);
}

}  // namespace ecods::exact
