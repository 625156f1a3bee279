// A ClosestSlab is the space between two planes through two closest points, perpendicular to the segment between the
// points. The distance of two sets on opposite sides of the slab is at least the distance of the points. So a search
// that has found the points need not measure triangles outside the slab: most triangles that share a closest vertex or
// edge, and all triangles at the same distance on parallel faces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "exact/measure/round/limb_vectors.hpp"
#include "exact/number/limbs.hpp"
#include "exact/point/vertex_cache.hpp"

namespace ecods::exact {

// A ClosestSlab tests vertices exactly, for points whose coordinates have two limbs. A small cache stores the result
// for each vertex.
class ClosestSlab {
  public:
    static constexpr int limb_count = 2;
    using Point = std::array<Limbs<limb_count>, 3>;

    bool is_set() const noexcept { return is_set_; }
    void forget() noexcept { is_set_ = false; }

    // Sets the slab's normal and planes. `n` points from the first body to the second; if is_turned, from the second to
    // the first. x is the point of the first body and y the point of the second, in the two planes of the slab.
    template <int M>
    void set(const LimbVector<M>& n, bool is_turned, const Point& x, const Point& y) noexcept {
        is_set_ = true;
        for (std::size_t k = 0; k < 3; ++k) {
            normal_[k] = widened<normal_limbs>(is_turned ? negated<M>(n[k]) : n[k]);
        }
        ends_ = {x, y};
        for (auto& side : sides_) side.clear();
    }

    // Returns true if vertex `vertex` of body `body` is not inside the open slab, but on the body's own side of the
    // slab. point_of() returns the vertex's point.
    template <class PointOf>
    bool is_outside(std::size_t body, std::uint32_t vertex, PointOf&& point_of) noexcept {
        return sides_[body].get(vertex, [&](bool& is_outside) {
            const LimbVector<limb_count> from = difference<limb_count>(point_of(), ends_[body]);
            const int side = sign<normal_limbs + limb_count>(dot<normal_limbs, limb_count>(normal_, from));
            is_outside = body == 0 ? side <= 0 : side >= 0;
        });
    }

  private:
    // The longest normal is (u.u) w - (w.u) u; exact_features.hpp derives the width of this normal, and of its product
    // with a difference.
    static constexpr int normal_limbs = 3 * limb_count;

    bool is_set_ = false;
    LimbVector<normal_limbs> normal_{};
    std::array<Point, 2> ends_{};
    std::array<VertexCache<bool, 256>, 2> sides_;
};

}  // namespace ecods::exact
