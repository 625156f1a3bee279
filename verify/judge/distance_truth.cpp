#include "judge/distance_truth.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "judge/feature_truth.hpp"
#include "judge/text.hpp"
#include "oracle/float_environment.hpp"

namespace ecods::judge {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Of numbers from 0 on: where subnormals are flushed, all of them compare as zero.
bool is_less(double x, double y) {
    return std::bit_cast<std::uint64_t>(x) < std::bit_cast<std::uint64_t>(y);
}

}  // namespace

Feature to_feature(const oracle::NamedFeature& feature) {
    return {static_cast<Feature::Kind>(feature.dimension), feature.triangle, feature.corner};
}

ClosestPoints to_closest_points(const oracle::ExactClosest& exact) {
    ClosestPoints closest;
    closest.distance = oracle::nearest(exact.distance);
    closest.kind = static_cast<ClosestKind>(exact.kind);
    closest.a = to_feature(exact.a);
    closest.b = to_feature(exact.b);
    closest.point_a = exact.point_a.nearest();
    closest.point_b = exact.point_b.nearest();
    return closest;
}

bool is_same(const ClosestPoints& x, const ClosestPoints& y) {
    return same_bits(x.distance, y.distance) && x.kind == y.kind && x.a == y.a && x.b == y.b &&
           same_bits(x.point_a, y.point_a) && same_bits(x.point_b, y.point_b);
}

// By bits: nextafter() is wrong where subnormals are flushed.
double neighbour(double x, int step) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(x) + static_cast<std::uint64_t>(step));
}

std::string text(double x) {
    return fmt::format("{:a}", x);
}

std::string text(const ClosestPoints& closest) {
    return fmt::format("{:a} {}: {} {}, {} {}", closest.distance, text(closest.kind), text(closest.a),
                       text(closest.point_a), text(closest.b), text(closest.point_b));
}

namespace {

std::optional<Wrong> require(const char* question, double expected, double got) {
    if (same_bits(expected, got)) return std::nullopt;
    return Wrong{question, text(expected), text(got)};
}

std::optional<Wrong> require(const char* question, const ClosestPoints& expected, const ClosestPoints& got) {
    if (is_same(expected, got)) return std::nullopt;
    return Wrong{question, text(expected), text(got)};
}

}  // namespace

DistanceTruth::DistanceTruth(const Posed<MeshShape>& a, const Posed<MeshShape>& b, const Questions& questions)
    : a_(a), b_(b) {
    const oracle::MeshDistances distances(soup(a), soup(b));
    const oracle::ExactClosest exact = distances.closest();
    exact_ = exact.distance;
    closest_ = to_closest_points(exact);
    mirrored_ = to_closest_points(oracle::MeshDistances(soup(b), soup(a)).closest());
    const double d = closest_.distance;
    std::vector<double> limits{0,
                               d,
                               d / 2,
                               std::min(2 * d, std::numeric_limits<double>::max()),
                               infinity,
                               std::numeric_limits<double>::max(),
                               std::numeric_limits<double>::denorm_min()};
    if (d > 0) limits.push_back(neighbour(d, -1));
    if (d < infinity) limits.push_back(neighbour(d, 1));
    for (const double limit : limits) within_.push_back({limit, oracle::compare(exact_, limit) <= 0});
    if (questions.has_bounds) {
        tolerances_ = {{},
                       {.relative = 1e-6},
                       {.relative = 0.5},
                       {.absolute = d / 3},
                       {.absolute = infinity},
                       {.relative = 1e-9, .max_distance = d / 2},
                       {.max_distance = d},
                       {.relative = 1e-3, .absolute = d * 1e-5, .max_distance = 2 * d}};
    }
    if (!questions.has_lists || std::isinf(d)) return;
    for (const double limit :
         {d, d > 0 ? neighbour(d, -1) : 0, std::min(d * 1.125, std::numeric_limits<double>::max())}) {
        lists_.push_back({limit, {}, to_close_features(distances.close_features(limit))});
        for (const auto& close : distances.close_triangles(limit)) {
            lists_.back().closest.push_back(to_closest_points(close));
        }
    }
    intersections_ = to_intersections(distances.intersections());
}

std::optional<Wrong> DistanceTruth::ask(QueryMemory& memory, PairWitness& witness) const {
    if (auto wrong = ask_distance(memory, witness)) return wrong;
    if (auto wrong = ask_closest(memory, witness)) return wrong;
    if (auto wrong = ask_bounds(memory, witness)) return wrong;
    return ask_lists(memory);
}

