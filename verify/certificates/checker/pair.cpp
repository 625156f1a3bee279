#include "pair.hpp"

#include <bit>

#include "filter.hpp"

namespace certificate_checker {
namespace {

struct Axis {
    AxisLine source;
    std::array<std::uint32_t, 2> triangles;                                 // parts, of a and of b
    std::optional<Vector<Integer>> n = {};                                  // once asked for, as all below
    std::array<std::unordered_map<std::uint32_t, Integer>, 2> places = {};  // n.x of vertices of a and of b
    Integer least = 0;                                                      // m^2 n.n
};

struct Range {
    const Integer *low = nullptr, *high = nullptr;
};

struct Pair {
    std::array<Body*, 2> body;
    Rule rule;
    Budget& budget;
    std::optional<Filter> filter = {};
    std::vector<Axis> axes = {};
    std::vector<std::array<std::uint32_t, 2>> stack = {};  // pairs of parts to be proven apart, the next one last
    // Of the current step: a's parts and b's, its axes, and the reaches of their parts, as far as they were asked for.
    std::array<Node, 2> parts = {};
    std::span<const std::uint32_t> named = {};
    std::vector<Range> reaches = {};

    void add_axis(const AxisLine& source, const std::array<std::uint32_t, 2>& triangles) {
        axes.push_back({source, triangles});
        if (filter) filter->set_axis(axes.size() - 1, source, triangles);
    }
    const Vector<Integer>& vector(std::size_t number) {
        auto& [source, triangles, n, places, least] = axes[number];
        if (n) return *n;
        std::uint64_t longest = 0;
        const auto corner = [&, &on = triangles](auto side, auto k) -> const Vector<Integer>& {
            const Vector<Integer>& x = body[side]->corner(on[side], k);
            longest = std::max(longest, limbs(x));
            return x;
        };
        n = source.formula.kind == Kind::given ? integers(source.given, unit_of(source.given))
                                               : vector_of<Integer>(source.formula, corner);
        const std::uint64_t both = limbs(*n) + limbs(rule.m);
        budget.spend(128 + 24 * longest * longest + 4 * both * both);
        least = rule.m * rule.m * dot(*n, *n);
        return *n;
    }
    // Takes out of `left` what the filter finds apart.
    void measure_along(std::span<const std::uint32_t> axis_numbers, Pairs& left) {
        named = axis_numbers;
        budget.spend((parts[0].count + 1) * (parts[1].count + 1) * (named.size() + 1));
        reaches.clear();
        if (filter) filter->open(parts, named, left);
    }

    Integer dot_with(const Vector<Integer>& n, std::size_t side, std::uint32_t vertex) {
        const Vector<Integer>& x = body[side]->point(vertex);
        budget.spend(64 + 3 * limbs(n) * limbs(x));
        return dot(n, x);
    }
    // The range of n.x over the corners x of part i of a side. The filter leaves out some that lie surely within it.
    const Range& reach(std::size_t side, std::size_t k, std::uint32_t i) {
        const std::size_t count = parts[0].count + parts[1].count;
        reaches.resize(named.size() * count);
        Range& range = reaches[k * count + side * parts[0].count + i];
        if (range.low != nullptr) return range;
        auto include = [&, &n = vector(named[k]), &places = axes[named[k]].places[side]](std::uint32_t vertex) {
            const auto [found, is_first] = places.try_emplace(vertex);
            const Integer& x = found->second;
            if (is_first) found->second = dot_with(n, side, vertex);
            budget.spend(64 + limbs(x));
            if (range.low == nullptr || x < *range.low) range.low = &x;
            if (range.high == nullptr || x > *range.high) range.high = &x;
        };
        if (!filter) body[side]->mesh.for_corners(parts[side].first + i, include);
        if (filter) std::ranges::for_each(filter->extremes(side, k, i), [&](std::uint32_t v) { include(v); });
        return range;
    }

