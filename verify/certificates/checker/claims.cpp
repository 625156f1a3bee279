#include "claims.hpp"

#include <bit>

#include "pair.hpp"

namespace certificate_checker {
namespace {

// Half the sum of two doubles, a multiple of 2^unit. Infinity stands for 2^1024.
using Midpoint = std::array<double, 2>;
Integer half_sum(const Midpoint& x, int unit) {
    return integer(x[0], unit + 1) + integer(x[1], unit + 1);
}

// What rounds to a double: from the lower to the upper midpoint, and whether it is odd. No positive number rounds to 0.
std::tuple<Midpoint, Midpoint, bool> rounding_to(double x) {
    const double below = std::nextafter(x, 0), above = x == 0 ? 0 : std::nextafter(x, infinity);
    return {below == 0 ? Midpoint{} : Midpoint{x, below}, {x, above}, (std::bit_cast<std::uint64_t>(x) & 1) != 0};
}

// README.md, section 3: whether signs say that the closest points are in the features, and whether their squared
// distance, (n.w)^2 / n.n, is at most (less than) m^2. Within infinity any distance is.
bool are_features_near(const std::array<Body*, 2>& body, const Claim& claim, const Integer& m, bool is_strict) {
    const std::array<Feature, 2>& named = *claim.features;
    const std::size_t first = named[0].kind == 'v' || named[1].kind != 'v' ? 0 : 1;  // a vertex comes first
    const Feature &f = named[first], &g = named[1 - first];
    const std::uint32_t i = body[first]->mesh.part(f.triangle, claim.line),
                        j = body[1 - first]->mesh.part(g.triangle, claim.line);
    const auto of_f = [&](std::size_t k) { return body[first]->corner(i, k); };
    const auto of_g = [&](std::size_t k) { return body[1 - first]->corner(j, k); };
    const auto is_within = [](const Integer& x, const Integer& end) { return x >= 0 && x <= end && end > 0; };
    std::uint64_t longest = limbs(m);
    for (const std::size_t k : {0, 1, 2}) longest = std::max({longest, limbs(of_f(k)), limbs(of_g(k))});
    body[0]->budget.spend(128 * (1 + longest * longest));
    const Vector<Integer> p = of_f(f.k), q = of_g(g.k), w = p - q, e = of_g(g.k + 1) - q;
    Vector<Integer> n = w;  // the difference of the closest points is along n
    bool is_in = true;
    if (f.kind == 'e') {
        const Vector<Integer> d = of_f(f.k + 1) - p;
        n = cross(d, e);
        is_in = is_within(dot(cross(e, w), n), dot(n, n)) && is_within(dot(cross(d, w), n), dot(n, n));
    } else if (g.kind == 'e') {
        n = dot(e, e) * w - dot(w, e) * e;
        is_in = is_within(dot(w, e), dot(e, e));
    } else if (g.kind == 'f') {
        n = cross(e, of_g(2) - q);
        is_in = n != Vector<Integer>{};
        for (std::size_t k = 0; k < 3; ++k) is_in = is_in && dot(n, cross(of_g(k + 1) - of_g(k), p - of_g(k))) >= 0;
    }
    if (!is_in || claim.number == infinity) return is_in;
    const int order = cmp(dot(n, w) * dot(n, w), m * m * dot(n, n));
    return order < 0 || (order == 0 && !is_strict);
}

void require(bool is_true, const Claim& claim, const char* why) {
    if (!is_true) throw Refusal{claim.line, why};
}

// The piece between two points, as a mesh of the triangle from', p', p'.
struct Piece {
    Piece(const Vector<Integer>& from, const Vector<Integer>& to, int unit, Budget& budget)
        : mesh(mesh_of({from, to}, unit)), body(posed, unit, budget) {
        body.points = {{0, from}, {1, to}};
    }
    Mesh mesh;
    PosedMesh posed{{}, {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, {}}, 0, &mesh};
    Body body;
};

// A body and its box, in a unit that all bodies share; the clearance is added to the upper ends.
struct Boxed {
    const WorldBody* body;
    Vector<Span> box;
};
// Every pair without a section is apart by its boxes, or may not meet.
void require_the_rest(const Text& in, const WorldHead& head, const std::vector<BodyPair>& decided, Budget& budget) {
    const double clearance = head.clearance.value_or(0);
    int unit = unit_of(std::array{clearance});
    for (const WorldBody& each : head.bodies) unit = std::min(unit, unit_of(each.mesh));
    std::vector<Boxed> boxes;
    for (const WorldBody& each : head.bodies) {
        Body body(each.mesh, unit, budget);
        boxes.push_back({&each, box_of(body, budget)});
        for (Span& range : boxes.back().box) range.high += integer(clearance, unit);
    }
    std::ranges::sort(boxes, [](const Boxed& x, const Boxed& y) { return x.box[0].low < y.box[0].low; });
    const auto is_below = [](const Boxed& x, const Boxed& y, std::size_t k) { return x.box[k].high < y.box[k].low; };
    for (auto x = boxes.begin(); x != boxes.end(); ++x) {
        for (auto y = x + 1; y != boxes.end() && !is_below(*x, *y, 0); ++y) {
            budget.spend(32);
            const auto [a, b] = std::minmax(x->body, y->body);  // as they are listed
            const bool is_apart =
                is_below(*x, *y, 1) || is_below(*y, *x, 1) || is_below(*x, *y, 2) || is_below(*y, *x, 2);
            if (is_apart || !may_meet(head, *a, *b)) continue;
            if (std::ranges::binary_search(decided, BodyPair{a->id, b->id})) continue;
            in.fail("not decided: bodies of slots " + std::to_string(a->id.slot) + ", " + std::to_string(b->id.slot));
        }
    }
}

}  // namespace

void check_pair(const PosedMesh& a, const PosedMesh& b, const Proof& proof, Budget& budget) {
    const Claim& claim = proof.claim;
    const Question question = claim.question;
    const double d = claim.number;
    const bool is_distance = question == Question::distance;
    const auto [lower, upper, is_odd] = rounding_to(d);
    const int unit = std::min({unit_of(a), unit_of(b), unit_of(lower) - 1, unit_of(upper) - 1});
    Body x(a, unit, budget), y(b, unit, budget);
    require(question != Question::hit && question != Question::miss, claim, "this claim needs a segment");
    if (claim.features) {
        const Integer most = is_distance ? half_sum(upper, unit) : integer(d, unit);
        const bool is_near = are_features_near({&x, &y}, claim, most, is_distance && is_odd);
        require(is_near, claim, "the features do not prove this distance");
    } else if (question != Question::disjoint && question != Question::beyond && (!is_distance || d == 0)) {
        const bool is_crossing = question == Question::crossing;
        const bool is_separated = are_separated(x, y, is_crossing ? Gap::weak : Gap::positive, claim, budget);
        require(!is_separated, claim, is_crossing ? "these two do not cross" : "these two do not meet");
    }
    Rule rule;
    if (question == Question::touching) rule = {Gap::weak};
    if (question == Question::beyond) rule = {Gap::more_than, integer(d, unit)};
    if (is_distance) rule = {is_odd ? Gap::more_than : Gap::at_least, half_sum(lower, unit)};
    if (claim.has_steps) check_steps(x, y, rule, proof, budget);
}

void check_segment(const PosedMesh& a, const Segment& segment, const Proof& proof, Budget& budget) {
    const Claim& claim = proof.claim;
    const bool is_hit = claim.question == Question::hit;
    require(is_hit || claim.question == Question::miss, claim, "this claim needs two meshes");
    const auto [lower, upper, is_odd] = rounding_to(claim.number);
    const Midpoint one = {1, 1}, last = claim.number < 1 ? upper : one;
    const int unit_x = std::min(unit_of(segment[0]), unit_of(segment[1]));
    const int unit_s = std::min({unit_of(lower), unit_of(upper), unit_of(one), unit_of(a) - unit_x + 1}) - 1;
    const int unit = unit_x + unit_s;
    const auto at = [&](const Midpoint& parameter) {
        const Vector<Integer> from = integers(segment[0], unit_x), to = integers(segment[1], unit_x);
        return integer(1, unit_s) * from - half_sum(parameter, unit_s) * (from - to);
    };
    Body x(a, unit, budget);
    Piece first(at({}), at(is_hit ? lower : one), unit, budget), second(at(lower), at(last), unit, budget);
    const Gap before = is_hit && !is_odd ? Gap::half_open : Gap::positive,
              gap = is_odd ? Gap::half_open : Gap::positive;
    require(!is_hit || !are_separated(x, second.body, gap, claim, budget), claim, "the triangle is not met there");
    if (claim.has_steps) check_steps(x, first.body, {before}, proof, budget);
}

WorldCounts check_world(Text& in, const WorldHead& head, Budget& budget) {
    std::vector<BodyPair> decided;
    WorldCounts counts;
    for (Section section; read_section(in, head, section);) {
        check_pair(section.bodies[0]->mesh, section.bodies[1]->mesh, section.proof, budget);
        const Question question = section.proof.claim.question;
        const bool is_contact = question == Question::touching || question == Question::crossing;
        if (!section.is_second) decided.push_back(section.pair);
        counts.colliding += is_contact ? 1 : 0;
        counts.close += is_contact || question == Question::within ? 1 : 0;
    }
    require_the_rest(in, head, decided, budget);
    counts.unjudged = count_unjudged(head, budget);
    return counts;
}

}  // namespace certificate_checker
