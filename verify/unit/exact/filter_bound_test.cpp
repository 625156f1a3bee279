// The bounds of the filter against errors that are really made: never too small, and not found so by luck.
//
// Random numbers come nowhere near a bound, and would not notice one that is 100 times too small. So errors are
// searched for: coordinates, and the rounding mode, are changed wherever that makes the error larger. Each test demands
// of the search, too, that it comes within some factor of the bound: a bound that is too small by more is found.

#include "exact/sign/filter_bound.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cfenv>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <regex>
#include <string>

#include "exact/number/dyadic.hpp"
#include "exact/point/point.hpp"
#include "exact/sign/plain_signs.hpp"
#include "scenes/random.hpp"

namespace ecods::exact::filter_bound_test {
namespace {

using scenes::Random;
using Integer = boost::multiprecision::int512_t;

constexpr std::array rounding_modes{FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};

// x in units of 2^-exponent. It must be a whole number of them.
Integer in_units(double x, int exponent) {
    const Dyadic d = decode(x);
    const int shift = d.e + exponent;
    EXPECT_GE(shift, 0);
    return Integer(d.m) << shift;
}

double to_double(const Integer& x, int exponent) {
    return std::ldexp(x.convert_to<double>(), -exponent);
}

// What is evaluated in a rounding mode must neither be moved out of it nor folded by the compiler.
template <class Evaluate>
[[gnu::noinline]] double in_mode(int mode, Evaluate evaluate) {
    std::fesetround(mode);
    asm volatile("" ::: "memory");
    const double result = evaluate();
    volatile double kept = result;
    asm volatile("" ::: "memory");
    std::fesetround(FE_TONEAREST);
    return kept;
}

// A double of up to 53 bits in [-1, 1], a multiple of 2^-53; simple ones among them.
double coordinate(Random& random) {
    switch (random.below(6)) {
        case 0:
            return random.below(3) - 1.0;
        case 1:
            return (random.below(2) == 0 ? 1 : -1) * (1 - 0x1p-53 * random.below(8));
        case 2:
            return (random.below(2) == 0 ? 1 : -1) * (0.5 + 0x1p-52 * random.below(8));
        default:
            return std::ldexp(std::floor(std::ldexp(random.uniform(-1, 1) + 0x1p-33 * random.uniform(-1, 1), 50)), -50);
    }
}

// The largest error over bound that a search by single changes finds. `change` alters the input at random; `ratio`
// evaluates it.
template <class Input, class Change, class Ratio>
double search(int restarts, int steps, Input start, Change change, Ratio ratio) {
    double largest = 0;
    for (int i = 0; i < restarts; ++i) {
        Input input = start;
        for (int k = 0; k < 50; ++k) change(input);
        double best = ratio(input);
        for (int k = 0; k < steps; ++k) {
            Input next = input;
            change(next);
            const double r = ratio(next);
            if (r < best) continue;
            best = r;
            input = next;
        }
        largest = std::max(largest, best);
    }
    return largest;
}

// Four points as rounded, and the error of each coordinate in units of `delta`.
struct FourPoints {
    std::array<Point, 4> rounded{};
    std::array<std::array<int, 3>, 4> error{};
    int mode = FE_TONEAREST;
};

void change(FourPoints& p, Random& random, bool has_errors) {
    const std::size_t i = random.below(4), k = random.below(3);
    switch (random.below(has_errors ? 3 : 2)) {
        case 0:
            p.rounded[i][k] = coordinate(random);
            break;
        case 1:
            p.mode = rounding_modes[random.below(4)];
            break;
        default:
            p.error[i][k] = static_cast<int>(random.below(3)) - 1;
            break;
    }
}

DifferenceBound bound_of(const FourPoints& p, std::size_t count, double delta) {
    std::array<double, 3> extent;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto [low, high] = std::minmax_element(p.rounded.begin(), p.rounded.begin() + static_cast<int>(count),
                                                     [k](const Point& a, const Point& b) { return a[k] < b[k]; });
        extent[k] = (*high)[k] - (*low)[k];
    }
    return difference_bound(extent, delta);
}

constexpr int unit = 60;  // coordinates and errors are multiples of 2^-60

Integer exact_difference(const FourPoints& p, std::size_t a, std::size_t b, std::size_t k, double delta) {
    const auto at = [&](std::size_t i) {
        return in_units(p.rounded[i][k], unit) + p.error[i][k] * in_units(delta, unit);
    };
    return at(b) - at(a);
}

double orient3d_ratio(const FourPoints& p, double delta) {
    const auto& w = p.rounded;
    const double computed = in_mode(p.mode, [&] { return plain_orient3d(w[0], w[1], w[2], w[3]); });
    std::array<std::array<Integer, 3>, 3> d;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k) d[i][k] = exact_difference(p, 0, i + 1, k, delta);
    }
    const Integer exact = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1]) +
                          d[0][1] * (d[1][2] * d[2][0] - d[1][0] * d[2][2]) +
                          d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    const double error = to_double(in_units(computed, 3 * unit) - exact, 3 * unit);
    return std::abs(error) / orient3d_bound(bound_of(p, 4, delta));
}

