#include "query/convex/support_points.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "base/double_key.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/number/dyadic.hpp"

namespace ecods::convex {

double times_power(double x, int exponent) noexcept {
    const exact::Dyadic d = exact::decode(x);
    const int e = d.e + exponent;
    if (d.m == 0 || e + static_cast<int>(std::bit_width(exact::magnitude(d.m))) <= -900) return 0;
    return static_cast<double>(d.m) * exact::power_of_two(e);
}

int exponent_above(double x) noexcept {
    const exact::Dyadic d = exact::decode(x);
    return d.m == 0 ? -exact::BitRange::none : d.e + static_cast<int>(std::bit_width(exact::magnitude(d.m)));
}

SupportPoints make_support_points(const Mesh& mesh, const Hull& hull) {
    SupportPoints result;
    const auto vertices = mesh.vertices();
    int exponent = -exact::BitRange::none;
    for (const std::uint32_t i : hull.mesh_vertices) {
        for (int k = 0; k < 3; ++k) exponent = std::max(exponent, exponent_above(vertices[i][k]));
    }
    result.exponent = exponent;
    result.vertex_count = static_cast<std::uint32_t>(hull.vertex_count());
    result.hull_index.assign(vertices.size(), SupportPoints::none);
    for (std::uint32_t v = 0; v < hull.vertex_count(); ++v) result.hull_index[hull.mesh_vertices[v]] = v;

    constexpr std::size_t lanes = SupportPoints::lanes;
    const std::size_t count = hull.vertex_count();
    result.groups.resize((count + 2 * lanes - 1) / (2 * lanes) * (6 * lanes));
    exact::Point low{1, 1, 1}, high{-1, -1, -1};
    for (std::size_t i = 0; i < result.groups.size() / 3; ++i) {
        const auto v = static_cast<std::uint32_t>(std::min(i, count - 1));
        for (std::size_t k = 0; k < 3; ++k) {
            const double original = vertices[hull.mesh_vertices[v]][static_cast<Eigen::Index>(k)];
            const double x = times_power(original, -exponent);
            result.has_all_digits &= key_of(x) != 0 || key_of(original) == 0;
            result.groups[i / lanes * (3 * lanes) + k * lanes + i % lanes] = x;
            if (x < low[k]) {
                low[k] = x;
                result.extremes[2 * k] = v;
            }
            if (x > high[k]) {
                high[k] = x;
                result.extremes[2 * k + 1] = v;
            }
        }
    }
    for (std::size_t k = 0; k < 3; ++k) {
        result.reach[k] = std::max(std::abs(low[k]), std::abs(high[k]));
        result.center[k] = 0.5 * (low[k] + high[k]);
        result.extent[k] = (high[k] - low[k]) * (1 + 4 * two_u);
    }
    return result;
}

}  // namespace ecods::convex
