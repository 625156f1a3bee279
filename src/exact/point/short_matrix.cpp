#include "exact/point/short_matrix.hpp"

#include <algorithm>
#include <cstdlib>

#include "base/outward.hpp"

namespace ecods::exact {
namespace {

// Returns the biased exponent of the largest |entry|; 0 if an entry is too small to be converted, but not zero. Reads
// bits, because the processor may take subnormal numbers for zero.
int biased_exponent(const Mat3& R) noexcept {
    constexpr std::uint64_t least = magnitude_of(0x1p-500);
    std::uint64_t most = 0;
    bool are_ordinary = true;
    for (int i = 0; i < 9; ++i) {
        const std::uint64_t size = magnitude_of(R.data()[i]);
        most = std::max(most, size);
        are_ordinary &= size == 0 || size >= least;
    }
    return are_ordinary ? static_cast<int>(most >> 52) : 0;
}

}  // namespace

bool ShortMatrix::bind(const Mat3& R) noexcept {
    const int biased = biased_exponent(R), up = short_bits - (biased - 1022);
    if (biased == 0 || std::abs(up) > short_power_max) return false;
    unit_ = -up;
    const double power = power_of_two(up);
    bool are_short = true;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k) {
            const double r = R(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k));
            are_short &= to_short(r, power, rows_[row][k]);
        }
    }
    return are_short;
}

// Sets the unit of short products, 2^unit_, to 2^-124 times an upper bound of all |R_ij| times an upper bound of all
// |v_j|. So a product that is not zero is at least 2^unit_ and at most 2^(unit_ + 124). It is also a multiple of the
// caller's 2^unit and less than 2^(unit + 120), so add() shifts by less than 128 bits.
void ShortProducts::bind(const Mat3& R, const std::array<BitRange, 3>& v, const BitRange& products) noexcept {
    is_bound_ = true;
    BitRange all;
    for (const BitRange& range : v) all.include(range);
    const int up = short_bits - all.high;
    are_short_ = !products.empty() && all.width() <= short_bits && std::abs(up) <= short_power_max && R_.bind(R);
    if (!are_short_) return;
    power_of_v_ = power_of_two(up);
    unit_ = R_.unit() - up;
}

}  // namespace ecods::exact
