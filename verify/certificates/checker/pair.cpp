#include "pair.hpp"

#include <algorithm>
#include <bit>
#include <utility>

#include "formulas.hpp"

namespace certificate_checker {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_odd(double x) {
    return (std::bit_cast<std::uint64_t>(x) & 1) != 0;
}

// Between x > 0 and its lower and upper neighbor. Infinity stands for 2^1024 here; no positive number rounds to 0.
Midpoint lower_midpoint(double x) {
    return x == underflow ? Midpoint{} : Midpoint{x, std::nextafter(x, 0)};
}
Midpoint upper_midpoint(double x) {
    return {x, std::nextafter(x, infinity)};
}

Rule rule_of(const Claim& claim) {
    using Gap = Rule::Gap;
    const double d = claim.number;
    switch (claim.question) {
        case Question::touching:
            return {Gap::weak, {}};
        case Question::distance:
            return {is_odd(d) ? Gap::more_than : Gap::at_least, lower_midpoint(d)};
        case Question::beyond:
            return {Gap::more_than, {d, d}};
        case Question::hit:
            return {is_odd(d) ? Gap::positive : Gap::half_open, {}};
        default:
            return {Gap::positive, {}};
    }
}

// A vector n that parts are measured along: in doubles, scaled to at most 1, and if need be in integers.
struct Axis {
    AxisLine source;
    std::array<std::uint32_t, 2> triangles{};  // parts, of a and of b
    Vector<Approximate> n;
    std::array<Direction, 2> along;  // in a's and in b's coordinates
    double need = 0;                 // a gap in doubles that is greater than this proves that parts are apart
    std::optional<Vector<Integer>> exact;
};

// A range of one part along one axis, as well as it is known.
struct Cell {
    Range range;
    bool is_best = false;  // in doubles
    std::optional<ExactRange> exact;
};

// The parts first, ..., first + count - 1.
using Parts = Node;

class Pair {
  public:
    Pair(Body& a, Body& b, const Rule& rule) : body_{&a, &b}, rule_(rule) {}

    void check_steps(const Proof& proof);
    // Whether one of the 32 formulas has triangles I and J apart.
    bool is_separated(const Claim& claim, const std::array<std::uint32_t, 2>& triangles, const Rule& rule);
    // Whether the closest points of two features are in them, and at a distance of at most (less than) m.
    bool are_features_near(const Claim& claim, const Midpoint& m, bool is_strict);
    bool is_apart_along_coordinate(std::uint32_t c);

  private:
    using Corner = Vector<Integer>;
    std::uint32_t triangle(int side, std::uint32_t number, std::size_t line) const;
    void make_exact();
    Integer in_units(const Midpoint& m) const;
    Axis make_axis(const AxisLine& source, const std::array<std::uint32_t, 2>& triangles);
    const Vector<Integer>& exact(Axis& axis);
    bool is_apart(const Rule& rule, const ExactRange& a, const ExactRange& b, const Vector<Integer>& n) const;
    bool are_apart(std::uint32_t i, std::uint32_t j);
    void check_step(const Proof& proof, const Step& step);
    std::pair<Parts, Parts> opened(const Step& step, const std::array<std::uint32_t, 2>& pair) const;
    Cell& cell(int side, std::size_t axis, std::uint32_t part) {
        return cells_[side][axis * parts_[side].count + part - parts_[side].first];
    }

