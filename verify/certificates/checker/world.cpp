#include "claims.hpp"
#include "pair.hpp"

namespace certificate_checker {
namespace {

bool may_meet(const WorldHead& head, const WorldBody& a, const WorldBody& b) {
    const bool is_off = std::binary_search(head.switched_off.begin(), head.switched_off.end(), BodyPair{a.id, b.id});
    return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0 && !is_off;
}

// The boxes of all bodies in one unit, by their lower ends along x. The clearance is added to what `reach` are the
// upper ends of.
struct Boxed {
    const WorldBody* body;
    Vector<Integer> low, reach;
};
std::vector<Boxed> sorted_boxes(const WorldHead& head, Budget& budget) {
    const std::array<double, 1> clearance = {head.clearance.value_or(0)};
    int unit = unit_of(clearance);
    for (const WorldBody& each : head.bodies) unit = std::min(unit, unit_of(each.mesh));
    std::vector<Boxed> boxes;
    for (const WorldBody& each : head.bodies) {
        Body body(each.mesh, unit);
        const Vector<Range> box = box_of(body, budget);
        boxes.push_back({&each, {}, {}});
        for (std::size_t k = 0; k < 3; ++k) {
            boxes.back().low[k] = box[k].low;
            boxes.back().reach[k] = box[k].high + integer(clearance[0], unit);
        }
    }
    std::sort(boxes.begin(), boxes.end(), [](const Boxed& x, const Boxed& y) { return x.low[0] < y.low[0]; });
    return boxes;
}

// Every pair without a section is apart by its boxes, or may not meet.
void require_the_rest(const Text& in, const WorldHead& head, const std::vector<BodyPair>& decided, Budget& budget) {
    const std::vector<Boxed> boxes = sorted_boxes(head, budget);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        for (std::size_t j = i + 1; j < boxes.size() && boxes[j].low[0] <= boxes[i].reach[0]; ++j) {
            budget.spend(2);
            const Boxed &x = boxes[i], &y = boxes[j];
            const auto [a, b] = std::minmax(x.body, y.body);  // as they are listed
            const bool is_apart =
                x.low[1] > y.reach[1] || y.low[1] > x.reach[1] || x.low[2] > y.reach[2] || y.low[2] > x.reach[2];
            if (is_apart || !may_meet(head, *a, *b)) continue;
            if (std::binary_search(decided.begin(), decided.end(), BodyPair{a->id, b->id})) continue;
            in.fail("not decided: bodies of slots " + std::to_string(a->id.slot) + ", " + std::to_string(b->id.slot));
        }
    }
}

}  // namespace

std::string check_world(Text& in, const WorldHead& head, Budget& budget) {
    std::vector<BodyPair> decided;
    std::size_t colliding = 0, close = 0;
    for (Section section; read_section(in, head, section);) {
        const WorldBody &a = *section.bodies[0], &b = *section.bodies[1];
        if (!may_meet(head, a, b)) throw Refusal{section.line, "these two are not meant to meet"};
        const Claim& claim = section.proof.claim;
        const bool is_contact = claim.question == Question::touching || claim.question == Question::crossing;
        const bool has_number = claim.question == Question::within || claim.question == Question::beyond;
        bool is_expected = is_contact || claim.question == Question::disjoint || claim.question == Question::beyond;
        if (section.is_second) is_expected = claim.question == Question::within;
        if (!is_expected || (has_number && claim.number != head.clearance)) {
            throw Refusal{claim.line, "not a claim that decides this pair"};
        }
        check_pair(a.mesh, b.mesh, section.proof, budget);
        if (!section.is_second) decided.push_back(section.pair);
        colliding += is_contact ? 1 : 0;
        close += is_contact || section.is_second ? 1 : 0;
    }
    require_the_rest(in, head, decided, budget);
    const std::string words =
        "world of " + std::to_string(head.bodies.size()) + " bodies, " + std::to_string(colliding) + " colliding";
    return head.clearance ? words + ", " + std::to_string(close) + " close" : words;
}

}  // namespace certificate_checker