double orient2d_ratio(const FourPoints& p, double delta) {
    const auto& w = p.rounded;
    const double computed = in_mode(p.mode, [&] { return plain_orient2d(w[0], w[1], w[2], 2); });
    const auto x = [&](std::size_t i, std::size_t k) { return exact_difference(p, 0, i, k, delta); };
    const double error = to_double(in_units(computed, 2 * unit) - (x(1, 0) * x(2, 1) - x(1, 1) * x(2, 0)), 2 * unit);
    return std::abs(error) / orient2d_bound(bound_of(p, 3, delta), 0, 1);
}

// The largest error over its bound: no more than 1, and not much less.
void expect_tight(double largest, double least) {
    std::printf("largest error over bound: %.4f\n", largest);
    EXPECT_LE(largest, 1);
    EXPECT_GE(largest, least);
}

double search_points(double delta, int steps, const std::function<double(const FourPoints&, double)>& ratio) {
    Random random(1);
    return search(
        8, steps, FourPoints{}, [&](FourPoints& p) { change(p, random, delta != 0); },
        [&](const FourPoints& p) { return ratio(p, delta); });
}

TEST(FilterBound, Orient3dOfExactPoints) {
    expect_tight(search_points(0, 20000, orient3d_ratio), 1 / 12.0);
}

TEST(FilterBound, Orient3dOfInexactPoints) {
    expect_tight(search_points(0x1p-20, 20000, orient3d_ratio), 1 / 4.0);
}

TEST(FilterBound, Orient2dOfExactPoints) {
    expect_tight(search_points(0, 20000, orient2d_ratio), 1 / 4.0);
}

TEST(FilterBound, Orient2dOfInexactPoints) {
    expect_tight(search_points(0x1p-20, 20000, orient2d_ratio), 1 / 2.5);
}

// Two points whose errors are opposite: the difference has both.
TEST(FilterBound, DifferencesHaveTheErrorsOfBothPoints) {
    const double delta = 0x1p-20;
    const DifferenceBound bound = difference_bound({1, 0, 0}, delta);
    EXPECT_GE(bound.error[0], 2 * delta + 0x1p-52);
    EXPECT_GE(bound.error[1], 2 * delta);
    EXPECT_GE(bound.magnitude[0], 1 + 2 * delta);
    EXPECT_GE(bound.magnitude[1], 2 * delta);
    // Rounded upward, 1 - (-2^-100) is 1 + 2^-52.
    EXPECT_GE(difference_bound({1, 1, 1}, 0).error[2], 0x1p-52 - 0x1p-100);
}

struct PosedInput {
    std::array<double, 3> r{}, v{};
    double d = 0;
    int mode = FE_TONEAREST;
};

double point_ratio(const PosedInput& in) {
    Mat3 R = Mat3::Zero();
    Vec3 v, d(in.d, 0, 0);
    for (int k = 0; k < 3; ++k) {
        R(0, k) = in.r[static_cast<std::size_t>(k)];
        v[k] = in.v[static_cast<std::size_t>(k)];
    }
    const double computed = in_mode(in.mode, [&] { return pose_point(R, v, d)[0]; });
    Integer exact = in_units(in.d, 2 * unit);
    for (std::size_t k = 0; k < 3; ++k) exact += in_units(in.r[k], unit) * in_units(in.v[k], unit);
    const double error = to_double(in_units(computed, 2 * unit) - exact, 2 * unit);
    return std::abs(error) / point_error_bound(R, v.cwiseAbs(), d);
}

TEST(FilterBound, PosedPoints) {
    Random random(2);
    const auto change_one = [&](PosedInput& in) {
        const std::uint32_t which = random.below(8);
        if (which < 3)
            in.r[which] = coordinate(random);
        else if (which < 6)
            in.v[which - 3] = coordinate(random);
        else if (which == 6)
            in.d = coordinate(random);
        else
            in.mode = rounding_modes[random.below(4)];
    };
    expect_tight(search(8, 20000, PosedInput{}, change_one, point_ratio), 1 / 3.0);
}

