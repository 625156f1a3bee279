#include "pair.hpp"

#include <map>

#include "filter.hpp"

namespace certificate_checker {
namespace {

struct Axis {
    AxisLine source;
    std::array<std::uint32_t, 2> triangles;  // parts, of a and of b
    std::optional<Vector<Integer>> n;        // once asked for
};

struct Pair {
    std::array<Body*, 2> body;
    Rule rule;
    Budget& budget;
    std::optional<Filter> filter = {};
    std::vector<Axis> axes = {};
    std::vector<std::array<std::uint32_t, 2>> stack = {};  // pairs of parts to be proven apart, the next one last
    // Of the current step: a's parts and b's, its axes, and the reaches of {side, axis, part} that were asked for.
    std::array<Node, 2> parts = {};
    std::span<const std::uint32_t> named = {};
    std::map<std::array<std::size_t, 3>, Range> reaches = {};

    void add_axis(const AxisLine& source, const std::array<std::uint32_t, 2>& triangles) {
        axes.push_back({source, triangles, {}});
        if (filter) filter->set_axis(axes.size() - 1, source, triangles);
    }
    const Vector<Integer>& vector(std::size_t number) {
        auto& [source, triangles, n] = axes[number];
        if (n) return *n;
        const auto corner = [&, &on = triangles](auto side, auto k) { return body[side]->corner(on[side], k); };
        const auto given = [&, &x = source.given](std::size_t k) { return integer(x[k], unit_of(x)); };
        n = source.formula.kind == Kind::given ? Vector<Integer>{given(0), given(1), given(2)}
                                               : vector_of<Integer>(source.formula, corner);
        return *n;
    }
    void measure_along(std::span<const std::uint32_t> axis_numbers) {
        named = axis_numbers;
        budget.spend((parts[0].count + 1) * (parts[1].count + 1) * (named.size() + 1));
        reaches.clear();
        if (filter) filter->open(parts, named);
    }

    // The range of n.x over the corners x of part i of a side. The filter leaves out some that lie surely within it.
    const Range& reach(std::size_t side, std::size_t k, std::uint32_t i) {
        const auto [place, is_new] = reaches.try_emplace({side, k, i});
        if (!is_new) return place->second;
        Range& range = place->second;
        auto include = [&, &n = vector(named[k]), is_first = true](std::uint32_t vertex) mutable {
            const Integer x = dot(n, body[side]->point(vertex));
            budget.spend(64 + mpz_size(x.get_mpz_t()) * mpz_size(x.get_mpz_t()));
            if (std::exchange(is_first, false)) range = {x, x};
            if (x < range.low) range.low = x;
            if (x > range.high) range.high = x;
        };
        if (!filter) body[side]->mesh.for_corners(parts[side].first + i, include);
        if (filter) std::ranges::for_each(filter->extremes(side, k, i), [&](std::uint32_t v) { include(v); });
        return range;
    }

    bool is_apart(const Range& a, const Range& b, const Vector<Integer>& n) {
        if (n == Vector<Integer>{}) return false;
        if (rule.gap == Gap::weak) return a.high <= b.low || b.high <= a.low;
        if (rule.gap == Gap::half_open) {
            const Integer start = dot(n, body[1]->point(0));
            return (a.high < start && a.high <= b.low) || (a.low > start && a.low >= b.high);
        }
        const Integer gap = a.high < b.low ? b.low - a.high : a.low - b.high;
        if (gap <= 0 || rule.gap == Gap::positive) return gap > 0;
        const int order = cmp(gap * gap, rule.m * rule.m * dot(n, n));
        return order > 0 || (order == 0 && rule.gap == Gap::at_least);
    }
    // Whether part i of a's and part j of b's are apart along one of the axes of the step.
    bool are_apart(std::uint32_t i, std::uint32_t j) {
        if (filter && filter->are_apart(i, j)) return true;
        for (std::size_t k = 0; k < named.size(); ++k) {
            budget.spend(64);
            if (is_apart(reach(0, k, i), reach(1, k, j), vector(named[k]))) return true;
        }
        return false;
    }

