// FlatDifference decides whether the Minkowski difference of two flat convex solids lies in a plane, in integers of L
// limbs.
#pragma once

#include <cstdint>
#include <optional>

#include "exact/measure/round/direction.hpp"
#include "query/depth/exact_depth.hpp"
#include "query/depth/exact_differences.hpp"

namespace ecods::depths {

template <int L>
class FlatDifference {
  public:
    // Both solids must be flat.
    explicit FlatDifference(const ExactDifferences<L>& points) : points_(points) {}

    // Returns the depth 0, with the normal that Depth promises; nullopt if the difference does not lie in a plane.
    std::optional<ExactDepth> find() const {
        const std::optional<Normal> n = normal();
        if (!n) return std::nullopt;
        return ExactDepth{{whole(0), whole(1)}, 0, exact::round_direction<2 * L>(*n)};
    }

  private:
    using Vector = exact::LimbVector<L>;
    using Normal = exact::LimbVector<2 * L>;

    const convex::Hull& hull(std::size_t side) const noexcept { return points_.hull(side); }
    bool is_polygon(std::size_t side) const noexcept { return !hull(side).faces.empty(); }
    bool is_segment(std::size_t side) const noexcept { return hull(side).faces.empty() && !hull(side).edges.empty(); }

    Vector between(std::size_t side, std::uint32_t from, std::uint32_t to) const noexcept {
        return exact::difference<L>(points_.point(side, to), points_.point(side, from));
    }
    Vector along(std::size_t side) const noexcept {
        const auto& [from, to] = hull(side).edges[0].ends;
        return between(side, from, to);
    }

    convex::HullFeature whole(std::size_t side) const noexcept {
        return {is_polygon(side)   ? Feature::Kind::face
                : is_segment(side) ? Feature::Kind::edge
                                   : Feature::Kind::vertex,
                0};
    }

    std::optional<Normal> normal() const {
        for (const std::size_t side : {0, 1}) {
            if (!is_polygon(side)) continue;
            const auto cycle = hull(side).cycle_of(0);
            const std::uint32_t from = cycle[0].vertex;
            const Normal n =
                exact::cross<L>(between(side, from, cycle[1].vertex), between(side, from, cycle[2].vertex));
            return is_level(1 - side, n) ? std::optional(n) : std::nullopt;
        }
        if (is_segment(0) && is_segment(1)) {
            const Normal n = exact::cross<L>(along(0), along(1));
            if (!exact::is_zero_vector<2 * L>(n)) return n;
        }
        for (const std::size_t side : {0, 1}) {
            if (is_segment(side)) return exact::across<L>(along(side));
        }
        return exact::across<L>({});
    }

    // Returns true if the solid lies in a plane perpendicular to n.
    bool is_level(std::size_t side, const Normal& n) const noexcept {
        for (std::uint32_t v = 1; v < hull(side).vertex_count(); ++v) {
            if (exact::sign<3 * L>(exact::dot<2 * L, L>(n, between(side, 0, v))) != 0) return false;
        }
        return true;
    }

    const ExactDifferences<L>& points_;
};

}  // namespace ecods::depths
