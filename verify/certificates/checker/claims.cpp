#include "claims.hpp"

#include <bit>

#include "pair.hpp"

namespace certificate_checker {

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

namespace {

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
