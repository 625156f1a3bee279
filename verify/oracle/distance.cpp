#include "oracle/distance.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "oracle/contact.hpp"
#include "oracle/distance_blocks.hpp"
#include "oracle/float_environment.hpp"
#include "oracle/integer_points.hpp"
#include "oracle/triangle_distance.hpp"

namespace ecods::oracle {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// A pair of triangles that may be the closest one.
struct Candidate {
    double lower;
    TrianglePair pair;
};

ExactPoint to_exact_point(const IntegerPoint& p, long unit) {
    ExactPoint point;
    for (std::size_t k = 0; k < 3; ++k) point.x[k] = {p.num[k], p.den, unit};
    return point;
}

// ExactClosest, or what of it names features.
struct FeatureNames {
    Closeness kind = Closeness::intersecting;
    NamedFeature a, b;
};

// What the rule compares, the first number first.
template <class Named>
auto rank(const Named& c) {
    return std::tuple(c.kind, c.a.triangle, c.a.corner, c.b.triangle, c.b.corner, c.a.dimension);
}

// The least name of the same feature in all of the mesh.
NamedFeature least_name(const Soup& soup, const NamedFeature& feature) {
    const auto at = [&](std::uint32_t triangle, std::uint32_t corner) {
        return soup.vertices[soup.triangles[triangle][corner % 3]];
    };
    const Vec3 from = at(feature.triangle, feature.corner), to = at(feature.triangle, feature.corner + 1);
    for (std::uint32_t t = 0; feature.dimension < 2 && t < soup.triangles.size(); ++t) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            const Vec3 p = at(t, corner), q = at(t, corner + 1);
            const bool is_same = feature.dimension == 0 ? p == from : (p == from && q == to) || (p == to && q == from);
            if (is_same) return {feature.dimension, t, corner};
        }
    }
    return feature;
}

std::optional<ExactDirection> to_direction(const std::optional<Vector<mpz_class>>& v) {
    if (!v) return std::nullopt;
    return ExactDirection{*v};
}

}  // namespace

struct MeshDistances::Impl {
    std::array<Soup, 2> soups;
    std::unique_ptr<const FloatEnvironment> environment = std::make_unique<FloatEnvironment>();
    IntegerPoints points;
    std::array<TriangleBlocks, 2> blocks;

    Impl(const Soup& a, const Soup& b)
        : soups{a, b},
          points(a, b),
          blocks{TriangleBlocks(a.triangles, points.around[0]), TriangleBlocks(b.triangles, points.around[1])} {
        environment.reset();  // the caller's again
    }

    template <class N>
    TriangleOf<N> triangle(const std::vector<Vector<N>>& corners, std::size_t soup, std::uint32_t index) const {
        const Triangle& t = soups[soup].triangles[index];
        return TriangleOf<N>({corners[t[0]], corners[t[1]], corners[t[2]]});
    }
    TriangleOf<mpz_class> exact(std::size_t soup, std::uint32_t index) const {
        return triangle(points.exact[soup], soup, index);
    }

    Enclosure enclosure(const TrianglePair& pair) const {
        return enclose(triangle(points.around[0], 0, pair.a), triangle(points.around[1], 1, pair.b));
    }
    LeastFeatures least(const TrianglePair& pair) const {
        return least_features(exact(0, pair.a), exact(1, pair.b), enclosure(pair));
    }
    ExactRoot root(const LeastFeatures& least) const { return {least.num, least.den, points.unit}; }

    std::vector<Candidate> candidates() const;
    std::vector<Candidate> candidates_within(double d) const;
    ExactClosest closest(const TrianglePair& pair) const;
    ExactClosest closest(const TrianglePair& pair, const LeastFeatures& least) const;
    std::vector<FeatureNames> names(const TrianglePair& pair, const LeastFeatures& least) const;
    ExactCloseFeatures close_features(const FeatureNames& names) const;
};

// The nearest blocks first. Needs a FloatEnvironment.
std::vector<Candidate> MeshDistances::Impl::candidates() const {
    double upper = infinity;
    std::vector<Candidate> found;
    for (const BlockPair& block : block_pairs(blocks[0], blocks[1])) {
        if (block.lower > upper) break;
        for_each_pair(blocks[0], blocks[1], block, upper, [&](const TrianglePair& pair) {
            const Enclosure around = enclosure(pair);
            upper = std::min(upper, around.upper);
            if (around.lower <= upper) found.push_back({around.lower, pair});
        });
    }
    std::erase_if(found, [&](const Candidate& candidate) { return candidate.lower > upper; });
    std::ranges::sort(found, {}, &Candidate::pair);
    return found;
}

