#include "oracle/rounded.hpp"

#include <bit>
#include <cstdint>
#include <optional>

namespace ecods::oracle {
namespace {

mpq_class times_power(const mpz_class& num, const mpz_class& den, long exponent) {
    mpz_class n = num, d = den;
    exponent >= 0 ? n <<= static_cast<unsigned long>(exponent) : d <<= static_cast<unsigned long>(-exponent);
    mpq_class result(n, d);
    result.canonicalize();
    return result;
}

}  // namespace

mpq_class exactly(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t biased = bits >> 52 & 0x7ff, low = bits & 0xfffffffffffff;
    const std::uint64_t size = biased == 0 ? low : low | std::uint64_t{1} << 52;
    const mpq_class result =
        times_power(static_cast<unsigned long>(size), 1, static_cast<long>(biased == 0 ? 1 : biased) - 1075);
    return bits >> 63 != 0 ? mpq_class(-result) : result;
}

mpq_class middle_above(std::uint64_t bits) {
    const mpq_class x = exactly(std::bit_cast<double>(bits));
    const std::uint64_t exponent = bits >> 52;
    return x + times_power(1, 1, static_cast<long>(exponent == 0 ? 1 : exponent) - 1076);
}

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

namespace {

// nearest(), but no number other than 0 becomes a zero.
double nearest_signed(const FractionAndRoot& number) {
    const double rounded = nearest(number);
    const int sign = number.sign();
    if (std::bit_cast<std::uint64_t>(rounded) != 0 || sign == 0) return rounded;
    return std::bit_cast<double>(std::uint64_t{1} | (sign < 0 ? std::uint64_t{1} << 63 : 0));
}

}  // namespace

double RoundedDistance::signed_distance(bool inside) const {
    const mpq_class radii = radius_[0] + radius_[1];
    return nearest_signed(inside ? FractionAndRoot{-radii, -1, square_} : FractionAndRoot{-radii, 1, square_});
}

Points posed_points(const Mesh& mesh, const Pose& pose) {
    Points points;
    for (const Vec3& v : mesh.vertices()) {
        Vector<mpq_class>& point = points.emplace_back();
        for (Eigen::Index row = 0; row < 3; ++row) {
            mpq_class& x = point[static_cast<std::size_t>(row)];
            x = exactly(pose.t[row]);
            for (Eigen::Index k = 0; k < 3; ++k) x += exactly(pose.R(row, k)) * exactly(v[k]);
        }
    }
    return points;
}

mpq_class squared_depth(const Points& a, const Points& b) {
    Points all;
    for (const auto& p : a) {
        for (const auto& q : b) all.push_back(p - q);
    }
    std::optional<mpq_class> least;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t j = i + 1; j < all.size(); ++j) {
            for (std::size_t k = j + 1; k < all.size(); ++k) {
                const auto n = cross(Vector<mpq_class>(all[j] - all[i]), Vector<mpq_class>(all[k] - all[i]));
                const mpq_class square = dot(n, n), height = dot(n, all[i]);
                if (sgn(square) == 0) continue;
                const mpq_class distance = height * height / square;
                if (least && distance >= *least) continue;
                bool has_before = false, has_beyond = false;
                for (const auto& point : all) {
                    const int side = cmp(mpq_class(dot(n, point)), height);
                    has_before = has_before || side < 0;
                    has_beyond = has_beyond || side > 0;
                }
                if (!has_before || !has_beyond) least = distance;
            }
        }
    }
    return least.value_or(0);
}

double minus_depth(const mpq_class& squared_depth, double radius_a, double radius_b) {
    return nearest_signed({-(exactly(radius_a) + exactly(radius_b)), -1, squared_depth});
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
