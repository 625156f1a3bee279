#include "bvh/axes/line_axes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

#include "base/outward.hpp"
#include "bvh/axes/posed_axes.hpp"

namespace ecods {

// Holds the axes N, the map P of the tree to these axes (both as in line_axes.hpp), and the sums of magnitudes that the
// error bounds need.
struct LineBound {
    alignas(32) double N[3][4], P[3][4];  // by columns
    alignas(32) double size[4], origin[4], origin_size[4];
    double factor;
};

}  // namespace ecods

#define ECODS_TEXT "bvh/axes/line_axes_text.hpp"
#include "simd/each_set.hpp"

namespace ecods {
namespace {

constexpr double float_v = 0x1p-23;
constexpr double error_max = 0x1p-6;  // with larger errors, few boxes are excluded
constexpr double box_error_max = 0x1p-19;
constexpr double direction_error_max = 0x1p-20;
constexpr double scaled_direction_min = 0x1p-960;  // least |D| whose inverse does not overflow
constexpr double length_min = 0x1p-900;            // least s1 - s0
constexpr float direction_min = 0x1p-30f;
constexpr double own_distance_max = 0x1p-40;

}  // namespace

void LineAxes::bind(const MeshBvh& tree, const Pose& pose) {
    Axes& s = axes_;
    s.is_bounded = tree.frame.is_bounded;
    if (!s.is_bounded) return;
    LineBound bound;
    call_widest<ECODS_OF_EACH_SET(bind_line_axes)>(tree, pose.R, bound);
    double size_of_N = 0, world = 0;
    s.is_unit = true;
    for (std::size_t row = 0; row < 3; ++row) {
        double product_error = 0, distance = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            s.N[row][k] = bound.N[k][row];
            s.N_size[row][k] = std::abs(bound.N[k][row]);
            size_of_N += s.N_size[row][k];
            product_error += s.N_size[row][k] * bound.size[k];
            distance += std::abs(bound.P[k][row] - (k == row ? 1 : 0));
        }
        s.own_error[row] = 8 * two_u * product_error + axes::underflow;
        s.is_unit = s.is_unit && distance <= own_distance_max;
        s.origin[row] = bound.origin[row];
        s.origin_size[row] = bound.origin_size[row];
        s.t[row] = pose.t[static_cast<Eigen::Index>(row)];
        world += bound.size[row] + bound.origin_size[row] + std::abs(s.t[row]);
    }
    s.factor = (bound.factor + world + 4) * size_of_N;
    for (std::size_t row = 0; row < 3; ++row) {
        double center = tree.root_center[row], half = tree.root_half[row];
        if (s.is_unit) {
            s.own_error[row] += own_distance_max;
        } else {
            center = half = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                center += bound.P[k][row] * static_cast<double>(tree.root_center[k]);
                half += std::abs(bound.P[k][row]) * static_cast<double>(tree.root_half[k]);
            }
        }
        s.center[row] = center;
        s.half[row] = half;
    }
    part_.is_unit = s.is_unit;
    for (std::size_t k = 0; k < 3; ++k) {
        for (std::size_t row = 0; row < 3; ++row) {
            part_.p[k][row] = static_cast<float>(bound.P[k][row]);
            part_.size[k][row] = std::abs(part_.p[k][row]);
        }
    }
    // If a number is NaN, its comparison is false, and the tree counts as unbounded.
    s.is_bounded = world < axes::world_max && s.factor < axes::factor_max;
    for (std::size_t row = 0; row < 3; ++row) s.is_bounded = s.is_bounded && std::abs(s.center[row]) + s.half[row] < 4;
}

namespace {

// Returns the interval of the numbers s in [0, limit] for which s d is between `low` and `high`.
std::pair<double, double> ends_within(double low, double high, double d, double limit) noexcept {
    const double inverse = 1 / d, first = low * inverse, second = high * inverse;
    return {std::max(0.0, std::min(first, second)), std::min(limit, std::max(first, second))};
}

}  // namespace

LineAxes::Place LineAxes::place(const ScaledLine& line, double limit) {
    const Axes& s = axes_;
    if (!s.is_bounded || !(line.is_known || line.is_point)) return Place::unknown;
    std::array<double, 3> x, x_size, X, D, error, rho;
    double factor = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const double from_t = line.a[static_cast<Eigen::Index>(k)] - s.t[k];
        x[k] = from_t - s.origin[k];
        x_size[k] = std::abs(from_t) + s.origin_size[k];
        factor += x_size[k];
    }
    const Vec3 &d = line.d, &d_error = line.d_error;
    std::size_t m = 0;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto &N = s.N[row], &size = s.N_size[row];
        X[row] = (N[0] * x[0] + N[1] * x[1]) + N[2] * x[2];
        D[row] = (N[0] * d[0] + N[1] * d[1]) + N[2] * d[2];
        error[row] = 8 * two_u * ((size[0] * x_size[0] + size[1] * x_size[1]) + size[2] * x_size[2]) + s.own_error[row];
        rho[row] = (size[0] * (4 * two_u * std::abs(d[0]) + d_error[0]) +
                    size[1] * (4 * two_u * std::abs(d[1]) + d_error[1])) +
                   size[2] * (4 * two_u * std::abs(d[2]) + d_error[2]);
        if (std::abs(D[row]) > std::abs(D[m])) m = row;
    }
    const double size_m = std::abs(D[m]), reach_of_line = std::abs(X[m]) + 8;
    // If a number is NaN, its comparison is false, and the place is unknown.
    bool is_placed = (factor + 4) * s.factor < axes::factor_max && s.factor < axes::factor_max;
    for (std::size_t row = 0; row < 3; ++row) {
        if (!line.is_point) {
            const double ratio = rho[row] / size_m;
            is_placed = is_placed && ratio <= direction_error_max;
            error[row] += 1.01 * ratio * reach_of_line;
        }
        error[row] += 4 * two_u * (std::abs(X[row]) + reach_of_line);
        is_placed = is_placed && error[row] <= error_max;
    }
    is_placed = is_placed && (line.is_point || size_m >= scaled_direction_min);
    if (!is_placed) return Place::unknown;
    double s0 = 0, s1 = 0;
    if (!line.is_point) {
        const double reach = s.half[m] + (error[m] + 16 * two_u * reach_of_line + 0x1p-20);
        std::tie(s0, s1) = ends_within(s.center[m] - reach - X[m], s.center[m] + reach - X[m], D[m], limit);
    }
    if (s0 > s1) return Place::apart;

    begin_ = s0;
    length_ = s1 - s0;
    has_ends_ = line.end_low == line.end_high && length_ >= length_min;
    std::array<double, 3> o, e;
    for (std::size_t k = 0; k < 3; ++k) {
        o[k] = X[k] + s0 * D[k];
        e[k] = line.is_point ? 0 : length_ * D[k];
        const double reach = s.half[k] + (error[k] + 0x1p-18);
        if (std::min(o[k], o[k] + e[k]) - s.center[k] > reach) return Place::apart;
        if (s.center[k] - std::max(o[k], o[k] + e[k]) > reach) return Place::apart;
    }
    set_part(o, e, error);
    return Place::placed;
}