std::vector<Candidate> MeshDistances::Impl::candidates_within(double d) const {
    // The squared distance in the intervals' unit, rounded upwards.
    int exponent = 0;
    const double size = std::frexp(d, &exponent);
    const double limit = d == 0                           ? 0
                         : exponent - points.scale > 500  ? infinity
                         : exponent - points.scale < -500 ? 0x1p-1000
                                                          : std::ldexp(size, int(exponent - points.scale));
    const double square = limit == infinity ? infinity : std::max(limit * limit, d == 0 ? 0 : 0x1p-1000);
    std::vector<Candidate> found;
    for (const BlockPair& block : block_pairs(blocks[0], blocks[1])) {
        if (block.lower > square) break;
        for_each_pair(blocks[0], blocks[1], block, square, [&](const TrianglePair& pair) {
            const Enclosure around = enclosure(pair);
            if (around.lower <= square) found.push_back({around.lower, pair});
        });
    }
    std::ranges::sort(found, {}, &Candidate::pair);
    return found;
}

ExactClosest MeshDistances::Impl::closest(const TrianglePair& pair, const LeastFeatures& least) const {
    const auto a = exact(0, pair.a), b = exact(1, pair.b);
    ExactClosest result;
    result.distance = root(least);
    std::array<IntegerPoint, 2> ends;
    if (least.is_zero()) {
        result.a = {2, pair.a, 0};
        result.b = {2, pair.b, 0};
        ends[0] = ends[1] = shared_corners(a, b).front();
    } else {
        const FeaturePair& first = feature_pairs()[least.pairs.front()];
        result.kind = first.kind;
        result.a = {first.dimension_a, pair.a, first.a};
        result.b = {first.dimension_b, pair.b, first.b};
        ends = closest_points(first, a, b);
    }
    result.point_a = to_exact_point(ends[0], points.unit);
    result.point_b = to_exact_point(ends[1], points.unit);
    return result;
}

ExactClosest MeshDistances::Impl::closest(const TrianglePair& pair) const {
    return closest(pair, least(pair));
}

// Those with which a pair of triangles counts in close_features(), with the least names of the mesh.
std::vector<FeatureNames> MeshDistances::Impl::names(const TrianglePair& pair, const LeastFeatures& least) const {
    std::vector<std::size_t> found = least.pairs;
    if (least.is_zero()) {
        const auto a = exact(0, pair.a), b = exact(1, pair.b);
        const Contact contact(a, b);
        if (contact.is_crossing()) return {{Closeness::intersecting, {2, pair.a, 0}, {2, pair.b, 0}}};
        found = contact.features();
    }
    std::vector<FeatureNames> names;
    for (const std::size_t i : found) {
        const FeaturePair& f = feature_pairs()[i];
        names.push_back({f.kind, least_name(soups[0], {f.dimension_a, pair.a, f.a}),
                         least_name(soups[1], {f.dimension_b, pair.b, f.b})});
    }
    return names;
}

ExactCloseFeatures MeshDistances::Impl::close_features(const FeatureNames& names) const {
    if (names.kind == Closeness::intersecting) return {closest({names.a.triangle, names.b.triangle}), std::nullopt};
    const FeaturePair f{names.kind, names.a.dimension, names.a.corner, names.b.dimension, names.b.corner};
    const auto a = exact(0, names.a.triangle), b = exact(1, names.b.triangle);
    const FeatureDistance<mpz_class> d = feature_distance(f, a, b);
    const std::array<IntegerPoint, 2> ends = closest_points(f, a, b);
    ExactCloseFeatures result;
    result.closest = {
        {d.num, d.den, points.unit},         names.kind, names.a, names.b, to_exact_point(ends[0], points.unit),
        to_exact_point(ends[1], points.unit)};
    result.direction = to_direction(direction(f, a, b));
    return result;
}

// The size of a coordinate is a root, of which those at most half-way to the least double are zero.
Vec3 ExactDirection::nearest() const {
    const mpz_class all = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        const mpz_class square = v[k] * v[k], doubled = square << 2150;
        const double size = doubled <= all ? 0 : oracle::nearest(ExactRoot{square, all, 0});
        result[static_cast<Eigen::Index>(k)] = sgn(v[k]) < 0 && doubled > all ? -size : size;
    }
    return result;
}

