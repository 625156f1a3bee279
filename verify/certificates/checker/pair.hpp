// Two bodies, and proofs that their parts are apart.
#pragma once

#include "body.hpp"

namespace certificate_checker {

// Half the sum of two doubles. Infinity stands for 2^1024.
using Midpoint = std::array<double, 2>;

// When two parts are apart along a vector. The last two: the gap beside the distance m.
enum class Gap : std::uint8_t { positive, weak, half_open, at_least, more_than };
struct Rule {
    Gap gap = Gap::positive;
    Midpoint m{};
};
// A vector n that parts are measured along: in doubles, scaled to at most 1, and if need be in integers.
struct Axis {
    AxisLine source;
    std::array<std::uint32_t, 2> triangles;  // parts, of a and of b
    Vector<Approximate> n;
    std::array<Direction, 2> along;  // of a and of b
    double need = 0;                 // a gap in doubles that is greater than this proves that parts are apart
    std::optional<Vector<Integer>> exact;
};

// The ranges of one side's parts of a step along its axes: part number i, axis k at k * count of parts + i.
struct Ranges {
    std::vector<double> low, high;
    std::vector<std::uint8_t> is_best;  // in doubles
    std::vector<std::optional<Range<Integer>>> exact;
};

class Pair {
  public:
    Pair(Body& a, Body& b, const Rule& rule) : body_{&a, &b}, rule_(rule) {}

    void check_steps(const Proof& proof);
    // Whether one of the 32 formulas has the claim's triangles apart by the rule.
    bool is_separated(const Claim& claim);
    // Whether the closest points of the claim's features are in them, and at a distance of at most (less than) m.
    bool are_features_near(const Claim& claim, bool is_strict);
    bool is_apart_along_coordinate(std::uint32_t c);

  private:
    std::uint32_t triangle(std::size_t side, std::uint32_t number, std::size_t line) const;
    void make_exact();
    Integer m() const { return integer(rule_.m[0], low_ + 1) + integer(rule_.m[1], low_ + 1); }
    Axis make_axis(const AxisLine& source, const std::array<std::uint32_t, 2>& triangles);
    const Vector<Integer>& exact(Axis& axis);
    bool is_apart(const Range<Integer>& a, const Range<Integer>& b, const Vector<Integer>& n) const;
    void measure_parts();
    void sharpen(std::size_t side, std::size_t k, std::uint32_t i);
    const Range<Integer>& exact_range(std::size_t side, std::size_t k, std::uint32_t i);
    bool are_apart(std::uint32_t i, std::uint32_t j);
    void open_parts(const Proof& proof, const Step& step, const std::array<std::uint32_t, 2>& pair);
    void check_step(const Proof& proof, const Step& step);

    std::array<Body*, 2> body_;
    Rule rule_;
    bool is_exact_ = false;
    int low_ = 0;
    std::vector<Axis> axes_;
    std::vector<std::array<std::uint32_t, 2>> stack_;  // pairs of parts to be proven apart, the next one last
    // Of the current step: a's parts and b's, the axes, the ranges.
    std::array<Node, 2> parts_;
    std::optional<Axis> formula_;
    std::vector<Axis*> named_;
    std::array<Ranges, 2> ranges_;
    std::vector<double> excess_;  // by how much the greatest gap of each pair exceeds what it needs
};

}  // namespace certificate_checker
