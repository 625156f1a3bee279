#include "oracle/rounded.hpp"

#include <bit>
#include <cstdint>

namespace ecods::oracle {
namespace {

mpq_class times_power(const mpz_class& num, const mpz_class& den, long exponent) {
    mpz_class n = num, d = den;
    exponent >= 0 ? n <<= static_cast<unsigned long>(exponent) : d <<= static_cast<unsigned long>(-exponent);
    mpq_class result(n, d);
    result.canonicalize();
    return result;
}

// Without the processor's conversion, which may take a subnormal number for zero.
mpq_class exactly(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t biased = bits >> 52 & 0x7ff, low = bits & 0xfffffffffffff;
    const std::uint64_t size = biased == 0 ? low : low | std::uint64_t{1} << 52;
    const mpq_class result =
        times_power(static_cast<unsigned long>(size), 1, static_cast<long>(biased == 0 ? 1 : biased) - 1075);
    return bits >> 63 != 0 ? mpq_class(-result) : result;
}

// The middle of the double of these bits and the next one; of the largest double and 2^1024.
mpq_class middle_above(std::uint64_t bits) {
    const mpq_class x = exactly(std::bit_cast<double>(bits));
    const std::uint64_t exponent = bits >> 52;
    return x + times_power(1, 1, static_cast<long>(exponent == 0 ? 1 : exponent) - 1076);
}

}  // namespace

int FractionAndRoot::sign() const {
    const int of_fraction = sgn(fraction), of_root = sgn(square) == 0 ? 0 : sgn(factor);
    if (of_fraction * of_root >= 0) return of_fraction != 0 ? of_fraction : of_root;
    return of_fraction * cmp(mpq_class(fraction * fraction), mpq_class(factor * factor * square));
}

double nearest(const FractionAndRoot& number) {
    const int sign = number.sign() > 0 ? 1 : number.sign() < 0 ? -1 : 0;
    if (sign == 0) return 0;
    const auto is_beyond = [&](std::uint64_t bits) {  // that the size rounds to more than the double of these bits
        FractionAndRoot rest = number;
        rest.fraction -= sign * middle_above(bits);
        const int above = sign * rest.sign();
        return above > 0 || (above == 0 && bits % 2 != 0);
    };
    std::uint64_t low = 0, high = 0x7ff0000000000000;  // the answer is in [low, high]
    while (low < high) {
        const std::uint64_t middle = low + (high - low) / 2;
        is_beyond(middle) ? low = middle + 1 : high = middle;
    }
    return std::bit_cast<double>(sign < 0 && low != 0 ? low | std::uint64_t{1} << 63 : low);
}

RoundedDistance::RoundedDistance(const ExactClosest& cores, double radius_a, double radius_b)
    : square_(times_power(cores.distance.num, cores.distance.den, 2 * cores.distance.unit)),
      radius_{exactly(radius_a), exactly(radius_b)} {
    const std::array points{&cores.point_a, &cores.point_b};
    for (std::size_t body = 0; body < 2; ++body) {
        for (std::size_t k = 0; k < 3; ++k) {
            const ExactFraction& x = points[body]->x[k];
            core_point_[body][k] = times_power(x.num, x.den, x.unit);
        }
    }
}

int RoundedDistance::compare(double d) const {
    return FractionAndRoot{-(radius_[0] + radius_[1] + exactly(d)), 1, square_}.sign();
}

double RoundedDistance::distance() const {
    if (compare(0) <= 0) return 0;
    const double rounded = nearest(FractionAndRoot{-(radius_[0] + radius_[1]), 1, square_});
    return std::bit_cast<std::uint64_t>(rounded) == 0 ? std::bit_cast<double>(std::uint64_t{1}) : rounded;
}

Vec3 RoundedDistance::point(std::size_t body) const {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const mpq_class along = core_point_[1 - body][k] - core_point_[body][k];
        result[static_cast<Eigen::Index>(k)] =
            nearest(FractionAndRoot{core_point_[body][k], radius_[body] * along, 1 / square_});
    }
    return result;
}

}  // namespace ecods::oracle
