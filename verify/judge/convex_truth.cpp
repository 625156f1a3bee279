#include "judge/convex_truth.hpp"

#include <fmt/format.h>

#include <cmath>

#include "ecods/distance.hpp"
#include "ecods/error.hpp"
#include "ecods/intersection.hpp"
#include "judge/text.hpp"
#include "oracle/solid.hpp"

namespace ecods::judge {

bool is_same(const Depth& x, const Depth& y) {
    return same_bits(x.depth, y.depth) && x.a == y.a && x.b == y.b && same_bits(x.direction, y.direction);
}

bool is_same(const SignedDistance& x, const SignedDistance& y) {
    return same_bits(x.distance, y.distance) && x.kind == y.kind && x.a == y.a && x.b == y.b &&
           same_bits(x.point_a, y.point_a) && same_bits(x.point_b, y.point_b) && same_bits(x.direction, y.direction);
}

namespace {

// The number is less than zero where interiors meet, and none is -0.
SignedDistance to_signed_distance(const ClosestPoints& at, bool is_depth, const Vec3& direction) {
    const double distance = is_depth && at.distance > 0 ? -at.distance : at.distance;
    return {distance, at.kind, at.a, at.b, at.point_a, at.point_b, direction};
}

template <class Answer>
std::string text_of(const std::optional<Answer>& answer, const char* none) {
    return answer ? text(*answer) : none;
}

template <class Answer>
bool are_same(const std::optional<Answer>& x, const std::optional<Answer>& y) {
    return x.has_value() == y.has_value() && (!x || is_same(*x, *y));
}

template <class Answer>
std::optional<Wrong> require(const char* question, const std::string& how, const char* none,
                             const std::optional<Answer>& expected, const std::optional<Answer>& got) {
    if (are_same(expected, got)) return std::nullopt;
    return Wrong{question + how, text_of(expected, none), text_of(got, none)};
}

}  // namespace

Depth to_depth(const oracle::ExactDepth& exact) {
    return {oracle::nearest(exact.depth), to_feature(exact.a), to_feature(exact.b), exact.normal.nearest()};
}

std::string text(const Depth& depth) {
    return fmt::format("{:a}, {}, {} along {}", depth.depth, text(depth.a), text(depth.b), text(depth.direction));
}

std::string text(const SignedDistance& d) {
    const ClosestPoints at{d.distance, d.kind, d.a, d.b, d.point_a, d.point_b};
    return text(at) + " along " + text(d.direction);
}

auto ConvexTruth::answers_of(const oracle::ConvexPair& pair) -> Answers {
    Answers answers;
    if (const auto closest = pair.closest()) {
        answers.closest = to_closest_points(*closest);
        answers.signed_distance = to_signed_distance(*answers.closest, false, pair.direction()->nearest());
    }
    if (const auto depth = pair.depth()) {
        answers.depth = to_depth(*depth);
        const ClosestPoints deepest = to_closest_points(*pair.deepest());
        answers.signed_distance = to_signed_distance(deepest, true, answers.depth->direction);
    }
    return answers;
}

ConvexTruth::ConvexTruth(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b)
    : solids_{a, b},
      exact_(std::make_shared<const oracle::ConvexPair>(a.what->mesh(), a.pose, b.what->mesh(), b.pose)) {
    const oracle::ConvexPair swapped(b.what->mesh(), b.pose, a.what->mesh(), a.pose);
    of_ = {answers_of(*exact_), answers_of(swapped)};
}

std::string ConvexTruth::kind() const {
    if (!of_[0].depth) {
        return "apart, " + text(of_[0].closest->kind);
    }
    const Depth& depth = *of_[0].depth;
    const char* normal = depth.a.kind == Feature::Kind::face   ? "face of a"
                         : depth.b.kind == Feature::Kind::face ? "face of b"
                                                               : "edges";
    return std::string(depth.depth > 0 ? "deep, " : "touching, ") + normal;
}

ConvexTruth ConvexTruth::with(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b) const {
    ConvexTruth other = *this;
    other.solids_ = {a, b};
    return other;
}

std::optional<Wrong> ConvexTruth::ask_in_order(std::size_t order, const Ask& ask) const {
    const Posed<ConvexSolid>&a = solids_[order], &b = solids_[1 - order];
    const Answers& expected = of_[order];
    const std::string how = std::string(order == 0 ? "" : " of (b, a)") +
                            (ask.witness != nullptr ? ", with a witness" : "") +
                            (ask.memory == nullptr ? ", in the thread's memory" : "");
    const double d = ecods::distance(a, b, ask);
    if (!same_bits(d, distance())) return Wrong{"distance" + how, judge::text(distance()), judge::text(d)};
    std::optional<ClosestPoints> points = ecods::closest(a, b, ask);
    if (points->kind >= ClosestKind::intersecting) points.reset();
    if (auto wrong = require("closest", how, "a common point", expected.closest, points)) return wrong;
    if (ecods::intersects(a, b, ask) == expected.closest.has_value()) {
        return Wrong{"intersects" + how, judge::text(distance()), "the contrary"};
    }
    if (auto wrong = require("depth", how, "nothing", expected.depth, ecods::depth(a, b, ask))) return wrong;
    const SignedDistance found = ecods::signed_distance(a, b, ask);
    if (!is_same(expected.signed_distance, found)) {
        return Wrong{"signed_distance" + how, judge::text(expected.signed_distance), judge::text(found)};
    }
    const DistanceBounds bounds = ecods::signed_distance_bounds(a, b, ask);
    if (!same_bits(bounds.lower, found.distance) || !same_bits(bounds.upper, found.distance)) {
        return Wrong{"signed_distance_bounds" + how, judge::text(found.distance),
                     judge::text(bounds.lower) + " to " + judge::text(bounds.upper)};
    }
    return std::nullopt;
}

std::optional<Wrong> ConvexTruth::ask(QueryMemory& memory, PairWitness& witness) const {
    for (const std::size_t order : {0U, 1U}) {
        if (auto wrong = ask_in_order(order, memory)) return wrong;
    }
    if (auto wrong = ask_in_order(0, {})) return wrong;
    for (const std::size_t order : {0U, 0U, 1U}) {
        if (auto wrong = ask_in_order(order, {memory, witness})) return wrong;
    }
    return std::nullopt;
}

std::optional<Wrong> ConvexTruth::ask_bounds(QueryMemory& memory) const {
    const Posed<ConvexSolid>&a = solids_[0], &b = solids_[1];
    const std::optional<DepthBounds> found = depth_bounds(a, b, memory);
    if (!found) return of_[0].depth ? std::optional(Wrong{"depth_bounds", "bounds", "nothing"}) : std::nullopt;
    const DepthBounds& bounds = *found;
    const std::string got = fmt::format("{:a} to {:a}", bounds.lower, bounds.upper);
    if (!of_[0].depth) return Wrong{"depth_bounds", "nothing", got};
    const oracle::ExactRoot exact = exact_->depth()->depth;
    const bool are_zero = !exact.is_zero() || (bounds.lower == 0 && bounds.upper == 0);
    const bool is_upper = std::isinf(bounds.upper) || compare(exact, bounds.upper) <= 0;
    if (compare(exact, bounds.lower) < 0 || !is_upper || !are_zero) {
        return Wrong{"depth_bounds", "around " + judge::text(of_[0].depth->depth), got};
    }
    Posed<ConvexSolid> moved = b;
    moved.pose.t = bounds.parted;
    if (std::isfinite(bounds.upper) && oracle::compare_distance(bounds.parted, b.pose.t, bounds.upper) > 0) {
        return Wrong{"depth_bounds", "at least the length of its translation", got};
    }
    if (a.what->dimension() < 3 || b.what->dimension() < 3) {
        const auto deep = oracle::ConvexPair(a.what->mesh(), a.pose, b.what->mesh(), moved.pose).depth();
        if (deep && !deep->depth.is_zero())
            return Wrong{"depth_bounds", "a translation to which a plane parts them", got};
    } else if (oracle::solid_relation(soup(a), soup(moved)) > Relation::touching) {
        return Wrong{"depth_bounds", "a translation that parts them", got};
    }
    return std::nullopt;
}

std::optional<Wrong> ConvexTruth::ask_translations(QueryMemory& memory, std::span<const Vec3> directions) const {
    const auto found = ecods::depth(solids_[0], solids_[1], memory);
    if (!found || !std::isfinite(found->depth)) return std::nullopt;
    // Up to five roundings: three of the direction, which count for at most two, the depth's, and the product's.
    for (double factor = 1 + 0x1p-49; factor < 4; factor *= 2) {
        const Vec3 s = found->depth * factor * found->direction;
        if (!s.allFinite() || found->depth < 0x1p-1000) break;
        if (!exact_->is_beyond_depth(s)) return Wrong{"depth", "a translation that reaches it", text(s)};
        if (!exact_->are_parted_by(s)) return Wrong{"depth", "parted by its translation", text(s)};
    }
    for (const Vec3& direction : directions) {
        const Vec3 s = found->depth * direction;
        if (!s.allFinite() || exact_->compare_to_depth(s) >= 0) continue;
        if (exact_->are_parted_by(s)) return Wrong{"depth", "not parted by a shorter translation", text(s)};
    }
    return std::nullopt;
}

std::optional<Wrong> ask_for_hull(std::span<const Vec3> points) {
    const auto expected = oracle::hull_of(points);
    std::string wanted = "none", found = "none";
    if (expected) {
        wanted.clear();
        for (const std::uint32_t p : expected->points) wanted += fmt::format("{} ", p);
        for (const Triangle& t : expected->triangles) wanted += fmt::format("({} {} {})", t[0], t[1], t[2]);
    }
    try {
        const std::shared_ptr<const Mesh> hull = convex_hull(points);
        found.clear();
        std::size_t from = 0;
        for (const Vec3& vertex : hull->vertices()) {
            while (from < points.size() && points[from] != vertex) ++from;
            found += fmt::format("{} ", from++);
        }
        for (const Triangle& t : hull->triangles()) found += fmt::format("({} {} {})", t[0], t[1], t[2]);
    } catch (const NotSolid&) {
    }
    if (wanted == found) return std::nullopt;
    return Wrong{"convex_hull", wanted, found};
}

std::optional<Wrong> ask_whether_convex(const std::shared_ptr<const Mesh>& mesh) {
    const bool expected = oracle::convex_features(*mesh).has_value();
    bool found = true;
    try {
        const ConvexSolid solid(mesh);
    } catch (const NotSolid& error) {
        if (error.reason != NotSolid::Reason::dent && error.reason != NotSolid::Reason::no_interior) throw;
        found = false;
    }
    if (found == expected) return std::nullopt;
    return Wrong{"ConvexSolid", expected ? "convex" : "not convex", found ? "convex" : "not convex"};
}

}  // namespace ecods::judge
