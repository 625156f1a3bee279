#include "fuzz/pairs/ask_distances.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <string>

#include "oracle/distance.hpp"
#include "query/distance/triangle_distances.hpp"

namespace ecods::fuzz {
namespace {

using judge::Wrong;
using scenes::DistanceCase;

int sign(int x) {
    return (x > 0) - (x < 0);
}

// One order of the bodies.
class Pairs {
  public:
    Pairs(const DistanceCase& made, bool is_swapped)
        : a_(is_swapped ? *made.b : *made.a),
          b_(is_swapped ? *made.a : *made.b),
          pose_a_(is_swapped ? made.pose_b : made.pose_a),
          pose_b_(is_swapped ? made.pose_a : made.pose_b),
          extent_a_(exact::measure(a_)),
          extent_b_(exact::measure(b_)),
          truth_({a_.vertices(), a_.triangles(), pose_a_}, {b_.vertices(), b_.triangles(), pose_b_}) {
        distances_.bind({&a_, &extent_a_, &pose_a_}, {&b_, &extent_b_, &pose_b_});
    }

    TrianglePair any(scenes::Random& random) const {
        return {random.below(static_cast<std::uint32_t>(a_.triangles().size())),
                random.below(static_cast<std::uint32_t>(b_.triangles().size()))};
    }

    std::optional<Wrong> ask(const TrianglePair& pair) {
        const oracle::ExactClosest exact = truth_.closest(pair.a, pair.b);
        const ClosestPoints expected = judge::to_closest_points(exact);
        const double d = expected.distance;
        const DistanceInterval around = distances_.enclose(pair.a, pair.b);
        if (!(around.lower >= 0) || oracle::compare(exact.distance, around.lower) < 0 ||
            oracle::compare(exact.distance, around.upper) > 0) {
            return Wrong{name("enclose", pair), judge::text(d),
                         fmt::format("{:a} to {:a}", around.lower, around.upper)};
        }
        if (const double got = distances_.distance(pair.a, pair.b);
            std::bit_cast<std::uint64_t>(got) != std::bit_cast<std::uint64_t>(d)) {
            return Wrong{name("distance", pair), judge::text(d), judge::text(got)};
        }
        for (const double limit :
             {d, d > 0 ? judge::neighbour(d, -1) : 0, std::isinf(d) ? 0 : judge::neighbour(d, 1), 0.0, d / 2}) {
            const int order = sign(distances_.compare(pair.a, pair.b, limit));
            const int expected_order = sign(oracle::compare(exact.distance, limit));
            if (order == expected_order) continue;
            return Wrong{name("compare with " + judge::text(limit), pair), std::to_string(expected_order),
                         std::to_string(order)};
        }
        const ClosestPoints got = distances_.closest(pair.a, pair.b);
        if (!judge::is_same(got, expected)) {
            return Wrong{name("closest", pair), judge::text(expected), judge::text(got)};
        }
        return std::nullopt;
    }

    std::optional<Wrong> ask(const TrianglePair& first, const TrianglePair& second) {
        const int order = sign(distances_.compare(first, second));
        const int expected =
            sign(oracle::compare(truth_.distance(first.a, first.b), truth_.distance(second.a, second.b)));
        if (order == expected) return std::nullopt;
        return Wrong{name("compare", first) + name(" with that", second), std::to_string(expected),
                     std::to_string(order)};
    }

  private:
    static std::string name(const std::string& question, const TrianglePair& pair) {
        return fmt::format("{} of triangles {} and {}", question, pair.a, pair.b);
    }

    const Mesh& a_;
    const Mesh& b_;
    Pose pose_a_, pose_b_;
    exact::MeshExtent extent_a_, extent_b_;
    oracle::MeshDistances truth_;
    TriangleDistances distances_;
};

}  // namespace

std::optional<Wrong> ask_triangles(const DistanceCase& made, scenes::Random& random) {
    const std::size_t pair_count = made.a->triangles().size() * made.b->triangles().size();
    for (const bool is_swapped : {false, true}) {
        Pairs pairs(made, is_swapped);
        for (std::size_t i = 0; i < std::min<std::size_t>(pair_count, 4); ++i) {
            const TrianglePair pair = pairs.any(random);
            if (auto wrong = pairs.ask(pair)) return wrong;
            if (auto wrong = pairs.ask(pair, pairs.any(random))) return wrong;
        }
    }
    return std::nullopt;
}

}  // namespace ecods::fuzz