    bool is_apart(const Range& a, const Range& b, std::uint32_t axis) {
        budget.spend(64 + limbs(*a.high));
        const Vector<Integer>& n = vector(axis);
        if (n == Vector<Integer>{}) return false;
        if (rule.gap == Gap::weak) return *a.high <= *b.low || *b.high <= *a.low;
        if (rule.gap == Gap::half_open) {
            const Integer start = dot_with(n, 1, 0);
            return (*a.high < start && *a.high <= *b.low) || (*a.low > start && *a.low >= *b.high);
        }
        const Integer gap = *a.high < *b.low ? *b.low - *a.high : *a.low - *b.high;
        if (gap <= 0 || rule.gap == Gap::positive) return gap > 0;
        budget.spend(limbs(gap) * limbs(gap));
        const int order = cmp(gap * gap, axes[axis].least);
        return order > 0 || (order == 0 && rule.gap == Gap::at_least);
    }
    // Whether part i of a's and part j of b's are apart along one of the axes of the step.
    bool are_apart(std::uint32_t i, std::uint32_t j) {
        for (std::size_t n = 0, first = filter ? filter->best_axis(i, j) : 0; n < named.size(); ++n) {
            const std::size_t k = (first + n) % named.size();
            if (is_apart(reach(0, k, i), reach(1, k, j), named[k])) return true;
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
        Pairs left;
        for (std::uint32_t i = 0; i < parts[0].count; ++i) left[i] = ~std::uint64_t{0} >> (64 - parts[1].count);
        const auto bottom = static_cast<std::ptrdiff_t>(stack.size());
        for (const std::uint32_t number : std::span(proof.numbers).subspan(step.open.first, step.open.count)) {
            const std::uint32_t i = number / parts[1].count, j = number % parts[1].count;
            if (i >= parts[0].count) throw Refusal{step.line, "no such pair"};
            left[i] &= ~(std::uint64_t{1} << j);
            stack.push_back({parts[0].first + i, parts[1].first + j});
        }
        std::reverse(stack.begin() + bottom, stack.end());
        measure_along(step.is_formula ? std::span(&last, 1) : given, left);
        for (std::uint32_t i = 0; i < parts[0].count; ++i) {
            for (; left[i] != 0; left[i] &= left[i] - 1) {
                const auto j = static_cast<std::uint32_t>(std::countr_zero(left[i]));
                if (are_apart(i, j)) continue;
                throw Refusal{step.line, "pair " + std::to_string(i * parts[1].count + j) + " is not apart"};
            }
        }
    }
};

}  // namespace

void check_steps(Body& a, Body& b, const Rule& rule, const Proof& proof, Budget& budget) {
    Pair pair{{&a, &b}, rule, budget};
    const double m_at_most = rule.m == 0 ? 0 : proof.claim.number;
    if (budget.has_filter) pair.filter.emplace(a.posed, b.posed, m_at_most, proof.axes.size(), budget);
    for (const AxisLine& axis : proof.axes) {
        pair.add_axis(axis, {a.mesh.part(axis.triangles[0], axis.line), b.mesh.part(axis.triangles[1], axis.line)});
        const bool is_zero = axis.given == Vector<double>{} && pair.vector(pair.axes.size() - 1) == Vector<Integer>{};
        if (is_zero) throw Refusal{axis.line, "the axis is zero"};
    }
    pair.axes.reserve(proof.axes.size() + 1);
    pair.stack = {{0, 0}};
    for (const Step& step : proof.steps) pair.check_step(proof, step);
    if (!pair.stack.empty()) throw Refusal{proof.end, "steps are missing"};
}

bool are_separated(Body& a, Body& b, Gap gap, const Claim& claim, Budget& budget) {
    Pair pair{{&a, &b}, {gap}, budget};
    Pairs left = {1};
    const std::uint32_t axis = 0, i = a.mesh.part(claim.triangles[0], claim.line),
                        j = b.mesh.part(claim.triangles[1], claim.line);
    pair.parts = {Node{i}, Node{j}};
    return std::ranges::any_of(separating_formulas(), [&](const Formula& formula) {
        pair.axes.clear();
        pair.add_axis({claim.line, formula}, {i, j});
        pair.measure_along({&axis, 1}, left);
        return pair.are_apart(0, 0);
    });
}

Vector<Span> box_of(Body& body, Budget& budget) {
    Pair pair{{&body, &body}, {}, budget};
    if (budget.has_filter) pair.filter.emplace(body.posed, body.posed, 0, 0, budget);
    const std::array<std::uint32_t, 3> axes = {0, 1, 2};
    for (const std::uint32_t c : axes) pair.add_axis({0, {Kind::c, c, 0}}, {0, 0});
    Pairs none = {};
    pair.measure_along(axes, none);
    Vector<Span> box;
    for (const std::uint32_t k : axes) box[k] = {*pair.reach(0, k, 0).low, *pair.reach(0, k, 0).high};
    return box;
}

}  // namespace certificate_checker
