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

int compare_parts(const RootSum& sum) {
    return compare_shifted((sum.x * sum.x * sum.w).limbs(), 2 * (sum.e - sum.f), (sum.y * sum.z * sum.z).limbs());
}

int sign(const RootSum& sum) {
    const int of_x = sum.x.sign(), of_root = sum.root_sign();
    if (of_x == 0 || of_root == 0 || of_x == of_root) return of_x != 0 ? of_x : of_root;
    return of_x * compare_parts(sum);
}

}  // namespace ecods::exact
