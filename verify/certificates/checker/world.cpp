#include "claims.hpp"
#include "pair.hpp"

namespace certificate_checker {
namespace {

// A body and its box, in a unit that all bodies share; the clearance is added to the upper ends.
struct Boxed {
    const WorldBody* body;
    Vector<Range> box;
};
// Every pair without a section is apart by its boxes, or may not meet.
void require_the_rest(const Text& in, const WorldHead& head, const std::vector<BodyPair>& decided, Budget& budget) {
    const double clearance = head.clearance.value_or(0);
    int unit = unit_of(std::array{clearance});
    for (const WorldBody& each : head.bodies) unit = std::min(unit, unit_of(each.mesh));
    std::vector<Boxed> boxes;
    for (const WorldBody& each : head.bodies) {
        Body body(each.mesh, unit);
        boxes.push_back({&each, box_of(body, budget)});
        for (Range& range : boxes.back().box) range.high += integer(clearance, unit);
    }
    std::ranges::sort(boxes, [](const Boxed& x, const Boxed& y) { return x.box[0].low < y.box[0].low; });
    const auto is_below = [](const Boxed& x, const Boxed& y, std::size_t k) { return x.box[k].high < y.box[k].low; };
    for (auto x = boxes.begin(); x != boxes.end(); ++x) {
        for (auto y = x + 1; y != boxes.end() && !is_below(*x, *y, 0); ++y) {
            budget.spend(2);
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
    return counts;
}

}  // namespace certificate_checker