    std::array<Body*, 2> body_;
    Rule rule_;
    bool is_exact_ = false;
    int low_ = 0;
    std::vector<Axis> axes_;
    std::vector<std::array<std::uint32_t, 2>> stack_;  // pairs of parts to be proven apart, the next one last
    // Of the current step: parts, axes, ranges.
    std::array<Parts, 2> parts_;
    std::vector<Axis*> named_;
    std::array<std::vector<Cell>, 2> cells_;
};

std::uint32_t Pair::triangle(int side, std::uint32_t number, std::size_t line) const {
    const auto part = body_[side]->triangle(number);
    if (!part) throw Refusal{line, "no such triangle"};
    return *part;
}

// All integers of a pair are in the same unit, which makes m one, too.
void Pair::make_exact() {
    if (std::exchange(is_exact_, true)) return;
    low_ = std::min({body_[0]->lowest_bit(), body_[1]->lowest_bit(), low_bit(rule_.m.x) - 1, low_bit(rule_.m.y) - 1});
    for (Body* const body : body_) body->set_unit(low_);
}

Integer Pair::in_units(const Midpoint& m) const {
    return integer(m.x, low_ + 1) + integer(m.y, low_ + 1);
}

const Vector<Integer>& Pair::exact(Axis& axis) {
    make_exact();
    if (axis.exact) return *axis.exact;
    if (axis.source.formula.kind == Kind::given) {
        const auto& g = axis.source.given;
        const int low = std::min({0, low_bit(g[0]), low_bit(g[1]), low_bit(g[2])});
        axis.exact = {{{integer(g[0], low), integer(g[1], low), integer(g[2], low)}}};
    } else {
        axis.exact = vector_of<Integer>(
            axis.source.formula, [&](int side, std::size_t k) { return body_[side]->corner(axis.triangles[side], k); });
    }
    return *axis.exact;
}

Axis Pair::make_axis(const AxisLine& source, const std::array<std::uint32_t, 2>& triangles) {
    Axis axis{source, triangles, {}, {}, 0, {}};
    if (source.formula.kind == Kind::given) {
        for (std::size_t i = 0; i < 3; ++i) axis.n[i].value = source.given[i];
    } else {
        axis.n = vector_of<Approximate>(source.formula, [&](int side, std::size_t k) {
            return body_[side]->approximate_corner(triangles[side], k);
        });
    }
    const auto is_surely_not_zero = [](const Approximate& x) { return std::abs(x.value) > x.error; };
    if (std::none_of(axis.n.begin(), axis.n.end(), is_surely_not_zero) && is_zero(exact(axis))) {
        throw Refusal{source.line, "the axis is zero"};
    }
    const double size = std::max({std::abs(axis.n[0].value), std::abs(axis.n[1].value), std::abs(axis.n[2].value)});
    const int scale = size > 0 && size < infinity ? -std::ilogb(size) - 1 : 0;
    double square = 0;
    for (Approximate& x : axis.n) {
        x = {std::ldexp(x.value, scale), std::ldexp(x.error, scale)};  // what underflows is among `underflows`
        square += (std::abs(x.value) + x.error) * (std::abs(x.value) + x.error);
    }
    for (std::size_t side = 0; side < 2; ++side) axis.along[side] = body_[side]->direction(axis.n);
    axis.need = axis.along[0].error + axis.along[1].error;
    if (rule_.m.x > 0) axis.need += rule_.m.x * std::sqrt(square) * inflation;  // m is at most x
    axis.need *= inflation;
    return axis;
}

bool Pair::is_apart(const Rule& rule, const ExactRange& a, const ExactRange& b, const Vector<Integer>& n) const {
    if (rule.gap == Rule::Gap::weak) return a.high <= b.low || b.high <= a.low;
    if (rule.gap == Rule::Gap::half_open) {
        const Integer start = dot(n, body_[1]->corner(0, 0));
        return (a.high < start && a.high <= b.low) || (a.low > start && a.low >= b.high);
    }
    const Integer gap = a.high < b.low ? b.low - a.high : a.low - b.high;
    if (gap <= 0) return false;
    if (rule.gap == Rule::Gap::positive) return true;
    const Integer m = in_units(rule.m);
    const int order = cmp(gap * gap, m * m * dot(n, n));
    return order > 0 || (order == 0 && rule.gap == Rule::Gap::at_least);
}

// Tries what is cheapest first: ranges of boxes, ranges of corners, integers.
bool Pair::are_apart(std::uint32_t i, std::uint32_t j) {
    const auto is_surely_apart = [&](std::size_t k) {
        const Range &a = cell(0, k, i).range, &b = cell(1, k, j).range;
        return b.low - a.high > named_[k]->need || a.low - b.high > named_[k]->need;
    };
    for (std::size_t k = 0; k < named_.size(); ++k) {
        if (is_surely_apart(k)) return true;
    }
    for (std::size_t k = 0; k < named_.size(); ++k) {
        for (const int side : {0, 1}) {
            const std::uint32_t part = side == 0 ? i : j;
            Cell& c = cell(side, k, part);
            if (!std::exchange(c.is_best, true)) c.range = body_[side]->range(part, named_[k]->along[side]);
        }
        if (is_surely_apart(k)) return true;
    }
    for (std::size_t k = 0; k < named_.size(); ++k) {
        const Vector<Integer>& n = exact(*named_[k]);
        for (const int side : {0, 1}) {
            const std::uint32_t part = side == 0 ? i : j;
            Cell& c = cell(side, k, part);
            if (!c.exact) c.exact = body_[side]->exact_range(part, named_[k]->along[side], n);
        }
        if (is_apart(rule_, *cell(0, k, i).exact, *cell(1, k, j).exact, n)) return true;
    }
    return false;
}

// The parts that the step looks at.
std::pair<Parts, Parts> Pair::opened(const Step& step, const std::array<std::uint32_t, 2>& pair) const {
    const std::array<bool, 2> opens = {step.opens_a, step.opens_b};
    std::array<Parts, 2> parts = {Parts{pair[0], 1}, Parts{pair[1], 1}};
    bool is_progress = !step.opens_a && !step.opens_b;
    for (std::size_t side = 0; side < 2; ++side) {
        const Mesh& mesh = body_[side]->mesh();
        const bool is_triangle = mesh.is_triangle(pair[side]);
        if (step.is_formula && !is_triangle) throw Refusal{step.line, "not two triangles"};
        if (!opens[side] || is_triangle) continue;
        parts[side] = mesh.nodes[pair[side]];
        is_progress = true;
    }
    if (!is_progress) throw Refusal{step.line, "nothing to open"};
    return {parts[0], parts[1]};
}

void Pair::check_step(const Proof& proof, const Step& step) {
    if (stack_.empty()) throw Refusal{step.line, "all is proven already"};
    const auto pair = stack_.back();
    stack_.pop_back();
    std::tie(parts_[0], parts_[1]) = opened(step, pair);
    std::optional<Axis> formula;
    named_.clear();
    if (step.is_formula) {
        formula = make_axis({step.line, step.formula, {}, {}}, pair);
        named_.push_back(&*formula);
    }
    for (std::size_t k = 0; k < step.axes.count; ++k) named_.push_back(&axes_[proof.numbers[step.axes.first + k]]);
    for (const int side : {0, 1}) {
        cells_[side].clear();
        for (const Axis* const axis : named_) {
            for (std::uint32_t k = 0; k < parts_[side].count; ++k) {
                const std::uint32_t part = parts_[side].first + k;
                cells_[side].push_back(
                    {body_[side]->outer_range(part, axis->along[side]), body_[side]->mesh().is_triangle(part), {}});
            }
        }
    }
    const std::uint32_t* open = proof.numbers.data() + step.open.first;
    const std::uint32_t* const open_end = open + step.open.count;
    const std::size_t bottom = stack_.size();
    for (std::uint32_t number = 0; number < parts_[0].count * parts_[1].count; ++number) {
        const std::uint32_t i = parts_[0].first + number / parts_[1].count;
        const std::uint32_t j = parts_[1].first + number % parts_[1].count;
        if (open != open_end && *open == number) {
            stack_.push_back({i, j});
            ++open;
        } else if (!are_apart(i, j)) {
            throw Refusal{step.line, "pair " + std::to_string(number) + " is not apart"};
        }
    }
    if (open != open_end) throw Refusal{step.line, "no such pair"};
    std::reverse(stack_.begin() + static_cast<std::ptrdiff_t>(bottom), stack_.end());
}

void Pair::check_steps(const Proof& proof) {
    for (const AxisLine& line : proof.axes) {
        axes_.push_back(
            make_axis(line, {triangle(0, line.triangles[0], line.line), triangle(1, line.triangles[1], line.line)}));
    }
    stack_ = {{0, 0}};
    for (const Step& step : proof.steps) check_step(proof, step);
    if (!stack_.empty()) throw Refusal{proof.end, "steps are missing"};
}

bool Pair::is_separated(const Claim& claim, const std::array<std::uint32_t, 2>& triangles, const Rule& rule) {
    make_exact();
    const std::array<std::uint32_t, 2> part = {triangle(0, triangles[0], claim.line),
                                               triangle(1, triangles[1], claim.line)};
    const auto corner = [&](int side, std::size_t k) { return body_[side]->corner(part[side], k); };
    return std::any_of(separating_formulas().begin(), separating_formulas().end(), [&](const Formula& formula) {
        const Vector<Integer> n = vector_of<Integer>(formula, corner);
        if (is_zero(n)) return false;
        std::array<ExactRange, 2> range;
        for (const int side : {0, 1}) {
            const Integer x = dot(n, corner(side, 0)), y = dot(n, corner(side, 1)), z = dot(n, corner(side, 2));
            range[side] = {std::min({x, y, z}), std::max({x, y, z})};
        }
        return is_apart(rule, range[0], range[1], n);
    });
}

bool Pair::is_apart_along_coordinate(std::uint32_t c) {
    Axis axis = make_axis({0, {Kind::c, c, 0}, {}, {}}, {0, 0});
    const Vector<Integer>& n = exact(axis);
    return is_apart(rule_, body_[0]->exact_range(0, axis.along[0], n), body_[1]->exact_range(0, axis.along[1], n), n);
}

// With w from a point of the one feature to one of the other, n the vector that the distance is along and d = |w.n| /
// |n|: the closest points are rational, and in the features if signs say so.
bool Pair::are_features_near(const Claim& claim, const Midpoint& m, bool is_strict) {
    make_exact();
    const std::array<Feature, 2>& named = *claim.features;
    const int first = named[0].kind == 'v' || named[1].kind != 'v' ? 0 : 1;  // a vertex, if there is one, comes first
    const Feature &f = named[first], &g = named[1 - first];
    const auto corner = [&](int side, const Feature& x, std::size_t k) -> const Vector<Integer>& {
        return body_[side]->corner(triangle(side, x.triangle, claim.line), k % 3);
    };
    const Vector<Integer>&p = corner(first, f, f.k), &q = corner(1 - first, g, g.k);
    const Vector<Integer> w = p - q;
    const auto is_within = [](const Integer& x, const Integer& end) { return x >= 0 && x <= end; };
    // Squared distance as a fraction.
    Integer numerator = dot(w, w), denominator = 1;
    if (g.kind == 'e' && f.kind == 'v') {
        const Vector<Integer> e = corner(1 - first, g, g.k + 1) - q, n = cross(e, w);
        denominator = dot(e, e);
        if (denominator == 0 || !is_within(dot(w, e), denominator)) return false;
        numerator = dot(n, n);
    } else if (g.kind == 'f') {
        const Vector<Integer> n = cross(corner(1 - first, g, 1) - q, corner(1 - first, g, 2) - q);
        denominator = dot(n, n);
        for (std::size_t k = 0; k < 3; ++k) {
            const Vector<Integer>& start = corner(1 - first, g, k);
            const Vector<Integer> e = corner(1 - first, g, k + 1) - start;
            if (denominator == 0 || dot(n, cross(e, p - start)) < 0) return false;
        }
        numerator = dot(n, w) * dot(n, w);
    } else if (f.kind == 'e') {
        const Vector<Integer> d = corner(first, f, f.k + 1) - p, e = corner(1 - first, g, g.k + 1) - q, n = cross(d, e);
        denominator = dot(n, n);
        // p + s d and q + t e are closest: s = det(e, w, n) / n.n, t = det(d, w, n) / n.n.
        if (denominator == 0 || !is_within(dot(cross(e, w), n), denominator)) return false;
        if (!is_within(dot(cross(d, w), n), denominator)) return false;
        numerator = dot(n, w) * dot(n, w);
    }
    if (m.x == infinity && m.y == infinity) return true;  // within infinity
    const Integer bound = in_units(m);
    const int order = cmp(numerator, bound * bound * denominator);
    return order < 0 || (order == 0 && !is_strict);
}

void require(bool is_true, const Claim& claim, const char* why) {
    if (!is_true) throw Refusal{claim.line, why};
}

}  // namespace

