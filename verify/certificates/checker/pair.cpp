#include "pair.hpp"

#include <utility>

#include "formulas.hpp"

namespace certificate_checker {

std::uint32_t Pair::triangle(std::size_t side, std::uint32_t number, std::size_t line) const {
    const Mesh& mesh = body_[side]->mesh();
    if (number >= mesh.position.size()) throw Refusal{line, "no such triangle"};
    return static_cast<std::uint32_t>(mesh.nodes.size()) + mesh.position[number];
}

// All integers of a pair are in the same unit, which makes m one, too.
void Pair::make_exact() {
    if (std::exchange(is_exact_, true)) return;
    low_ = std::min({body_[0]->lowest(), body_[1]->lowest(), lowest_bit(rule_.m) - 1});
    for (Body* const body : body_) body->set_unit(low_);
}

const Vector<Integer>& Pair::exact(Axis& axis) {
    make_exact();
    if (axis.exact) return *axis.exact;
    const auto& g = axis.source.given;
    const int low = lowest_bit(g);
    axis.exact = {{{integer(g[0], low), integer(g[1], low), integer(g[2], low)}}};
    if (axis.source.formula.kind == Kind::given) return *axis.exact;
    axis.exact = vector_of<Integer>(axis.source.formula, [&](std::size_t side, std::size_t k) {
        return body_[side]->corner(axis.triangles[side], k);
    });
    return *axis.exact;
}

Axis Pair::make_axis(const AxisLine& source, const std::array<std::uint32_t, 2>& triangles) {
    Axis axis{source, triangles, {}, {}, 0, {}};
    for (std::size_t i = 0; i < 3; ++i) axis.n[i].value = source.given[i];
    if (source.formula.kind != Kind::given) {
        axis.n = vector_of<Approximate>(source.formula, [&](std::size_t side, std::size_t k) {
            return body_[side]->approximate_corner(triangles[side], k);
        });
    }
    const auto is_surely_not_zero = [](const Approximate& x) { return std::abs(x.value) > x.error; };
    if (std::none_of(axis.n.begin(), axis.n.end(), is_surely_not_zero) && is_zero(exact(axis))) {
        throw Refusal{source.line, "the axis is zero"};
    }
    const double size = std::max({std::abs(axis.n[0].value), std::abs(axis.n[1].value), std::abs(axis.n[2].value)});
    // What this underflows is covered by the 2^-400 of directions.
    const double scale =
        size > 0 && size < infinity ? std::ldexp(1, std::clamp(-std::ilogb(size) - 1, -1000, 1000)) : 1;
    double square = 0;
    for (Approximate& x : axis.n) {
        x = {x.value * scale, x.error * scale};
        square += (std::abs(x.value) + x.error) * (std::abs(x.value) + x.error);
    }
    for (std::size_t side = 0; side < 2; ++side) axis.along[side] = body_[side]->direction(axis.n);
    // m is at most the first of its two doubles.
    const double beside = rule_.m[0] > 0 ? rule_.m[0] * std::sqrt(square) * inflation : 0;
    axis.need = (axis.along[0].error + axis.along[1].error + beside) * inflation;
    return axis;
}

bool Pair::is_apart(const Range<Integer>& a, const Range<Integer>& b, const Vector<Integer>& n) const {
    if (rule_.gap == Gap::weak) return a.high <= b.low || b.high <= a.low;
    if (rule_.gap == Gap::half_open) {
        const Integer start = dot(n, body_[1]->point(0));
        return (a.high < start && a.high <= b.low) || (a.low > start && a.low >= b.high);
    }
    const Integer gap = a.high < b.low ? b.low - a.high : a.low - b.high;
    if (gap <= 0 || rule_.gap == Gap::positive) return gap > 0;
    const int order = cmp(gap * gap, m() * m() * dot(n, n));
    return order > 0 || (order == 0 && rule_.gap == Gap::at_least);
}

// Sets the ranges by boxes, of triangles by corners. NaN is never the greatest.
void Pair::measure_parts() {
    body_[0]->budget().spend((parts_[0].count + 1) * (parts_[1].count + 1) * (named_.size() + 1));
    for (const std::size_t side : {0, 1}) {
        Ranges& ranges = ranges_[side];
        ranges.exact.clear();
        for (auto* const ends : {&ranges.low, &ranges.high}) ends->resize(named_.size() * parts_[side].count);
        ranges.is_best.assign(ranges.low.size(), 0);
        for (std::size_t k = 0, at = 0; k < named_.size(); ++k) {
            for (std::uint32_t i = 0; i < parts_[side].count; ++i, ++at) {
                const std::uint32_t part = parts_[side].first + i;
                if (body_[side]->mesh().is_triangle(part)) {
                    sharpen(side, k, i);
                } else {
                    const Range<double> range = body_[side]->box_range(part, named_[k]->along[side]);
                    ranges.low[at] = range.low;
                    ranges.high[at] = range.high;
                }
            }
        }
    }
    excess_.assign(std::size_t{parts_[0].count} * parts_[1].count, -infinity);
    const Ranges &a = ranges_[0], &b = ranges_[1];
    for (std::size_t k = 0; k < named_.size(); ++k) {
        const double need = named_[k]->need;
        const double *const low = &b.low[k * parts_[1].count], *const high = &b.high[k * parts_[1].count];
        for (std::uint32_t i = 0; i < parts_[0].count; ++i) {
            const double a_low = a.low[k * parts_[0].count + i], a_high = a.high[k * parts_[0].count + i];
            double* const excess = &excess_[std::size_t{i} * parts_[1].count];
            for (std::uint32_t j = 0; j < parts_[1].count; ++j) {
                excess[j] = std::max(excess[j], std::max(low[j] - a_high, a_low - high[j]) - need);
            }
        }
    }
}

void Pair::sharpen(std::size_t side, std::size_t k, std::uint32_t i) {
    Ranges& ranges = ranges_[side];
    const std::size_t at = k * parts_[side].count + i;
    if (std::exchange(ranges.is_best[at], 1) != 0) return;
    const Range<double> range = body_[side]->range(parts_[side].first + i, named_[k]->along[side]);
    ranges.low[at] = range.low;
    ranges.high[at] = range.high;
}

const Range<Integer>& Pair::exact_range(std::size_t side, std::size_t k, std::uint32_t i) {
    const Vector<Integer>& n = exact(*named_[k]);
    ranges_[side].exact.resize(ranges_[side].low.size());
    auto& range = ranges_[side].exact[k * parts_[side].count + i];
    if (!range) range = body_[side]->exact_range(parts_[side].first + i, named_[k]->along[side], n);
    return *range;
}

// Whether parts i and j are apart along one of the axes of the step, though the ranges so far do not say so. Better
// ranges in doubles are asked first, then integers.
bool Pair::are_apart(std::uint32_t i, std::uint32_t j) {
    const Ranges &a = ranges_[0], &b = ranges_[1];
    for (std::size_t k = 0; k < named_.size(); ++k) {
        sharpen(0, k, i);
        sharpen(1, k, j);
        const std::size_t at = k * parts_[0].count + i, other = k * parts_[1].count + j;
        const double need = named_[k]->need;
        if (b.low[other] - a.high[at] > need || a.low[at] - b.high[other] > need) return true;
    }
    for (std::size_t k = 0; k < named_.size(); ++k) {
        body_[0]->budget().spend(64);
        const Range<Integer>&x = exact_range(0, k, i), &y = exact_range(1, k, j);
        if (is_apart(x, y, exact(*named_[k]))) return true;
    }
    return false;
}

// Sets what the step looks at.
void Pair::open_parts(const Proof& proof, const Step& step, const std::array<std::uint32_t, 2>& pair) {
    bool is_progress = !step.opens[0] && !step.opens[1];
    for (const std::size_t side : {0, 1}) {
        const bool is_triangle = body_[side]->mesh().is_triangle(pair[side]);
        if (step.is_formula && !is_triangle) throw Refusal{step.line, "not two triangles"};
        const bool is_opened = step.opens[side] && !is_triangle;
        parts_[side] = is_opened ? body_[side]->mesh().nodes[pair[side]] : Node{pair[side], 1, 0, 0};
        is_progress = is_progress || is_opened;
    }
    if (!is_progress) throw Refusal{step.line, "nothing to open"};
    named_.clear();
    if (step.is_formula) named_.push_back(&formula_.emplace(make_axis({step.line, step.formula, {}, {}}, pair)));
    for (std::size_t k = 0; k < step.axes.count; ++k) named_.push_back(&axes_[proof.numbers[step.axes.first + k]]);
    measure_parts();
}

void Pair::check_step(const Proof& proof, const Step& step) {
    if (stack_.empty()) throw Refusal{step.line, "all is proven already"};
    const auto pair = stack_.back();
    stack_.pop_back();
    open_parts(proof, step, pair);
    const std::uint32_t* open = proof.numbers.data() + step.open.first;
    const std::uint32_t* const open_end = open + step.open.count;
    const auto bottom = static_cast<std::ptrdiff_t>(stack_.size());
    for (std::uint32_t number = 0; number < parts_[0].count * parts_[1].count; ++number) {
        const std::uint32_t i = number / parts_[1].count, j = number % parts_[1].count;
        if (open != open_end && *open == number) {
            stack_.push_back({parts_[0].first + i, parts_[1].first + j});
            ++open;
        } else if (!(excess_[number] > 0) && !are_apart(i, j)) {
            throw Refusal{step.line, "pair " + std::to_string(number) + " is not apart"};
        }
    }
    if (open != open_end) throw Refusal{step.line, "no such pair"};
    std::reverse(stack_.begin() + bottom, stack_.end());
}

void Pair::check_steps(const Proof& proof) {
    for (const AxisLine& axis : proof.axes) {
        const std::uint32_t i = triangle(0, axis.triangles[0], axis.line),
                            j = triangle(1, axis.triangles[1], axis.line);
        axes_.push_back(make_axis(axis, {i, j}));
    }
    stack_ = {{0, 0}};
    for (const Step& step : proof.steps) check_step(proof, step);
    if (!stack_.empty()) throw Refusal{proof.end, "steps are missing"};
}

bool Pair::is_separated(const Claim& claim) {
    make_exact();
    const std::array<std::uint32_t, 2> part = {triangle(0, claim.triangles[0], claim.line),
                                               triangle(1, claim.triangles[1], claim.line)};
    const auto corner = [&](std::size_t side, std::size_t k) { return body_[side]->corner(part[side], k); };
    const auto range = [&](std::size_t side, const Vector<Integer>& n) -> Range<Integer> {
        const Integer x = dot(n, corner(side, 0)), y = dot(n, corner(side, 1)), z = dot(n, corner(side, 2));
        return {std::min({x, y, z}), std::max({x, y, z})};
    };
    return std::any_of(separating_formulas().begin(), separating_formulas().end(), [&](const Formula& formula) {
        const Vector<Integer> n = vector_of<Integer>(formula, corner);
        return !is_zero(n) && is_apart(range(0, n), range(1, n), n);
    });
}

bool Pair::is_apart_along_coordinate(std::uint32_t c) {
    Axis axis = make_axis({0, {Kind::c, c, 0}, {}, {}}, {0, 0});
    const Vector<Integer>& n = exact(axis);
    return is_apart(body_[0]->exact_range(0, axis.along[0], n), body_[1]->exact_range(0, axis.along[1], n), n);
}

}  // namespace certificate_checker
