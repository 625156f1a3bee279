// Decides whether a mesh covers a flat convex set. For a polygon, let all triangles turn one way. If each side of a
// triangle occurs once, and the sides that no triangle has in the other direction go once around the polygon, the
// triangles tile it: the number of triangles around a point is the winding number of these sides, which is 1 inside the
// polygon and 0 outside.
#include "query/solid/flat_mesh.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "base/double_key.hpp"
#include "exact/sign/vertex_signs.hpp"

namespace ecods {
namespace {

using exact::VertexSigns;

constexpr SideRef no_side{~std::uint32_t{0}, 0};

// FlatHull finds the hull of points in one plane.
class FlatHull {
  public:
    FlatHull(std::span<const Vec3> points, std::vector<std::uint32_t> among)
        : points_(points), signs_(points), order_(std::move(among)) {}

    std::optional<FlatCycle> find() {
        const auto [low, high] = std::ranges::minmax_element(
            order_, [&](std::uint32_t i, std::uint32_t k) { return compare_points(points_[i], points_[k]) < 0; });
        const std::uint32_t a = *low, b = *high;
        if (a == b) return FlatCycle{a};
        const auto c = std::ranges::find_if(
            order_, [&](std::uint32_t i) { return have_area(points_[a], points_[b], points_[i]); });
        if (c == order_.end()) return FlatCycle{std::min(a, b), std::max(a, b)};
        for (const std::uint32_t i : order_) {
            if (signs_.orient3d(a, b, *c, i) != 0) return std::nullopt;
        }
        while (signs_.orient2d(a, b, *c, axis_) == 0) ++axis_;
        return around();
    }

  private:
    // Returns the vertices of the polygon, seen along axis_, by the chains of Andrew (Another efficient algorithm for
    // convex hulls in two dimensions, 1979). No two points have the same image, since the plane is not parallel to the
    // axis.
    FlatCycle around() {
        const int first = (axis_ + 1) % 3, second = (axis_ + 2) % 3;
        std::ranges::sort(order_, {}, [&](std::uint32_t i) {
            return std::pair(key_of(points_[i][first]), key_of(points_[i][second]));
        });
        FlatCycle cycle = chain();
        std::ranges::reverse(order_);
        const FlatCycle back = chain();
        cycle.insert(cycle.end(), back.begin(), back.end());
        std::ranges::rotate(cycle, std::ranges::min_element(cycle));
        return cycle;
    }

    // Returns the part of the polygon from the first to the last point of order_, without the last one. All of its
    // turns are to the left.
    FlatCycle chain() const {
        FlatCycle result;
        for (const std::uint32_t i : order_) {
            while (result.size() > 1 && signs_.orient2d(result[result.size() - 2], result.back(), i, axis_) <= 0) {
                result.pop_back();
            }
            result.push_back(i);
        }
        result.pop_back();
        return result;
    }

    std::span<const Vec3> points_;
    VertexSigns signs_;
    std::vector<std::uint32_t> order_;
    int axis_ = 0;  // axis of the normal's first coordinate that is not zero
};

// Cover matches the triangles of a mesh with the hull of their corners.
class Cover {
  public:
    Cover(const ProperMesh& proper, bool has_area)
        : proper_(proper),
          has_area_(has_area),
          triangles_(proper.mesh->triangles()),
          points_(proper.mesh->vertices()) {}

    // Returns the flat convex set that the triangles cover; nullopt if the triangles cover no such set.
    std::optional<FlatMesh> find() {
        std::vector<std::uint32_t> used;
        std::vector<std::uint8_t> is_used(points_.size(), 0);
        for_each_triangle([&](std::uint32_t, const Triangle& corners) {
            for (const std::uint32_t v : corners) {
                if (std::exchange(is_used[v], std::uint8_t{1}) == 0) used.push_back(v);
            }
        });
        std::optional<FlatCycle> cycle = flat_hull(points_, std::move(used));
        if (!cycle) return std::nullopt;
        flat_.cycle = std::move(*cycle);
        if (flat_.is_polygon() && !has_area_) return std::nullopt;
        const bool is_covered = flat_.is_polygon() ? is_tiled() : is_joined();
        return is_covered ? std::optional(std::move(flat_)) : std::nullopt;
    }

  private:
    // A Side is a side of a triangle, in the direction in which the polygon turns.
    struct Side {
        std::uint32_t from, to;
        SideRef name;

        std::pair<std::uint32_t, std::uint32_t> ends() const noexcept { return {from, to}; }
    };

    template <class Use>
    void for_each_triangle(const Use& use) const {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (!has_area_ || proper_.is_proper(i)) use(i, triangles_[i]);
        }
    }

