// The points of two features that are closest to each other, in integers.
//
// All points are counted from the first corner of the first triangle, from which integer points are counted. A point at
// a part num / den of an edge u from p on is (den p + num u) / den. With differences below 2^k, den is below 2^(4k +
// 4), and a point of a triangle less another is below 2^k: coordinates times den are below 2^(5k + 4), and have a sign.
#pragma once

#include <algorithm>
#include <array>

#include "exact/measure/distance/exact_features.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/exact_point.hpp"
#include "exact/measure/round/limb_vectors.hpp"

namespace ecods::exact {

template <int L>
class ClosestPointsOf {
  public:
    ClosestPointsOf(const ExactFeatures<L>& features, const FeaturePair& pair, int unit) noexcept
        : features_(features), pair_(pair), unit_(unit) {}

    // The points of both triangles. The features must hold closest points.
    void find(std::array<ExactPoint, 2>& points) const noexcept {
        const std::size_t side = pair_.vertex_side, of = 1 - side;
        switch (pair_.kind) {
            case FeatureKind::vertex_vertex:
                at_corner(0, pair_.a, points[0]);
                at_corner(1, pair_.b, points[1]);
                return;
            case FeatureKind::vertex_edge:
                at_corner(side, pair_.corner(side), points[side]);
                on_edge(of, pair_.corner(of), points[of]);
                return;
            case FeatureKind::vertex_face:
                at_corner(side, pair_.corner(side), points[side]);
                on_face(of, points[of]);
                return;
            case FeatureKind::edge_edge:
                on_crossing_edges(points);
                return;
        }
    }

  private:
    using Vector = LimbVector<L>;
    using Weight = Magnitude<4 * L>;
    static constexpr int k = ExactFeatures<L>::coordinate_bits + 1;
    static_assert(5 * k + 5 < 64 * (5 * L));

    void at_corner(std::size_t side, std::size_t i, ExactPoint& point) const noexcept {
        Weight one{};
        one.limbs[0] = 1;
        set(side, i, one, nullptr, nullptr, nullptr, nullptr, point);
    }

    void on_edge(std::size_t side, std::size_t edge, ExactPoint& point) const noexcept {
        const Vector w = features_.between(pair_), u = features_.from(side, edge, 1);
        Magnitude<2 * L> along = dot<L, L>(w, u);
        if (side == 1) along = negated<2 * L>(along);
        const Weight den = widened<4 * L>(dot<L, L>(u, u)), s = widened<4 * L>(along);
        set(side, edge, den, &s, &u, nullptr, nullptr, point);
    }

    void on_face(std::size_t side, ExactPoint& point) const noexcept {
        Vector foot = features_.between(pair_);
        if (side == 1) {
            for (auto& x : foot) x = negated<L>(x);
        }
        const Vector u = features_.from(side, 0, 1), v = features_.from(side, 0, 2);
        const LimbVector<2 * L> n = cross<L>(u, v);
        const Weight den = dot<2 * L, 2 * L>(n, n);
        const Weight s = dot<2 * L, 2 * L>(cross<L>(foot, v), n), t = dot<2 * L, 2 * L>(cross<L>(u, foot), n);
        set(side, 0, den, &s, &u, &t, &v, point);
    }

    void on_crossing_edges(std::array<ExactPoint, 2>& points) const noexcept {
        const Vector w = features_.between(pair_), u = features_.from(0, pair_.a, 1), v = features_.from(1, pair_.b, 1);
        const LimbVector<2 * L> n = cross<L>(u, v);
        const Weight den = dot<2 * L, 2 * L>(n, n);
        const Weight s = dot<2 * L, 2 * L>(cross<L>(w, v), n), t = dot<2 * L, 2 * L>(cross<L>(w, u), n);
        set(0, pair_.a, den, &s, &u, nullptr, nullptr, points[0]);
        set(1, pair_.b, den, &t, &v, nullptr, nullptr, points[1]);
    }

    // (den p + s u + t v) / den for corner p = i of `side`.
    void set(std::size_t side, std::size_t i, const Weight& den, const Weight* s, const Vector* u, const Weight* t,
             const Vector* v, ExactPoint& point) const noexcept {
        const Vector p = features_.position(side, i);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            Limbs<5 * L> sum{};
            add_product<4 * L, L>(sum, den, p[axis]);
            if (s != nullptr) add_product<4 * L, L>(sum, *s, (*u)[axis]);
            if (t != nullptr) add_product<4 * L, L>(sum, *t, (*v)[axis]);
            const Magnitude<5 * L> num = magnitude<5 * L>(sum);
            point.num[axis].size.assign(num.limbs);
            point.num[axis].is_negative = num.negative != 0;
        }
        point.den.assign(den.limbs);
        point.unit = unit_;
    }

    const ExactFeatures<L>& features_;
    FeaturePair pair_;
    int unit_;
};

}  // namespace ecods::exact