void check_pair(Body& a, Body& b, const Proof& proof) {
    const Claim& claim = proof.claim;
    const bool is_distance = claim.question == Question::distance;
    require(claim.question != Question::hit && claim.question != Question::miss, claim, "this claim needs a segment");
    const bool is_finite = claim.number < infinity;
    if (claim.features) {
        const Midpoint m = is_distance ? upper_midpoint(claim.number) : Midpoint{claim.number, claim.number};
        Pair upper(a, b, {Rule::Gap::positive, m});
        require(upper.are_features_near(claim, m, is_distance && is_odd(claim.number)), claim,
                "the features' closest points are not in them, or too far from each other");
    } else if (claim.question == Question::touching || claim.question == Question::crossing ||
               claim.question == Question::within || (is_distance && is_finite)) {
        const bool is_crossing = claim.question == Question::crossing;
        Pair upper(a, b, {});
        require(!upper.is_separated(claim, claim.triangles, {is_crossing ? Rule::Gap::weak : Rule::Gap::positive, {}}),
                claim, is_crossing ? "these two do not cross" : "these two do not meet");
    }
    if (claim.has_steps) Pair(a, b, rule_of(claim)).check_steps(proof);
}

void check_segment(Body& a, const std::array<std::array<double, 3>, 2>& segment, const Vector<double>& origin,
                   const Proof& proof, Budget& budget) {
    const Claim& claim = proof.claim;
    const double s = claim.number;
    Piece piece{segment[0], segment[1], {{{0, 0}, {1, 1}}}};
    require(claim.question == Question::hit || claim.question == Question::miss, claim, "this claim needs two meshes");
    if (claim.question == Question::hit) {
        const Midpoint low = s > 0 ? lower_midpoint(s) : Midpoint{}, high = upper_midpoint(s);
        piece.s[0] = {low.x, low.y};
        if (s == 0) piece.s[1] = {0, 0};
        if (s > 0 && s < 1) piece.s[1] = {high.x, high.y};
        Body last(piece, origin, budget);
        const Rule rule{is_odd(s) ? Rule::Gap::half_open : Rule::Gap::positive, {}};
        require(!Pair(a, last, {}).is_separated(claim, {claim.triangles[0], 0}, rule), claim,
                "the triangle is not met there");
        piece.s = {{{0, 0}, {low.x, low.y}}};
    }
    Body first(piece, origin, budget);
    if (claim.has_steps) Pair(a, first, rule_of(claim)).check_steps(proof);
}

bool are_boxes_apart(Body& a, Body& b, const std::optional<double>& clearance) {
    const Rule rule = clearance ? Rule{Rule::Gap::more_than, {*clearance, *clearance}} : Rule{};
    Pair pair(a, b, rule);
    return pair.is_apart_along_coordinate(0) || pair.is_apart_along_coordinate(1) || pair.is_apart_along_coordinate(2);
}

}  // namespace certificate_checker
