#include "query/distance/triangle_distances.hpp"

#include <algorithm>
#include <utility>

#include "exact/measure/distance/fixed_distance.hpp"
#include "exact/measure/distance/guess_features.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "exact/measure/distance/name_features.hpp"
#include "exact/measure/round/distance_beyond.hpp"
#include "query/distance/triangle_features.hpp"

namespace ecods {

using namespace exact;

void TriangleDistances::bind(const BodyRef& a, const BodyRef& b) {
    points_.bind_pair(a, b);
    triangles_ = {a.mesh->triangles().data(), b.mesh->triangles().data()};
    for (Measured& m : measured_) m.is_known = false;
    slab_.forget();
}

DistanceInterval TriangleDistances::enclose(std::uint32_t i, std::uint32_t j) {
    const IntegerPair pair = integers(i, j);
    const FeaturePair features = guess_features(pair);
    const Enclosure enclosure = enclose_distance(pair, features);
    DistanceInterval interval{
        enclosure.lower, enclosure.upper, enclosure.is_certain, ClosestKind::intersecting, {}, {}};
    if (enclosure.is_certain) {
        interval.kind = static_cast<ClosestKind>(features.kind);
        interval.a = feature_key(feature_of(features, 0, i), triangles_[0][i]);
        interval.b = feature_key(feature_of(features, 1, j), triangles_[1][j]);
    }
    return interval;
}

const TriangleDistances::Measured& TriangleDistances::measured(const TrianglePair& pair) {
    if (measured_[1].is_known && measured_[1].pair == pair) std::swap(measured_[0], measured_[1]);
    if (measured_[0].is_known && measured_[0].pair == pair) return measured_[0];
    std::swap(measured_[0], measured_[1]);
    Measured& result = measured_[0];
    result.pair = pair;
    result.is_known = true;
    with_features(pair.a, pair.b, [&](const auto& points, const auto& features, const ClosestFeatures& guess) {
        const ClosestFeatures found = find_closest(points, features, guess);
        result.square.exponent = points.unit;
        if (found.standing == Standing::none) {
            result.square.num = {};
            result.square.den = Natural<denominator_limbs>(1);
        } else {
            features.measure(found.features, result.square);
            result.features = found.features;
        }
    });
    return result;
}

double TriangleDistances::distance(std::uint32_t i, std::uint32_t j) {
    return round_root(measured({i, j}).square);
}

std::optional<double> TriangleDistances::fixed_distance(const TrianglePair& pair, const DistanceInterval& interval) {
    if (!interval.is_certain) return std::nullopt;
    const FeatureNames names{interval.kind, feature_of(interval.a, pair.a, triangles_[0][pair.a]),
                             feature_of(interval.b, pair.b, triangles_[1][pair.b])};
    return exact::fixed_distance(integers(pair.a, pair.b), features_named(names));
}

int TriangleDistances::side_of_face(const TrianglePair& pair) {
    return exact::certain_side_of_face(integers(pair.a, pair.b));
}

double TriangleDistances::distance_beyond(const TrianglePair& pair, const ExactSum& margin) {
    return round_beyond(measured(pair).square, margin);
}

double TriangleDistances::signed_beyond(const TrianglePair& pair, const ExactSum& margin) {
    return round_signed_beyond(measured(pair).square, margin);
}

int TriangleDistances::compare(const TrianglePair& pair, const ExactSum& d) {
    return exact::compare(measured(pair).square, d);
}

int TriangleDistances::compare(std::uint32_t i, std::uint32_t j, double d) {
    return exact::compare(measured({i, j}).square, d);
}

int TriangleDistances::compare(const TrianglePair& first, const TrianglePair& second) {
    measured(first);
    const SquaredDistance& b = measured(second).square;
    const SquaredDistance& a = first == second ? b : measured_[1].square;
    return exact::compare(a, b);
}

void TriangleDistances::refer_to(const TrianglePair& pair) {
    slab_.forget();
    const FeaturePair f = measured(pair).features;
    if (!points_.is_exact() || measured(pair).square.num.is_zero()) return;
    const auto points = to_limbs(IntegerPoints<TwoLimbKernel, 6>{integers(pair.a, pair.b).at, points_.unit()});
    ExactFeatures<ClosestSlab::limb_count>(points).with_direction(
        f, [&](const auto& n, bool is_turned) { slab_.set(n, is_turned, points[f.a], points[3 + f.b]); });
}

bool TriangleDistances::is_not_nearer(const TrianglePair& pair) {
    if (!slab_.is_set()) return false;
    const auto is_outside = [&](std::size_t body, std::uint32_t vertex) {
        return slab_.is_outside(body, vertex, [&] {
            const IntegerFrame::Point& p = points_.at(body, vertex);
            return ClosestSlab::Point{to_limbs(p[0]), to_limbs(p[1]), to_limbs(p[2])};
        });
    };
    return std::ranges::all_of(triangles_[0][pair.a], [&](std::uint32_t vertex) { return is_outside(0, vertex); }) &&
           std::ranges::all_of(triangles_[1][pair.b], [&](std::uint32_t vertex) { return is_outside(1, vertex); });
}

}  // namespace ecods
