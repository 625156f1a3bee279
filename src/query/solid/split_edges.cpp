#include "query/solid/split_edges.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

namespace ecods {
namespace {

// A Cut is a side of a triangle, and a vertex inside it at which the side is divided.
struct Cut {
    SideRef side;
    std::uint32_t vertex;

    friend constexpr auto operator<=>(const Cut&, const Cut&) = default;
};

// A Part is a piece of a triangle. `sides` names, by side of the piece, the side of the whole triangle that contains
// it. `inside` has, by side, the vertices at which the side must still be divided, in the order along the side.
struct Part {
    Triangle corners;
    std::array<std::uint8_t, 3> sides;
    std::array<std::vector<std::uint32_t>, 3> inside;
};

class Splitter {
  public:
    explicit Splitter(const ProperMesh& proper)
        : triangles_(proper.mesh->triangles()), vertices_(proper.mesh->vertices()) {}

    // Stores a cut for each end of one side that is inside the other side.
    void add(const EdgeOverlap& overlap) {
        add_ends(overlap.a, overlap.b);
        add_ends(overlap.b, overlap.a);
    }

    SplitMesh split(const ProperMesh& proper) {
        std::ranges::sort(cuts_);
        cuts_.erase(std::unique(cuts_.begin(), cuts_.end()), cuts_.end());
        std::vector<Triangle> result;
        std::vector<TriangleOrigin> origins;
        result.reserve(triangles_.size() + cuts_.size());
        origins.reserve(triangles_.size() + cuts_.size());
        auto next = cuts_.begin();
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            if (!proper.is_proper(i)) continue;
            Part part{triangles_[i], {0, 1, 2}, {}};
            for (; next != cuts_.end() && next->side.triangle == i; ++next) {
                part.inside[next->side.corner].push_back(next->vertex);
            }
            for (std::size_t side = 0; side < 3; ++side) sort_along(part, side);
            divide(i, std::move(part), result, origins);
        }
        return {{Mesh::create({vertices_.begin(), vertices_.end()}, std::move(result)), {}}, std::move(origins)};
    }

  private:
    const Vec3& point(std::uint32_t vertex) const { return vertices_[vertex]; }

    std::array<std::uint32_t, 2> ends_of(const SideRef& side) const {
        const auto corners = corners_from(triangles_, side);
        return {corners[0], corners[1]};
    }

    void add_ends(const SideRef& of, const SideRef& in) {
        const auto [p, q] = ends_of(in);
        for (const std::uint32_t vertex : ends_of(of)) {
            const int after_p = compare_points(point(p), point(vertex));
            const int before_q = compare_points(point(vertex), point(q));
            if (after_p * before_q > 0) cuts_.push_back({in, vertex});
        }
    }

    void sort_along(Part& part, std::size_t side) const {
        const Vec3 &p = point(part.corners[side]), &q = point(part.corners[(side + 1) % 3]);
        const int direction = compare_points(p, q);
        std::ranges::sort(part.inside[side], [&](std::uint32_t a, std::uint32_t b) {
            return compare_points(point(a), point(b)) * direction > 0;
        });
    }

    // Divides a triangle at the vertices inside its sides. Appends the pieces to `result`, and their origins to
    // `origins`. For a side with vertices inside it, the triangle is cut from the opposite corner to each of these
    // vertices. The first and the last piece each have one of the other two sides, which are divided later.
    static void divide(std::uint32_t triangle, Part whole, std::vector<Triangle>& result,
                       std::vector<TriangleOrigin>& origins) {
        std::vector<Part> open;
        open.push_back(std::move(whole));
        while (!open.empty()) {
            Part part = std::move(open.back());
            open.pop_back();
            std::size_t side = 0;
            while (side < 3 && part.inside[side].empty()) ++side;
            if (side == 3) {
                result.push_back(part.corners);
                origins.push_back({triangle, part.sides});
                continue;
            }
            const std::uint32_t from = part.corners[side], to = part.corners[(side + 1) % 3];
            const std::uint32_t apex = part.corners[(side + 2) % 3];
            const auto& inside = part.inside[side];
            for (std::size_t k = 0; k <= inside.size(); ++k) {
                Part next{{k == 0 ? from : inside[k - 1], k == inside.size() ? to : inside[k], apex},
                          {part.sides[side], TriangleOrigin::none, TriangleOrigin::none},
                          {}};
                if (k == inside.size()) {
                    next.sides[1] = part.sides[(side + 1) % 3];
                    next.inside[1] = std::move(part.inside[(side + 1) % 3]);
                }
                if (k == 0) {
                    next.sides[2] = part.sides[(side + 2) % 3];
                    next.inside[2] = std::move(part.inside[(side + 2) % 3]);
                }
                open.push_back(std::move(next));
            }
        }
    }

    std::span<const Triangle> triangles_;
    std::span<const Vec3> vertices_;
    std::vector<Cut> cuts_;
};

}  // namespace

SplitMesh split_edges(const ProperMesh& proper, std::span<const EdgeOverlap> overlaps) {
    Splitter splitter(proper);
    for (const EdgeOverlap& overlap : overlaps) splitter.add(overlap);
    return splitter.split(proper);
}

}  // namespace ecods
