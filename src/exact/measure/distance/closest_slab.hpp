// A ClosestSlab is the slab between two closest points, perpendicular to the segment between them. Two sets on opposite
// sides of the slab are not nearer to each other than these points. So a search that has found the points need not
// measure triangles outside the slab: most triangles that share a closest vertex or edge, and all that tie across
// parallel faces.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "exact/measure/round/limb_vectors.hpp"
#include "exact/number/limbs.hpp"
#include "exact/point/vertex_cache.hpp"

namespace ecods::exact {

// Decides exactly, for points of two limbs. A small cache keeps the answer for each vertex.
class ClosestSlab {
  public:
    static constexpr int limb_count = 2;
    using Point = std::array<Limbs<limb_count>, 3>;

    bool is_set() const noexcept { return is_set_; }
    void forget() noexcept { is_set_ = false; }

    // Sets the slab. `n` points from the first body to the second, or the other way if is_turned; x and y are points of
    // the first and the second body in the two planes of the slab.
    template <int M>
    void set(const LimbVector<M>& n, bool is_turned, const Point& x, const Point& y) noexcept {
        is_set_ = true;
        for (std::size_t k = 0; k < 3; ++k) {
            normal_[k] = widened<normal_limbs>(is_turned ? negated<M>(n[k]) : n[k]);
        }
        ends_ = {x, y};
        for (auto& side : sides_) side.clear();
    }

    // True if the point of a vertex is outside the open slab on its own body's side.
    template <class PointOf>
    bool is_outside(std::size_t body, std::uint32_t vertex, PointOf&& point_of) noexcept {
        return sides_[body].get(vertex, [&](bool& is_outside) {
            const LimbVector<limb_count> from = difference<limb_count>(point_of(), ends_[body]);
            const int side = sign<normal_limbs + limb_count>(dot<normal_limbs, limb_count>(normal_, from));
            is_outside = body == 0 ? side <= 0 : side >= 0;
        });
    }

  private:
    // The longest normal is (u.u) w - (w.u) u; exact_features.hpp derives its width and the width of its product.
    static constexpr int normal_limbs = 3 * limb_count;

    bool is_set_ = false;
    LimbVector<normal_limbs> normal_{};
    std::array<Point, 2> ends_{};
    std::array<VertexCache<bool, 256>, 2> sides_;
};

}  // namespace ecods::exact