std::optional<Wrong> DistanceTruth::ask_distance(QueryMemory& memory, PairWitness& witness) const {
    const double d = distance();
    if (auto wrong = require("distance", d, ecods::distance(a_, b_, memory))) return wrong;
    if (auto wrong = require("distance, swapped", d, ecods::distance(b_, a_, memory))) return wrong;
    if (auto wrong = require("distance, with a witness", d, ecods::distance(a_, b_, {memory, witness}))) return wrong;
    if (auto wrong = require("distance, with its own witness", d, ecods::distance(a_, b_, {memory, witness}))) {
        return wrong;
    }
    if (auto wrong = require("distance, in the thread's memory", d, ecods::distance(a_, b_))) return wrong;
    if (auto wrong = ask_counts(memory)) return wrong;
    for (const auto& [limit, expected] : within_) {
        if (within(a_, b_, limit, memory) == expected && within(b_, a_, limit, memory) == expected &&
            within(a_, b_, limit, {memory, witness}) == expected) {
            continue;
        }
        return Wrong{"within " + text(limit), expected ? "yes" : "no", "the contrary, in one order or with a witness"};
    }
    return std::nullopt;
}

std::optional<Wrong> DistanceTruth::ask_counts(QueryMemory& memory) const {
    QueryCounts counts, expected = memory.counts();
    if (auto wrong = require("distance, counted", distance(), ecods::distance(a_, b_, {counts, memory}))) return wrong;
    expected += counts;
    if (counts.queries == 1 && expected == memory.counts()) return std::nullopt;
    return Wrong{"counts of a distance", "one question, and as the memory has counted",
                 fmt::format("{} questions, or other work", counts.queries)};
}

std::optional<Wrong> DistanceTruth::ask_closest(QueryMemory& memory, PairWitness& witness) const {
    if (auto wrong = require("closest", closest_, ecods::closest(a_, b_, memory))) return wrong;
    if (auto wrong = require("closest, swapped", mirrored_, ecods::closest(b_, a_, memory))) return wrong;
    return require("closest, with a witness", closest_, ecods::closest(a_, b_, {memory, witness}));
}

std::optional<std::string> DistanceTruth::defect(const DistanceBounds& bounds,
                                                 const DistanceTolerance& tolerance) const {
    const oracle::FloatEnvironment environment;  // rationals are not made of subnormals that are flushed
    const auto& [lower, upper] = bounds;
    if (std::isnan(lower) || std::isnan(upper) || std::signbit(lower) || is_less(upper, lower)) return "no interval";
    if (std::isinf(lower) ? oracle::compare(exact_, std::numeric_limits<double>::max()) <= 0
                          : oracle::compare(exact_, lower) < 0) {
        return "lower end too high";
    }
    if (oracle::compare(exact_, upper) > 0) return "upper end too low";
    if (is_less(tolerance.max_distance, lower) || same_bits(upper, lower) || same_bits(upper, neighbour(lower, 1))) {
        return std::nullopt;
    }
    if (std::isinf(tolerance.absolute) || (std::isinf(tolerance.relative) && is_less(0, lower))) return std::nullopt;
    if (std::isinf(upper)) return "no upper end";
    const mpq_class width = mpq_class(upper) - mpq_class(lower);
    if (width <= mpq_class(tolerance.absolute)) return std::nullopt;
    if (width <= mpq_class(tolerance.relative) * mpq_class(lower)) return std::nullopt;
    return "too wide";
}

std::optional<Wrong> DistanceTruth::ask_bounds(QueryMemory& memory, PairWitness& witness) const {
    for (const DistanceTolerance& tolerance : tolerances_) {
        for (const DistanceBounds& bounds :
             {distance_bounds(a_, b_, tolerance, memory), distance_bounds(b_, a_, tolerance, memory),
              distance_bounds(a_, b_, tolerance, {memory, witness})}) {
            const auto found = defect(bounds, tolerance);
            if (!found) continue;
            return Wrong{fmt::format("bounds: relative {:a}, absolute {:a}, at most {:a}", tolerance.relative,
                                     tolerance.absolute, tolerance.max_distance),
                         text(distance()), fmt::format("{}: {:a} to {:a}", *found, bounds.lower, bounds.upper)};
        }
    }
    return std::nullopt;
}

std::optional<Wrong> DistanceTruth::ask_lists(QueryMemory& memory) const {
    for (const auto& [limit, expected, features] : lists_) {
        const std::vector<ClosestPoints> got = close_triangles(a_, b_, limit, memory);
        const std::string question = "close triangles at " + text(limit);
        if (got.size() != expected.size()) {
            return Wrong{question, std::to_string(expected.size()), std::to_string(got.size())};
        }
        for (std::size_t i = 0; i < got.size(); ++i) {
            if (!is_same(expected[i], got[i])) return Wrong{question, text(expected[i]), text(got[i])};
        }
        if (auto wrong = require("close features at " + text(limit), features, close_features(a_, b_, limit, memory))) {
            return wrong;
        }
    }
    if (intersections_) return require("intersections", *intersections_, intersections(a_, b_, memory));
    return std::nullopt;
}

}  // namespace ecods::judge
