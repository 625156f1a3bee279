#include "programs/clash/picture/fragments.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace ecods::clash {
namespace {

// Depths are rounded to so many steps a sample, so that faces that lie on each other have the same: fragments of the
// first part then come first.
constexpr double depth_steps = 1024;

double round_depth(double depth) {
    return static_cast<double>(static_cast<std::int64_t>(depth * depth_steps + (depth < 0 ? -0.5 : 0.5))) / depth_steps;
}

constexpr std::size_t band_rows = 16;  // whose fragments stay in the cache

// A triangle of a screen mesh by indices of both.
struct Named {
    std::uint32_t mesh;
    std::uint32_t triangle;
};

// Rows and columns whose middles are at or after x.
double first_middle(double x) {
    return std::ceil(x - 0.5);
}

// Where the edge crosses the row's middle, the same from both of its triangles: from the upper end on.
double crossing(const Vec3& a, const Vec3& b, double y) {
    const bool is_a_first = a.y() != b.y() ? a.y() < b.y() : a.x() < b.x();
    const Vec3& from = is_a_first ? a : b;
    const Vec3& to = is_a_first ? b : a;
    return from.x() + (y - from.y()) * ((to.x() - from.x()) / (to.y() - from.y()));
}

// A triangle's plane, and what its fragments have in common.
struct Plane {
    Vec3 corner;
    double slope_x, slope_y;
    double least, most;  // depths
    Fragment fragment;

    double depth(double x, double y) const {
        const double z = corner.z() + slope_x * (x - corner.x()) + slope_y * (y - corner.y());
        return round_depth(std::clamp(z, least, most));
    }
};

// Nothing if the triangle is seen from its edge.
std::optional<Plane> plane_of(const std::array<Vec3, 3>& p, Layer layer) {
    const Vec3 normal = (p[1] - p[0]).cross(p[2] - p[0]);
    const double length = normal.norm();
    if (normal.z() == 0 || !std::isfinite(length)) return {};
    const auto [least, most] = std::minmax({p[0].z(), p[1].z(), p[2].z()});
    Plane plane{p[0], -normal.x() / normal.z(), -normal.y() / normal.z(), least, most, {}};
    plane.fragment.layer = layer;
    const double toward_eye = normal.z() > 0 ? -127 : 127;
    for (std::size_t k = 0; k < 3; ++k) {
        const double coordinate = toward_eye * normal[static_cast<Eigen::Index>(k)] / length;
        plane.fragment.normal[k] = static_cast<std::int8_t>(std::lround(coordinate));
    }
    return plane;
}

// The fragments of a band's triangles, in the order of these.
class Scan {
  public:
    explicit Scan(const Screen& screen) : screen_(screen) {}

    std::vector<Fragment> fragments;

    void begin(std::size_t first_row, std::size_t end_row) {
        first_row_ = first_row;
        end_row_ = end_row;
        fragments.clear();
        context_at_.assign((end_row - first_row) * screen_.width, no_fragment);
    }

    void add(const std::array<Vec3, 3>& p, Layer layer) {
        std::optional<Plane> plane = plane_of(p, layer);
        if (!plane) return;
        const auto [y_least, y_most] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
        const double end = std::min(first_middle(y_most), static_cast<double>(end_row_));
        for (double row = std::max(first_middle(y_least), static_cast<double>(first_row_)); row < end; ++row) {
            const double y = row + 0.5;
            std::array<double, 3> x{};
            std::size_t count = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& a = p[k];
                const Vec3& b = p[(k + 1) % 3];
                if ((a.y() <= y) != (b.y() <= y)) x[count++] = crossing(a, b, y);
            }
            if (count == 2) add_row(*plane, static_cast<std::size_t>(row), std::min(x[0], x[1]), std::max(x[0], x[1]));
        }
    }

  private:
    static constexpr std::uint32_t no_fragment = ~std::uint32_t{0};

    void add_row(Plane& plane, std::size_t row, double left, double right) {
        const double first = std::max(first_middle(left), 0.0);
        const double end = std::min(first_middle(right), static_cast<double>(screen_.width));
        if (!(first < end)) return;
        const auto column = static_cast<std::size_t>(first);
        auto sample = static_cast<std::uint32_t>((row - first_row_) * screen_.width + column);
        const double y = static_cast<double>(row) + 0.5;
        double x = first + 0.5;
        if (plane.fragment.layer == Layer::context) {
            for (; x < end; ++x, ++sample) add_context(plane, sample, plane.depth(x, y));
            return;
        }
        const std::size_t begin = fragments.size();
        fragments.resize(begin + static_cast<std::size_t>(end) - column, plane.fragment);
        for (std::size_t i = begin; i < fragments.size(); ++i, ++x, ++sample) {
            fragments[i].depth = plane.depth(x, y);
            fragments[i].sample = sample;
        }
    }