Vec3 ExactPoint::nearest() const {
    return {oracle::nearest(x[0]), oracle::nearest(x[1]), oracle::nearest(x[2])};
}

MeshDistances::MeshDistances(const Soup& a, const Soup& b) : impl_(std::make_unique<Impl>(a, b)) {}
MeshDistances::~MeshDistances() = default;

ExactRoot MeshDistances::distance() const {
    const FloatEnvironment environment;
    ExactRoot nearest;
    bool is_first = true;
    for (const Candidate& candidate : impl_->candidates()) {
        const ExactRoot root = impl_->root(impl_->least(candidate.pair));
        if (is_first || compare(root, nearest) < 0) nearest = root;
        is_first = false;
        if (nearest.is_zero()) break;
    }
    return nearest;
}

bool MeshDistances::within(double d) const {
    return std::isinf(d) || compare(distance(), d) <= 0;
}

ExactClosest MeshDistances::closest() const {
    const FloatEnvironment environment;
    std::vector<std::pair<TrianglePair, LeastFeatures>> nearest;  // all at the least distance
    for (const Candidate& candidate : impl_->candidates()) {
        LeastFeatures least = impl_->least(candidate.pair);
        const int order = nearest.empty() ? -1 : compare(impl_->root(least), impl_->root(nearest.front().second));
        if (order < 0) nearest.clear();
        if (order <= 0) nearest.emplace_back(candidate.pair, std::move(least));
        if (nearest.front().second.is_zero()) break;  // ascending: the least pair
    }
    std::optional<ExactClosest> first;
    for (const auto& [pair, least] : nearest) {
        ExactClosest closest = impl_->closest(pair, least);
        if (!first || rank(closest) < rank(*first)) first = std::move(closest);
    }
    return *first;
}

std::vector<ExactClosest> MeshDistances::close_triangles(double d) const {
    const FloatEnvironment environment;
    std::vector<ExactClosest> close;
    for (const Candidate& candidate : impl_->candidates_within(d)) {
        const LeastFeatures least = impl_->least(candidate.pair);
        if (compare(impl_->root(least), d) <= 0) close.push_back(impl_->closest(candidate.pair, least));
    }
    return close;
}

std::vector<ExactCloseFeatures> MeshDistances::close_features(double d) const {
    const FloatEnvironment environment;
    std::vector<FeatureNames> names;
    for (const Candidate& candidate : impl_->candidates_within(d)) {
        const LeastFeatures least = impl_->least(candidate.pair);
        if (compare(impl_->root(least), d) > 0) continue;
        const auto found = impl_->names(candidate.pair, least);
        names.insert(names.end(), found.begin(), found.end());
    }
    std::ranges::sort(names, {}, rank<FeatureNames>);
    std::vector<ExactCloseFeatures> close;
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (i == 0 || rank(names[i]) != rank(names[i - 1])) close.push_back(impl_->close_features(names[i]));
    }
    return close;
}

std::vector<ExactIntersection> MeshDistances::intersections() const {
    const FloatEnvironment environment;
    std::vector<ExactIntersection> found;
    for (const Candidate& candidate : impl_->candidates_within(0)) {
        const TrianglePair& pair = candidate.pair;
        if (!impl_->least(pair).is_zero()) continue;
        const auto a = impl_->exact(0, pair.a), b = impl_->exact(1, pair.b);
        const Contact contact(a, b);
        found.push_back({pair, {}, to_direction(contact.normal())});
        for (const IntegerPoint& corner : contact.corners()) {
            found.back().corners.push_back(to_exact_point(corner, impl_->points.unit));
        }
    }
    return found;
}

ExactRoot MeshDistances::distance(std::uint32_t i, std::uint32_t j) const {
    const FloatEnvironment environment;
    return impl_->root(impl_->least({i, j}));
}

ExactClosest MeshDistances::closest(std::uint32_t i, std::uint32_t j) const {
    const FloatEnvironment environment;
    return impl_->closest(TrianglePair{i, j});
}

std::vector<ExactPoint> MeshDistances::intersection(std::uint32_t i, std::uint32_t j) const {
    const FloatEnvironment environment;
    std::vector<ExactPoint> corners;
    for (const IntegerPoint& corner : shared_corners(impl_->exact(0, i), impl_->exact(1, j))) {
        corners.push_back(to_exact_point(corner, impl_->points.unit));
    }
    return corners;
}

}  // namespace ecods::oracle
