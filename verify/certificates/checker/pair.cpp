#include "pair.hpp"

#include <bit>
#include <utility>

#include "formulas.hpp"

namespace certificate_checker {
namespace {

// Half the sum of two doubles. Infinity stands for 2^1024.
using Midpoint = std::array<double, 2>;

bool is_odd(double x) {
    return (std::bit_cast<std::uint64_t>(x) & 1) != 0;
}
// No positive number rounds to 0.
Midpoint lower_midpoint(double x) {
    return x <= underflow ? Midpoint{} : Midpoint{x, std::nextafter(x, 0)};
}
Midpoint upper_midpoint(double x) {
    return {x, std::nextafter(x, infinity)};
}

// When two parts are apart along a vector. The last two: the gap beside the distance m.
enum class Gap : std::uint8_t { positive, weak, half_open, at_least, more_than };
struct Rule {
    Gap gap = Gap::positive;
    Midpoint m{};
};
Rule rule_of(const Claim& claim) {
    const double d = claim.number;
    switch (claim.question) {
        case Question::touching:
            return {Gap::weak};
        case Question::distance:
            return {is_odd(d) ? Gap::more_than : Gap::at_least, lower_midpoint(d)};
        case Question::beyond:
            return {Gap::more_than, {d, d}};
        case Question::hit:
            return {is_odd(d) ? Gap::positive : Gap::half_open};
        default:
            return {};
    }
}

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

// README.md, section 3: the squared distance as a fraction, if signs say that the closest points are in the features.
bool Pair::are_features_near(const Claim& claim, bool is_strict) {
    make_exact();
    const std::array<Feature, 2>& named = *claim.features;
    const std::size_t first = named[0].kind == 'v' || named[1].kind != 'v' ? 0 : 1;  // a vertex comes first
    const Feature &f = named[first], &g = named[1 - first];
    const std::uint32_t i = triangle(first, f.triangle, claim.line), j = triangle(1 - first, g.triangle, claim.line);
    const auto of_f = [&](std::size_t k) { return body_[first]->corner(i, k); };
    const auto of_g = [&](std::size_t k) { return body_[1 - first]->corner(j, k); };
    const auto is_within = [](const Integer& x, const Integer& end) { return x >= 0 && x <= end; };
    const Vector<Integer> p = of_f(f.k), q = of_g(g.k), w = p - q, e = of_g(g.k + 1) - q;
    Vector<Integer> n = w;
    Integer denominator = 1;
    bool is_in = true;
    if (f.kind == 'v' && g.kind == 'e') {
        n = cross(e, w);
        denominator = dot(e, e);
        is_in = is_within(dot(w, e), denominator);
    } else if (g.kind == 'f') {
        n = cross(e, of_g(2) - q);
        denominator = dot(n, n);
        for (std::size_t k = 0; k < 3; ++k) is_in = is_in && dot(n, cross(of_g(k + 1) - of_g(k), p - of_g(k))) >= 0;
    } else if (f.kind == 'e') {
        const Vector<Integer> d = of_f(f.k + 1) - p;
        n = cross(d, e);
        denominator = dot(n, n);
        is_in = is_within(dot(cross(e, w), n), denominator) && is_within(dot(cross(d, w), n), denominator);
    }
    if (!is_in || denominator == 0) return false;
    const bool is_along_n = g.kind == 'f' || f.kind == 'e';
    const Integer numerator = is_along_n ? Integer(dot(n, w) * dot(n, w)) : dot(n, n);
    const int order = cmp(numerator, m() * m() * denominator);
    return order < 0 || (order == 0 && !is_strict);
}

// The segment's piece between two parameters, as a mesh of the triangle (from', p', p').
Mesh piece_of(const std::array<Vector<double>, 2>& segment, const std::array<Midpoint, 2>& parameters) {
    Mesh mesh;
    const int low_s = std::min(lowest_bit(parameters[0]), lowest_bit(parameters[1]));
    const int low_x = std::min(lowest_bit(segment[0]), lowest_bit(segment[1]));
    for (const Midpoint& half : parameters) {
        const Integer s = integer(half[0], low_s) + integer(half[1], low_s), rest = integer(2, low_s) - s;
        auto& exact = mesh.exact.emplace_back();
        auto& vertex = mesh.vertices.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            exact[k] = rest * integer(segment[0][k], low_x) + s * integer(segment[1][k], low_x);
            long exponent = 0;
            const double leading = mpz_get_d_2exp(&exponent, exact[k].get_mpz_t());  // wrong by at most 2u of itself
            vertex[k] = std::ldexp(leading, static_cast<int>(exponent) + low_s + low_x - 1);
        }
    }
    mesh.triangles = {{0, 1, 1}};
    mesh.position = {0};
    measure(mesh);
    mesh.low = low_s + low_x - 1;
    return mesh;
}

void require(bool is_true, const Claim& claim, const char* why) {
    if (!is_true) throw Refusal{claim.line, why};
}

}  // namespace

void check_pair(Body& a, Body& b, const Proof& proof) {
    const Claim& claim = proof.claim;
    const double d = claim.number;
    const bool is_distance = claim.question == Question::distance;
    require(claim.question != Question::hit && claim.question != Question::miss, claim, "this claim needs a segment");
    if (claim.features) {
        Pair upper(a, b, {Gap::positive, is_distance ? upper_midpoint(d) : Midpoint{d, d}});
        const bool is_near = upper.are_features_near(claim, is_distance && is_odd(d));
        require(is_near || (d == infinity && !is_distance), claim, "the features do not prove this distance");
    } else if (claim.question == Question::crossing) {
        require(!Pair(a, b, {Gap::weak}).is_separated(claim), claim, "these two do not cross");
    } else if (claim.question == Question::touching || claim.question == Question::within || (is_distance && d == 0)) {
        require(!Pair(a, b, {}).is_separated(claim), claim, "these two do not meet");
    }
    if (claim.has_steps) Pair(a, b, rule_of(claim)).check_steps(proof);
}

void check_segment(Body& a, const std::array<Vector<double>, 2>& segment, const Proof& proof, Budget& budget) {
    const Claim& claim = proof.claim;
    const double s = claim.number;
    const bool is_hit = claim.question == Question::hit;
    require(is_hit || claim.question == Question::miss, claim, "this claim needs two meshes");
    const Pose unmoved{{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}};
    const Midpoint low = lower_midpoint(s);
    if (is_hit) {
        const Midpoint high = s == 0 ? Midpoint{} : s < 1 ? upper_midpoint(s) : Midpoint{1, 1};
        const Mesh piece = piece_of(segment, {low, high});
        Body last(piece, unmoved, a.origin(), budget);
        Pair upper(a, last, {is_odd(s) ? Gap::half_open : Gap::positive});
        require(!upper.is_separated(claim), claim, "the triangle is not met there");
    }
    const Mesh piece = piece_of(segment, {Midpoint{}, is_hit ? low : Midpoint{1, 1}});
    Body first(piece, unmoved, a.origin(), budget);
    if (claim.has_steps) Pair(a, first, rule_of(claim)).check_steps(proof);
}

bool are_boxes_apart(Body& a, Body& b, const std::optional<double>& clearance) {
    Pair pair(a, b, clearance ? Rule{Gap::more_than, {*clearance, *clearance}} : Rule{});
    return pair.is_apart_along_coordinate(0) || pair.is_apart_along_coordinate(1) || pair.is_apart_along_coordinate(2);
}

}  // namespace certificate_checker