    bool is_tiled() {
        const VertexSigns signs(points_);
        while (!proper_.is_proper(flat_.face)) ++flat_.face;
        const Triangle& first = triangles_[flat_.face];
        int axis = 0;
        while (signs.orient2d(first[0], first[1], first[2], axis) == 0) ++axis;
        const auto turn = [&](const Triangle& t) { return signs.orient2d(t[0], t[1], t[2], axis); };
        const FlatCycle& cycle = flat_.cycle;
        if (turn({cycle[0], cycle[1], cycle[2]}) != turn(first))
            std::reverse(flat_.cycle.begin() + 1, flat_.cycle.end());
        std::vector<Side> sides;
        for_each_triangle([&](std::uint32_t i, const Triangle& corners) {
            const bool is_turned = turn(corners) != turn(first);
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                const std::uint32_t p = corners[corner], q = corners[(corner + 1) % 3];
                sides.push_back(is_turned ? Side{q, p, {i, corner}} : Side{p, q, {i, corner}});
            }
        });
        std::ranges::sort(sides, {}, &Side::ends);
        return goes_around(sides, signs, axis);
    }

    // Returns true if no side occurs twice, and the sides that no triangle has in the other direction go once around
    // the polygon. Sets the names of the polygon's edges. `sides` must be sorted by the ends of each side.
    bool goes_around(const std::vector<Side>& sides, const VertexSigns& signs, int axis) {
        std::vector<const Side*> next(points_.size(), nullptr);
        std::size_t left = 0;
        for (std::size_t i = 0; i < sides.size(); ++i) {
            const Side& side = sides[i];
            if (i > 0 && sides[i - 1].ends() == side.ends()) return false;
            if (std::ranges::binary_search(sides, std::pair(side.to, side.from), {}, &Side::ends)) continue;
            if (std::exchange(next[side.from], &side) != nullptr) return false;
            ++left;
        }
        const FlatCycle& cycle = flat_.cycle;
        for (std::size_t k = 0; k < cycle.size(); ++k) {
            const std::uint32_t from = cycle[k], to = cycle[(k + 1) % cycle.size()];
            const int along = compare_points(points_[from], points_[to]);
            SideRef name = no_side;
            for (std::uint32_t at = from; at != to; --left) {
                const Side* const side = next[at];
                if (side == nullptr || signs.orient2d(from, to, side->to, axis) != 0) return false;
                if (compare_points(points_[at], points_[side->to]) != along) return false;
                name = std::min(name, side->name);
                at = side->to;
            }
            flat_.sides.push_back(name);
        }
        return left == 0;
    }

    // Returns true if the triangles, each a segment or a point, cover the segment or point `cycle`. Sets the edge's
    // name.
    bool is_joined() {
        const auto is_less = [&](std::uint32_t p, std::uint32_t q) {
            return compare_points(points_[p], points_[q]) < 0;
        };
        std::vector<std::array<std::uint32_t, 2>> pieces;
        SideRef name = no_side;
        for_each_triangle([&](std::uint32_t i, const Triangle& corners) {
            const auto [low, high] = std::ranges::minmax(corners, is_less);
            pieces.push_back({low, high});
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                if (corners[corner] != corners[(corner + 1) % 3]) name = std::min(name, {i, corner});
            }
        });
        std::ranges::sort(pieces, [&](const auto& x, const auto& y) { return is_less(x[0], y[0]); });
        std::uint32_t reach = pieces.front()[1];
        for (const auto& [low, high] : pieces) {
            if (is_less(reach, low)) return false;
            if (is_less(reach, high)) reach = high;
        }
        if (flat_.cycle.size() == 2) flat_.sides.push_back(name);
        return true;
    }

    const ProperMesh& proper_;
    bool has_area_;  // true if some triangle has an area; then only triangles with an area count
    std::span<const Triangle> triangles_;
    std::span<const Vec3> points_;
    FlatMesh flat_;
};

}  // namespace

std::optional<FlatCycle> flat_hull(std::span<const Vec3> points, std::vector<std::uint32_t> among) {
    if (among.empty()) return std::nullopt;
    return FlatHull(points, std::move(among)).find();
}

std::shared_ptr<const Mesh> mesh_of_flat(std::span<const Vec3> points, const FlatCycle& cycle) {
    FlatCycle kept = cycle;
    std::ranges::sort(kept);
    std::vector<Vec3> vertices;
    for (const std::uint32_t i : kept) vertices.push_back(points[i]);
    const auto index = [&](std::size_t k) {
        const std::uint32_t of = cycle[std::min(k, cycle.size() - 1)];
        return static_cast<std::uint32_t>(std::ranges::lower_bound(kept, of) - kept.begin());
    };
    std::vector<Triangle> triangles{{0, index(1), index(2)}};
    for (std::size_t k = 2; k + 1 < cycle.size(); ++k) triangles.push_back({0, index(k), index(k + 1)});
    std::ranges::sort(triangles);
    return Mesh::create(std::move(vertices), std::move(triangles));
}

std::optional<FlatMesh> find_flat(const ProperMesh& proper) {
    if (proper.mesh->triangles().empty()) return std::nullopt;
    const bool has_area =
        proper.has_area.empty() || std::ranges::any_of(proper.has_area, [](auto has) { return has != 0; });
    return Cover(proper, has_area).find();
}

}  // namespace ecods