TEST(FilterBound, EveryTermOfAPosedPointCounts) {
    const double at_least = 4 * 0x1p-52;
    EXPECT_GE(point_error_bound(Mat3::Zero(), Vec3(1, 1, 1), Vec3(0, 8, 0)), 8 * at_least);
    for (int i = 0; i < 9; ++i) {
        Mat3 R = Mat3::Zero();
        R.data()[i] = -1;
        EXPECT_GE(point_error_bound(R, Vec3(2, 2, 2), Vec3::Zero()), 2 * at_least);
    }
    EXPECT_GE(point_error_bound(-Mat3::Ones(), Vec3(1, 2, 3), Vec3(-4, -4, -4)), 10 * at_least);
    // Zero is known to no better than what underflows.
    EXPECT_GE(point_error_bound(Mat3::Zero(), Vec3(1, 1, 1), Vec3::Zero()), 11 * 0x1p-1022);
    EXPECT_GE(point_error_bound(0x1p1000 * Mat3::Identity(), Vec3(0, 0, 0), Vec3::Zero()), 3 * 0x1p-22);
}

// The claim of a proof, as it stands in its file: "<= 225b-55" is 225 * 2^-55. In units of u' = 2^-52.
double proven(const char* file) {
    std::ifstream in(std::filesystem::path(ECODS_PROOFS) / file);
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    std::smatch found;
    const bool is_claim = std::regex_search(text, found, std::regex(R"((?:<= |F0 in \[-\d+b-\d+,)(\d+)b-(\d+))"));
    EXPECT_TRUE(is_claim) << file;
    return is_claim ? std::ldexp(std::stod(found[1]), 52 - std::stoi(found[2])) : infinite_bound;
}

// The formulas with the constants that are proved; (1 + 2^-20) less what evaluation may lose.
TEST(FilterBound, ConstantsAreTheProvenOnes) {
    const DifferenceBound d{{0x1p-40, 0x1p-38, 0x1p-36}, {1, 2, 4}};
    const double slack = 1 + 0x1p-21;
    const double rounding3 = proven("orient3d.g") * 0x1p-52 * 8, rounding2 = proven("orient2d.g") * 0x1p-52;
    EXPECT_GE(orient3d_bound(d), (rounding3 + 6 * (0x1p-40 * 8 + 0x1p-38 * 4 + 0x1p-36 * 2)) * slack);
    EXPECT_GE(orient2d_bound(d, 0, 1), (rounding2 * 2 + 2 * (0x1p-40 * 2 + 0x1p-38)) * slack);
    EXPECT_GE(orient2d_bound(d, 2, 0), (rounding2 * 4 + 2 * (0x1p-36 + 0x1p-40 * 4)) * slack);
    // Without input errors, so that the first terms are seen.
    const DifferenceBound exact{{0, 0, 0}, {1, 2, 4}};
    EXPECT_GE(orient3d_bound(exact), rounding3 * slack);
    EXPECT_GE(orient2d_bound(exact, 1, 2), rounding2 * 8 * slack);
    EXPECT_GE(point_error_bound(Mat3::Identity(), Vec3(1, 1, 1), Vec3(1, 1, 1)), proven("posed_point.g") * 0x1p-52 * 2);
}

TEST(FilterBound, NoBoundWhereProductsOverflowOrUnderflow) {
    const auto of_size = [](double size) { return difference_bound({size, size, size}, 0); };
    EXPECT_LT(orient3d_bound(of_size(0x1p199)), infinite_bound);
    EXPECT_EQ(orient3d_bound(of_size(0x1p200)), infinite_bound);
    EXPECT_EQ(orient3d_bound(of_size(0x1p1000)), infinite_bound);
    EXPECT_LT(orient3d_bound(of_size(0x1p-240)), infinite_bound);
    EXPECT_EQ(orient3d_bound(of_size(0x1p-260)), infinite_bound);
    EXPECT_EQ(orient3d_bound(of_size(0)), infinite_bound);
    EXPECT_EQ(orient2d_bound(of_size(0x1p200), 0, 1), infinite_bound);
    EXPECT_EQ(orient2d_bound(of_size(0x1p-370), 0, 1), infinite_bound);
    // One axis that is too large will do.
    EXPECT_EQ(orient3d_bound(difference_bound({1, 1, 0x1p200}, 0)), infinite_bound);
}

}  // namespace
}  // namespace ecods::exact::filter_bound_test
