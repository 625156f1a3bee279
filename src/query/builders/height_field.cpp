// Builds height fields and clouds of points.
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/double_key.hpp"
#include "base/make_error.hpp"
#include "ecods/builders.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/number/dyadic.hpp"
#include "geometry/find_invalid.hpp"
#include "query/builders/check_sizes.hpp"

namespace ecods {
namespace {

using namespace builders;

constexpr std::size_t index_max = std::numeric_limits<std::uint32_t>::max();

// Returns `count` multiples of the spacing, beginning with 0, each rounded once. They ascend: neighbors differ by more
// than a unit in the last place, since `count` is below 2^32.
std::vector<double> positions(std::size_t count, const Vec2& spacing, int axis) {
    const std::string name = "spacing(" + std::to_string(axis) + ")";
    require_size(name, spacing[axis]);
    const exact::Dyadic step = exact::decode(spacing[axis]);
    std::vector<double> result;
    for (std::size_t i = 0; i < count; ++i) {
        result.push_back(
            exact::round_integer(exact::widened(exact::Int128{step.m} * static_cast<std::int64_t>(i)), step.e));
    }
    if (!is_finite(result.back())) throw size_too_large(name, spacing[axis]);
    return result;
}

// FieldMesh makes the mesh of a height field, and on demand the mesh of the solid below the field.
class FieldMesh {
  public:
    FieldMesh(std::span<const double> heights, std::size_t columns, const Vec2& spacing)
        : columns_(columns), rows_(columns == 0 ? 0 : heights.size() / columns) {
        require_count("columns", columns, 2, index_max);
        if (heights.size() % columns != 0) throw invalid_rows(heights.size(), columns);
        require_count("rows", rows_, 2, index_max);
        // The solid's base has fewer vertices than the field, so twice as many must fit.
        if (heights.size() > index_max / 2) throw mesh_too_large(heights.size(), 2 * heights.size());
        x_ = positions(columns_, spacing, 0);
        y_ = positions(rows_, spacing, 1);
        for (std::size_t k = 0; k < heights.size(); ++k) {
            vertices_.emplace_back(x_[k % columns_], y_[k / columns_], heights[k]);
        }
        for (std::size_t j = 0; j + 1 < rows_; ++j) {
            for (std::size_t i = 0; i + 1 < columns_; ++i) {
                add_quad(vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1));
            }
        }
    }

    // Adds the walls, and the bottom at z = base, whose vertices are those below the field's border.
    void add_base(double base) {
        std::vector<std::uint32_t> above;  // the border, counterclockwise seen from above
        for (std::size_t i = 0; i + 1 < columns_; ++i) above.push_back(vertex(i, 0));
        for (std::size_t j = 0; j + 1 < rows_; ++j) above.push_back(vertex(columns_ - 1, j));
        for (std::size_t i = columns_ - 1; i > 0; --i) above.push_back(vertex(i, rows_ - 1));
        for (std::size_t j = rows_ - 1; j > 0; --j) above.push_back(vertex(0, j));
        const auto first = static_cast<std::uint32_t>(vertices_.size());
        const auto count = static_cast<std::uint32_t>(above.size());
        for (const std::uint32_t v : above) vertices_.emplace_back(vertices_[v][0], vertices_[v][1], base);
        for (std::uint32_t k = 0; k < count; ++k) {
            const std::uint32_t next = (k + 1) % count;
            add_quad(first + k, first + next, above[next], above[k]);
        }
        add_bottom(first, count);
    }

    std::shared_ptr<const Mesh> mesh() && { return Mesh::create(std::move(vertices_), std::move(triangles_)); }

  private:
    std::uint32_t vertex(std::size_t i, std::size_t j) const noexcept {
        return static_cast<std::uint32_t>(j * columns_ + i);
    }
    // Adds the quad's two triangles, which the diagonal a-c separates.
    void add_quad(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
        triangles_.push_back({a, b, c});
        triangles_.push_back({a, c, d});
    }

    // Adds the bottom as strips between the left and the right border, in the order of rows. The first strip has the
    // vertices of the first row, and the last strip those of the last row. The border has `count` vertices,
    // counterclockwise from `first`, which is at (0, 0).
    void add_bottom(std::uint32_t first, std::uint32_t count) {
        const auto right = first + static_cast<std::uint32_t>(columns_) - 1;
        const auto left = [&](std::uint32_t j) { return j == 0 ? first : first + count - j; };
        const auto last = static_cast<std::uint32_t>(rows_) - 1;
        // Adds a fan around the left end of row 1; its last triangle has the right end of row 0.
        for (std::uint32_t v = first; v < right; ++v) triangles_.push_back({left(1), v + 1, v});
        if (last == 1) {
            // Adds the second half of the bottom's only strip, as a fan around the right end of row 0.
            for (std::uint32_t v = right + 1; v < left(1); ++v) triangles_.push_back({right, v + 1, v});
            return;
        }
        triangles_.push_back({left(1), right + 1, right});
        for (std::uint32_t j = 1; j + 1 < last; ++j) add_quad(left(j), left(j + 1), right + j + 1, right + j);
        const std::uint32_t below = last - 1;
        triangles_.push_back({left(below), right + last, right + below});
        for (std::uint32_t v = right + last; v < left(last); ++v) triangles_.push_back({left(below), v + 1, v});
    }

    std::size_t columns_, rows_;
    std::vector<double> x_, y_;
    std::vector<Vec3> vertices_;
    std::vector<Triangle> triangles_;
};

}  // namespace

std::shared_ptr<const MeshShape> height_field(std::span<const double> heights, std::size_t columns,
                                              const Vec2& spacing) {
    return std::make_shared<const MeshShape>(FieldMesh(heights, columns, spacing).mesh());
}

std::shared_ptr<const Solid> height_field(std::span<const double> heights, std::size_t columns, const Vec2& spacing,
                                          double base) {
    FieldMesh field(heights, columns, spacing);
    if (!is_finite(base)) throw invalid_base(base);
    for (std::size_t i = 0; i < heights.size(); ++i) {
        if (is_finite(heights[i]) && key_of(heights[i]) <= key_of(base)) throw invalid_base(base).at({}, i);
    }
    field.add_base(base);
    return std::make_shared<const Solid>(std::move(field).mesh());
}

std::shared_ptr<const MeshShape> point_cloud(std::span<const Vec3> points) {
    if (points.size() > index_max) throw mesh_too_large(points.size(), points.size());
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < points.size(); ++i) triangles.push_back({i, i, i});
    return std::make_shared<const MeshShape>(Mesh::create({points.begin(), points.end()}, std::move(triangles)));
}

}  // namespace ecods
