#include "oracle/integer_points.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ecods::oracle {
namespace {

// An odd number times a power of two, or zero.
struct Binary {
    long mantissa = 0;
    int exponent = 0;

    explicit Binary(double x) {
        if (x == 0) return;
        const double fraction = std::frexp(x, &exponent);
        mantissa = static_cast<long>(std::ldexp(fraction, 53));
        exponent -= 53;
        while (mantissa % 2 == 0) {
            mantissa /= 2;
            ++exponent;
        }
    }
};

struct BinaryPose {
    std::array<std::array<Binary, 4>, 3> rows;

    explicit BinaryPose(const Pose& pose) : rows{row(pose, 0), row(pose, 1), row(pose, 2)} {}

    static std::array<Binary, 4> row(const Pose& pose, int k) {
        return {Binary(pose.R(k, 0)), Binary(pose.R(k, 1)), Binary(pose.R(k, 2)), Binary(pose.t[k])};
    }
};

std::vector<bool> used_vertices(const Soup& soup) {
    std::vector<bool> used(soup.vertices.size());
    for (const Triangle& triangle : soup.triangles) {
        for (const std::uint32_t vertex : triangle) used[vertex] = true;
    }
    return used;
}

constexpr long none = std::numeric_limits<int>::max();

// The largest power of two of which all summands of all posed coordinates are multiples.
long unit_of(const Soup& soup, const BinaryPose& pose, const std::vector<bool>& used) {
    std::array<long, 3> least{none, none, none};
    for (std::size_t i = 0; i < used.size(); ++i) {
        for (int k = 0; used[i] && k < 3; ++k) {
            const Binary x(soup.vertices[i][k]);
            if (x.mantissa != 0) least[k] = std::min<long>(least[k], x.exponent);
        }
    }
    long unit = none;
    for (const auto& row : pose.rows) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (row[k].mantissa != 0 && least[k] != none) unit = std::min(unit, row[k].exponent + least[k]);
        }
        if (row[3].mantissa != 0) unit = std::min<long>(unit, row[3].exponent);
    }
    return unit;  // `none` if the body is the origin
}

mpz_class coordinate(const std::array<Binary, 4>& row, const std::array<Binary, 3>& v, long unit) {
    mpz_class sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        if (row[k].mantissa == 0 || v[k].mantissa == 0) continue;
        mpz_class product = row[k].mantissa;
        product *= v[k].mantissa;
        sum += product << (row[k].exponent + v[k].exponent - unit);
    }
    if (row[3].mantissa != 0) sum += mpz_class(row[3].mantissa) << (row[3].exponent - unit);
    return sum;
}

std::vector<Vector<mpz_class>> pose_points(const Soup& soup, const BinaryPose& pose, const std::vector<bool>& used,
                                           long unit) {
    std::vector<Vector<mpz_class>> points(used.size());
    for (std::size_t i = 0; i < used.size(); ++i) {
        if (!used[i]) continue;
        const Vec3& v = soup.vertices[i];
        const std::array<Binary, 3> numbers{Binary(v[0]), Binary(v[1]), Binary(v[2])};
        for (std::size_t k = 0; k < 3; ++k) points[i][k] = coordinate(pose.rows[k], numbers, unit);
    }
    return points;
}

}  // namespace

Interval interval_around(const mpz_class& x, long shift) {
    if (sgn(x) == 0) return 0;
    long exponent = 0;
    const double size = std::abs(mpz_get_d_2exp(&exponent, x.get_mpz_t()));  // 53 digits; the rest is cut off
    // Products of two stay far from what underflows; a wider interval is never wrong.
    constexpr int tiny = -400;
    if (exponent + shift < tiny) return Interval(-std::ldexp(1.0, tiny), std::ldexp(1.0, tiny));
    const int by = static_cast<int>(exponent + shift);
    const bool is_whole = mpz_sizeinbase(x.get_mpz_t(), 2) - mpz_scan1(x.get_mpz_t(), 0) <= 53;
    const double low = std::ldexp(size, by), high = is_whole ? low : std::ldexp(size + 0x1p-53, by);
    return sgn(x) > 0 ? Interval(low, high) : Interval(-high, -low);
}

CommonIntegers::CommonIntegers(std::span<const Soup> soups) {
    unit = none;
    for (const Soup& soup : soups) unit = std::min(unit, unit_of(soup, BinaryPose(soup.pose), used_vertices(soup)));
    if (unit == none) unit = 0;
    for (const Soup& soup : soups) {
        points.push_back(pose_points(soup, BinaryPose(soup.pose), used_vertices(soup), unit));
    }
}

IntegerPoints::IntegerPoints(const Soup& a, const Soup& b) {
    const std::array<Soup, 2> soups{a, b};
    CommonIntegers common(soups);
    unit = common.unit;
    for (std::size_t s = 0; s < 2; ++s) exact[s] = std::move(common.points[s]);
    const std::array<std::vector<bool>, 2> used{used_vertices(a), used_vertices(b)};

    const Vector<mpz_class> origin = exact[0][a.triangles[0][0]];
    std::size_t digits = 1;
    for (std::size_t s = 0; s < 2; ++s) {
        for (std::size_t i = 0; i < used[s].size(); ++i) {
            for (std::size_t k = 0; used[s][i] && k < 3; ++k) {
                digits = std::max(digits, mpz_sizeinbase(mpz_class(exact[s][i][k] - origin[k]).get_mpz_t(), 2));
            }
        }
    }
    const long own_scale = static_cast<long>(digits);
    scale = unit + own_scale;
    for (std::size_t s = 0; s < 2; ++s) {
        around[s].resize(used[s].size());
        for (std::size_t i = 0; i < used[s].size(); ++i) {
            for (std::size_t k = 0; used[s][i] && k < 3; ++k) {
                around[s][i][k] = interval_around(exact[s][i][k] - origin[k], -own_scale);
            }
        }
    }
}

}  // namespace ecods::oracle