    void check_step(const Proof& proof, const Step& step) {
        if (stack.empty()) throw Refusal{step.line, "all is proven already"};
        const auto pair = stack.back();
        stack.pop_back();
        bool is_progress = !step.opens[0] && !step.opens[1];
        for (const std::size_t side : {0, 1}) {
            const bool is_node = !body[side]->mesh.is_triangle(pair[side]);
            if (step.is_formula && is_node) throw Refusal{step.line, "not two triangles"};
            parts[side] = step.opens[side] && is_node ? body[side]->mesh.nodes[pair[side]] : Node{pair[side]};
            is_progress = is_progress || (step.opens[side] && is_node);
        }
        if (!is_progress) throw Refusal{step.line, "nothing to open"};
        axes.resize(proof.axes.size());
        if (step.is_formula) add_axis({step.line, step.formula}, pair);
        const auto last = static_cast<std::uint32_t>(axes.size() - 1);
        const auto given = std::span(proof.numbers).subspan(step.axes.first, step.axes.count);
        measure_along(step.is_formula ? std::span(&last, 1) : given);
        auto left_open = std::span(proof.numbers).subspan(step.open.first, step.open.count);
        const auto bottom = static_cast<std::ptrdiff_t>(stack.size());
        for (std::uint32_t number = 0; number < parts[0].count * parts[1].count; ++number) {
            const std::uint32_t i = number / parts[1].count, j = number % parts[1].count;
            if (!left_open.empty() && left_open[0] == number) {
                stack.push_back({parts[0].first + i, parts[1].first + j});
                left_open = left_open.subspan(1);
            } else if (!are_apart(i, j)) {
                throw Refusal{step.line, "pair " + std::to_string(number) + " is not apart"};
            }
        }
        if (!left_open.empty()) throw Refusal{step.line, "no such pair"};
        std::reverse(stack.begin() + bottom, stack.end());
    }
};

}  // namespace

void check_steps(Body& a, Body& b, const Rule& rule, const Proof& proof, Budget& budget) {
    Pair pair{{&a, &b}, rule, budget};
    const double m_at_most = rule.m == 0 ? 0 : proof.claim.number;
    if (budget.has_filter) pair.filter.emplace(a.posed, b.posed, m_at_most, budget);
    for (const AxisLine& axis : proof.axes) {
        pair.add_axis(axis, {a.mesh.part(axis.triangles[0], axis.line), b.mesh.part(axis.triangles[1], axis.line)});
        const bool is_zero = axis.given == Vector<double>{} && pair.vector(pair.axes.size() - 1) == Vector<Integer>{};
        if (is_zero) throw Refusal{axis.line, "the axis is zero"};
    }
    pair.stack = {{0, 0}};
    for (const Step& step : proof.steps) pair.check_step(proof, step);
    if (!pair.stack.empty()) throw Refusal{proof.end, "steps are missing"};
}

bool are_separated(Body& a, Body& b, Gap gap, const Claim& claim, Budget& budget) {
    Pair pair{{&a, &b}, {gap}, budget};
    const std::uint32_t axis = 0, i = a.mesh.part(claim.triangles[0], claim.line),
                        j = b.mesh.part(claim.triangles[1], claim.line);
    pair.parts = {Node{i}, Node{j}};
    return std::ranges::any_of(separating_formulas(), [&](const Formula& formula) {
        pair.axes.clear();
        pair.add_axis({claim.line, formula}, {i, j});
        pair.measure_along({&axis, 1});
        return pair.are_apart(0, 0);
    });
}

Vector<Range> box_of(Body& body, Budget& budget) {
    Pair pair{{&body, &body}, {}, budget};
    if (budget.has_filter) pair.filter.emplace(body.posed, body.posed, 0, budget);
    const std::array<std::uint32_t, 3> axes = {0, 1, 2};
    for (const std::uint32_t c : axes) pair.add_axis({0, {Kind::c, c, 0}}, {0, 0});
    pair.measure_along(axes);
    return {pair.reach(0, 0, 0), pair.reach(0, 1, 0), pair.reach(0, 2, 0)};
}

}  // namespace certificate_checker
