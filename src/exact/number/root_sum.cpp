#include "exact/number/root_sum.hpp"

namespace ecods::exact {

int compare_parts(const RootSum& sum) {
    return compare_shifted((sum.x * sum.x * sum.w).limbs(), 2 * (sum.e - sum.f), (sum.y * sum.z * sum.z).limbs());
}

int sign(const RootSum& sum) {
    const int of_x = sum.x.sign(), of_root = sum.root_sign();
    if (of_x == 0 || of_root == 0 || of_x == of_root) return of_x != 0 ? of_x : of_root;
    return of_x * compare_parts(sum);
}

}  // namespace ecods::exact
