#include "world.hpp"

namespace certificate_checker {
namespace {

// A body, and doubles that its box is within. The upper end is moved by the clearance.
struct Boxed {
    const WorldBody* body;
    const Mesh* mesh;
    Vector<double> low{}, high{};
};

struct World {
    Budget& budget;
    WorldHead head;
    std::vector<Boxed> bodies;  // as they are listed
    std::vector<BodyPair> decided;
    std::size_t colliding = 0, close = 0;

    bool may_meet(const WorldBody& a, const WorldBody& b) const {
        const bool is_off =
            std::binary_search(head.switched_off.begin(), head.switched_off.end(), BodyPair{a.id, b.id});
        return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0 && !is_off;
    }
    template <class Check>
    auto with_bodies(const Boxed& a, const Boxed& b, const Check& check) const {
        const Pose &pose_a = a.body->mesh.pose, &pose_b = b.body->mesh.pose;
        Body x(*a.mesh, pose_a, pose_a.t, budget), y(*b.mesh, pose_b, pose_a.t, budget);
        return check(x, y);
    }
    Boxed boxed(const WorldBody& each, const Mesh& mesh) const;
    const Boxed& find(const Text& in, BodyId id) const;
    void check_sections(Text& in);
    void require_the_rest(const Text& in) const;
};

Boxed World::boxed(const WorldBody& each, const Mesh& mesh) const {
    Boxed box{&each, &mesh};
    const Body body(mesh, each.mesh.pose, {}, budget);
    for (std::size_t k = 0; k < 3; ++k) {
        Vector<Approximate> axis{};
        axis[k].value = 1;
        const Direction d = body.direction(axis);
        const Range<double> range = d.error < infinity ? body.range(0, d) : Range<double>{0, 0};
        box.low[k] = range.low - d.error;
        box.high[k] = range.high + d.error + head.clearance.value_or(0) * inflation;
    }
    return box;
}

const Boxed& World::find(const Text& in, BodyId id) const {
    const auto is_less = [](const Boxed& each, BodyId wanted) { return each.body->id < wanted; };
    const auto place = std::lower_bound(bodies.begin(), bodies.end(), id, is_less);
    if (place == bodies.end() || place->body->id != id) in.fail("no such body");
    return *place;
}

void World::check_sections(Text& in) {
    Proof proof;
    for (bool lacks_within = false; in.peek() == "pair" || lacks_within; in.require_line()) {
        const BodyPair pair = read_pair_line(in);
        if (lacks_within ? pair != decided.back() : !decided.empty() && !(decided.back() < pair)) {
            in.fail(lacks_within ? "a pair lacks its claim within" : "pairs are not ascending");
        }
        const Boxed &a = find(in, pair[0]), &b = find(in, pair[1]);
        if (!may_meet(*a.body, *b.body)) in.fail("these two are not meant to meet");
        read_proof(in, proof);
        const Question question = proof.claim.question;
        const bool is_contact = question == Question::touching || question == Question::crossing;
        const bool is_far = question == Question::beyond && head.clearance;
        const bool is_expected =
            lacks_within ? question == Question::within : is_contact || question == Question::disjoint || is_far;
        const bool has_number = question == Question::within || question == Question::beyond;
        if (!is_expected || (has_number && proof.claim.number != head.clearance)) {
            throw Refusal{proof.claim.line, "not a claim that decides this pair"};
        }
        with_bodies(a, b, [&](Body& x, Body& y) { check_pair(x, y, proof); });
        if (!lacks_within) decided.push_back(pair);
        colliding += is_contact ? 1 : 0;
        close += is_contact || lacks_within ? 1 : 0;
        lacks_within = head.clearance && question == Question::disjoint;
    }
    if (in.line() != "end world") in.fail("a pair, or the end, expected");
}

// Every pair without a section is apart by its boxes, or may not meet.
void World::require_the_rest(const Text& in) const {
    std::vector<const Boxed*> sorted;
    for (const Boxed& each : bodies) sorted.push_back(&each);
    std::sort(sorted.begin(), sorted.end(), [](const Boxed* x, const Boxed* y) { return x->low[0] < y->low[0]; });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        for (std::size_t j = i + 1; j < sorted.size() && sorted[j]->low[0] <= sorted[i]->high[0]; ++j) {
            budget.spend(2);
            const Boxed& a = **std::min(&sorted[i], &sorted[j], [](auto x, auto y) { return (*x)->body < (*y)->body; });
            const Boxed& b = &a == sorted[i] ? *sorted[j] : *sorted[i];
            const bool is_apart =
                a.low[1] > b.high[1] || b.low[1] > a.high[1] || a.low[2] > b.high[2] || b.low[2] > a.high[2];
            if (is_apart || !may_meet(*a.body, *b.body)) continue;
            if (std::binary_search(decided.begin(), decided.end(), BodyPair{a.body->id, b.body->id})) continue;
            if (with_bodies(a, b, [&](Body& x, Body& y) { return are_boxes_apart(x, y, head.clearance); })) continue;
            in.fail("not decided: bodies of slots " + std::to_string(a.body->id.slot) + ", " +
                    std::to_string(b.body->id.slot));
        }
    }
}

}  // namespace

std::string check_world(Text& in, const FindMesh& find_mesh, Budget& budget) {
    World world{budget, read_world_head(in), {}, {}};
    for (const WorldBody& body : world.head.bodies) world.bodies.push_back(world.boxed(body, find_mesh(body.mesh)));
    world.check_sections(in);
    world.require_the_rest(in);
    std::string words = "world of " + std::to_string(world.bodies.size()) + " bodies, ";
    words += std::to_string(world.colliding) + " colliding";
    return world.head.clearance ? words + ", " + std::to_string(world.close) + " close" : words;
}

}  // namespace certificate_checker