    void add_context(Plane& plane, std::uint32_t sample, double depth) {
        if (depth < screen_.cut_depth) return;
        std::uint32_t& at = context_at_[sample];
        if (at != no_fragment && fragments[at].depth <= depth) return;
        plane.fragment.depth = depth;
        plane.fragment.sample = sample;
        if (at == no_fragment) {
            at = static_cast<std::uint32_t>(fragments.size());
            fragments.push_back(plane.fragment);
        } else {
            fragments[at] = plane.fragment;
        }
    }

    const Screen& screen_;
    std::size_t first_row_ = 0;
    std::size_t end_row_ = 0;
    std::vector<std::uint32_t> context_at_;  // each sample's fragment of the context
};

std::array<Vec3, 3> corners_of(const ScreenMesh& mesh, const Triangle& triangle) {
    return {mesh.points[triangle[0]], mesh.points[triangle[1]], mesh.points[triangle[2]]};
}

// For each band, the triangles that may have a fragment in it.
std::vector<std::vector<Named>> triangles_by_band(std::span<const ScreenMesh> meshes, std::size_t width,
                                                  std::size_t height) {
    std::vector<std::vector<Named>> bands((height + band_rows - 1) / band_rows);
    for (std::uint32_t m = 0; m < meshes.size(); ++m) {
        for (std::uint32_t t = 0; t < meshes[m].triangles.size(); ++t) {
            const std::array<Vec3, 3> p = corners_of(meshes[m], meshes[m].triangles[t]);
            const auto [x_least, x_most] = std::minmax({p[0].x(), p[1].x(), p[2].x()});
            const auto [y_least, y_most] = std::minmax({p[0].y(), p[1].y(), p[2].y()});
            if (!(x_most >= 0 && x_least <= static_cast<double>(width))) continue;
            const double first = std::max(first_middle(y_least), 0.0);
            const double end = std::min(first_middle(y_most), static_cast<double>(height));
            if (!(first < end)) continue;
            const std::size_t last_band = (static_cast<std::size_t>(end) - 1) / band_rows;
            for (std::size_t band = static_cast<std::size_t>(first) / band_rows; band <= last_band; ++band)
                bands[band].push_back({m, t});
        }
    }
    return bands;
}

bool comes_before(const Fragment& a, const Fragment& b) {
    return a.depth != b.depth ? a.depth < b.depth : a.layer < b.layer;
}

// By sample, which counting does, then by depth.
void sort_fragments(const std::vector<Fragment>& fragments, std::size_t sample_count, std::vector<std::uint32_t>& start,
                    std::vector<Fragment>& sorted) {
    start.assign(sample_count + 1, 0);
    for (const Fragment& fragment : fragments) ++start[fragment.sample + 1];
    for (std::size_t i = 0; i < sample_count; ++i) start[i + 1] += start[i];
    sorted.resize(fragments.size());
    for (const Fragment& fragment : fragments) sorted[start[fragment.sample]++] = fragment;
    // Now start[i] is where sample i ends. A sample has few fragments, and most are in order.
    std::size_t begin = 0;
    for (std::size_t i = 0; i < sample_count; ++i) {
        for (std::size_t k = begin + 1; k < start[i]; ++k) {
            const Fragment fragment = sorted[k];
            std::size_t at = k;
            for (; at > begin && comes_before(fragment, sorted[at - 1]); --at) sorted[at] = sorted[at - 1];
            sorted[at] = fragment;
        }
        begin = start[i];
    }
}

}  // namespace

void for_each_band(std::span<const ScreenMesh> meshes, const Screen& screen,
                   const std::function<void(const Band&)>& draw) {
    const std::vector<std::vector<Named>> bands = triangles_by_band(meshes, screen.width, screen.height);
    Scan scan(screen);
    std::vector<Fragment> sorted;
    std::vector<std::uint32_t> start;
    for (std::size_t band = 0; band < bands.size(); ++band) {
        const std::size_t first_row = band * band_rows;
        const std::size_t row_count = std::min(band_rows, screen.height - first_row);
        scan.begin(first_row, first_row + row_count);
        for (const Named& each : bands[band]) {
            const ScreenMesh& mesh = meshes[each.mesh];
            scan.add(corners_of(mesh, mesh.triangles[each.triangle]), mesh.layer);
        }
        sort_fragments(scan.fragments, row_count * screen.width, start, sorted);
        draw({first_row, row_count, sorted});
    }
}

}  // namespace ecods::clash