void LineAxes::set_part(const std::array<double, 3>& o, const std::array<double, 3>& e,
                        const std::array<double, 3>& error) noexcept {
    const double scale = axes_.is_unit ? 1 : 4.2;
    const double error_largest = std::max({error[0], error[1], error[2]});
    part_.has_slopes = true;
    for (std::size_t k = 0; k < 3; ++k) {
        part_.origin[k] = static_cast<float>(o[k]);
        float direction = static_cast<float>(e[k]);
        if (!(std::abs(direction) >= direction_min)) {
            direction = direction < 0 ? -direction_min : direction_min;
            part_.has_slopes = false;
        }
        part_.direction[k] = direction;
        part_.inverse[k] = 1 / direction;
        part_.inverse_size[k] = std::abs(part_.inverse[k]);
        part_.margin[k] = static_cast<float>((error[k] + 96 * scale * float_v) * (1 + 0x1p-20));
    }
    const auto& size = part_.direction;
    std::size_t z = 0;
    for (std::size_t k = 1; k < 3; ++k) z = std::abs(size[k]) > std::abs(size[z]) ? k : z;
    part_.z = z;
    part_.x = (z + 1) % 3;
    part_.y = (z + 2) % 3;
    part_.has_slopes = part_.has_slopes || std::abs(size[z]) >= 0x1p-7f;
    part_.slope_x = part_.direction[part_.x] * part_.inverse[z];
    part_.slope_y = part_.direction[part_.y] * part_.inverse[z];
    const double corner = axes_.is_unit ? corner_error : 16 * float_v;
    part_.side = static_cast<float>((2 * (error_largest + corner) + 80 * scale * float_v) * (1 + 0x1p-20));
    part_.depth = 2 * part_.side * part_.inverse_size[z];
}

bool LineAxes::place_box(const Vec3& low, const Vec3& high, BoxOnAxes& box) const noexcept {
    const Axes& s = axes_;
    if (!s.is_bounded || !s.is_unit) return false;
    std::array<double, 3> x, x_size, half;
    double factor = 0, most = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const double from = low[axis] - s.t[k], to = high[axis] - s.t[k];
        x[k] = 0.5 * (from + to) - s.origin[k];
        x_size[k] = std::max(std::abs(from), std::abs(to)) + s.origin_size[k];
        half[k] = 0.5 * (to - from) + 4 * two_u * x_size[k];
        factor += x_size[k];
    }
    // If a number is NaN, its comparison is false, and the box is not placed.
    bool is_placed = (factor + 4) * s.factor < axes::factor_max;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto &N = s.N[row], &size = s.N_size[row];
        const double X = (N[0] * x[0] + N[1] * x[1]) + N[2] * x[2];
        const double reach = (size[0] * half[0] + size[1] * half[1]) + size[2] * half[2];
        const double error =
            8 * two_u * ((size[0] * x_size[0] + size[1] * x_size[1]) + size[2] * x_size[2]) + s.own_error[row];
        is_placed = is_placed && std::abs(X) + (reach + error) < 3.9 && error <= box_error_max;
        if (!is_placed) return false;
        box.center[row] = static_cast<float>(X);
        box.half[row] = static_cast<float>(((reach + error) + 64 * float_v) * (1 + 0x1p-20));
        most = std::max(most, error);
    }
    box.error = static_cast<float>((most + 64 * float_v) * (1 + 0x1p-20));
    return true;
}

std::array<float, 3> LineAxes::at(const Vec3& point) const noexcept {
    const Axes& s = axes_;
    const double x = (point[0] - s.t[0]) - s.origin[0], y = (point[1] - s.t[1]) - s.origin[1],
                 z = (point[2] - s.t[2]) - s.origin[2];
    std::array<float, 3> result;
    for (std::size_t row = 0; row < 3; ++row) {
        const auto& N = s.N[row];
        result[row] = static_cast<float>((N[0] * x + N[1] * y) + N[2] * z);
    }
    return result;
}

float LineAxes::ratio_above(double parameter) const noexcept {
    const double from_begin = parameter - begin_;
    if (!(from_begin > 0)) return 0x1p-40f;
    if (!(from_begin < length_)) return 1;
    return std::min(1.0f, static_cast<float>(from_begin / length_ * (1 + 0x1p-20)) + 0x1p-40f);
}

}  // namespace ecods
