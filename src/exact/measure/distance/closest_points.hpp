// find_closest_points computes in integers the two points of two features that are closest to each other.
//
// All points are relative to the first corner of the first triangle. The point p + (num / den) u of an edge u that
// begins at p is (den p + num u) / den. With differences below 2^k, den is below 2^(4k + 4), and the difference of two
// points of triangles is below 2^k. So coordinates times den are below 2^(5k + 4), and have a sign.
#pragma once

#include <array>

#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/measure/round/limb_vectors.hpp"

namespace ecods::exact {

// A WeightedPoint is the point num / den, relative to the first corner of the first triangle.
template <int L>
struct WeightedPoint {
    static constexpr int k = ExactFeatures<L>::coordinate_bits + 1;
    static_assert(5 * k + 5 < 64 * (5 * L));

    std::array<Magnitude<5 * L>, 3> num;
    Limbs<4 * L> den;

    void assign_to(ExactPoint& point, int unit) const noexcept {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            point.num[axis].size.assign(num[axis].limbs);
            point.num[axis].is_negative = num[axis].negative != 0;
        }
        point.den.assign(den);
        point.unit = unit;
    }
};

// A Weighted refers to the two factors of a product: a weight and a vector.
template <int L>
struct Weighted {
    const Magnitude<4 * L>& weight;
    const LimbVector<L>& vector;
};

// Returns the point p + (s u) / den, or p + (s u + t v) / den. Each term, s u and t v, is a Weighted.
template <int L, class... Terms>
WeightedPoint<L> weighted_point(const Magnitude<4 * L>& den, const LimbVector<L>& p, const Terms&... terms) noexcept {
    WeightedPoint<L> point;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Limbs<5 * L> sum{};
        add_product<4 * L, L>(sum, den, p[axis]);
        (add_product<4 * L, L>(sum, terms.weight, terms.vector[axis]), ...);
        point.num[axis] = magnitude<5 * L>(sum);
    }
    point.den = den.limbs;
    return point;
}
template <int L>
WeightedPoint<L> corner_point(const LimbVector<L>& p) noexcept {
    return weighted_point<L>(Magnitude<4 * L>{{1}, 0}, p);
}

// Sets points[0] and points[1] to the closest points of the first and the second triangle, in units of 2^unit. The
// features f must contain closest points.
template <int L>
void find_closest_points(const ExactFeatures<L>& features, const FeaturePair& f, int unit,
                         std::array<ExactPoint, 2>& points) noexcept {
    for (const std::size_t side : {0, 1}) {
        if (f.has_vertex(side)) corner_point<L>(features.position(side, f.corner(side))).assign_to(points[side], unit);
    }
    if (f.kind == FeatureKind::vertex_vertex) return;
    const std::size_t of = 1 - f.vertex_side, corner = f.corner(of);
    const LimbVector<L> p = features.position(of, corner);
    if (f.kind == FeatureKind::vertex_edge) {
        const auto foot = features.foot_on_edge(f);
        const Magnitude<4 *L> s = widened<4 * L>(foot.s), den = widened<4 * L>(foot.den);
        weighted_point<L>(den, p, Weighted<L>{s, foot.u}).assign_to(points[of], unit);
        return;
    }
    const auto feet = features.feet(f, features.normal(f));
    if (f.kind == FeatureKind::vertex_face) {
        const LimbVector<L> u = features.from(of, 0, 1), v = features.from(of, 0, 2);
        weighted_point<L>(feet.den, p, Weighted<L>{feet.s, u}, Weighted<L>{feet.t, v}).assign_to(points[of], unit);
        return;
    }
    const std::array<Magnitude<4 * L>, 2> weights{feet.s, feet.t};
    for (const std::size_t side : {0, 1}) {
        const LimbVector<L> edge = features.from(side, f.corner(side), 1);
        const LimbVector<L> begin = features.position(side, f.corner(side));
        weighted_point<L>(feet.den, begin, Weighted<L>{weights[side], edge}).assign_to(points[side], unit);
    }
}

// Instances for all numbers of limbs are compiled in closest_points.cpp.
extern template void find_closest_points(const ExactFeatures<1>&, const FeaturePair&, int,
                                         std::array<ExactPoint, 2>&) noexcept;
extern template void find_closest_points(const ExactFeatures<2>&, const FeaturePair&, int,
                                         std::array<ExactPoint, 2>&) noexcept;
extern template void find_closest_points(const ExactFeatures<4>&, const FeaturePair&, int,
                                         std::array<ExactPoint, 2>&) noexcept;
extern template void find_closest_points(const ExactFeatures<8>&, const FeaturePair&, int,
                                         std::array<ExactPoint, 2>&) noexcept;
extern template void find_closest_points(const ExactFeatures<20>&, const FeaturePair&, int,
                                         std::array<ExactPoint, 2>&) noexcept;
extern template void find_closest_points(const ExactFeatures<limb_count_max>&, const FeaturePair&, int,
                                         std::array<ExactPoint, 2>&) noexcept;

}  // namespace ecods::exact
