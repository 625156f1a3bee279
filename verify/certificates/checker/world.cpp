#include "world.hpp"

#include <algorithm>

namespace certificate_checker {
namespace {

class World {
  public:
    World(Text& in, const FindMesh& find_mesh, Budget& budget);
    void check_section();     // from its line `pair`
    void require_the_rest();  // every pair without a section is apart by its boxes, or may not meet
    std::string words() const;

  private:
    struct Boxed {
        const WorldBody* body;
        const Mesh* mesh;
        Vector<double> low, high;  // at least the box, and the clearance at the upper end
    };
    const Boxed& find(BodyId id) const;
    bool may_meet(const WorldBody& a, const WorldBody& b) const;
    void finish_pair() const;
    template <class Check>
    auto with_bodies(const Boxed& a, const Boxed& b, const Check& check) const;

    Text& in_;
    Budget& budget_;
    WorldHead head_;
    std::vector<Boxed> boxed_;  // as the bodies
    std::vector<BodyPair> decided_;
    std::size_t pair_line_ = 0;
    std::optional<Question> last_;  // of the last pair; the first of two
    bool is_whole_ = true;          // the last pair needs no more sections
    Proof proof_;
    std::size_t colliding_ = 0;
    std::size_t close_ = 0;
};

World::World(Text& in, const FindMesh& find_mesh, Budget& budget)
    : in_(in), budget_(budget), head_(read_world_head(in)) {
    const double clearance = head_.clearance.value_or(0);
    for (const WorldBody& each : head_.bodies) {
        Boxed boxed{&each, &find_mesh(each.mesh), {}, {}};
        const Body body(*boxed.mesh, each.mesh.pose, {}, budget);
        for (std::size_t k = 0; k < 3; ++k) {
            Vector<Approximate> axis{};
            axis[k].value = 1;
            const Direction d = body.direction(axis);
            const Range range = body.range(0, d);
            const bool is_bounded = d.error < std::numeric_limits<double>::infinity();
            boxed.low[k] = is_bounded ? range.low - d.error : -std::numeric_limits<double>::infinity();
            boxed.high[k] = is_bounded ? range.high + d.error + clearance * inflation : d.error;
        }
        boxed_.push_back(boxed);
    }
}

const World::Boxed& World::find(BodyId id) const {
    const auto place = std::lower_bound(boxed_.begin(), boxed_.end(), id,
                                        [](const Boxed& each, BodyId wanted) { return each.body->id < wanted; });
    if (place == boxed_.end() || place->body->id != id) in_.fail("no such body");
    return *place;
}

bool World::may_meet(const WorldBody& a, const WorldBody& b) const {
    const BodyPair pair = {std::min(a.id, b.id), std::max(a.id, b.id)};
    return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0 &&
           !std::binary_search(head_.switched_off.begin(), head_.switched_off.end(), pair);
}

template <class Check>
auto World::with_bodies(const Boxed& a, const Boxed& b, const Check& check) const {
    const Pose &pose_a = a.body->mesh.pose, &pose_b = b.body->mesh.pose;
    Body body_a(*a.mesh, pose_a, pose_a.t, budget_), body_b(*b.mesh, pose_b, pose_a.t, budget_);
    return check(body_a, body_b);
}

void World::finish_pair() const {
    if (!is_whole_) in_.fail("the pair of line " + std::to_string(pair_line_) + " lacks a claim within");
}

void World::check_section() {
    const BodyPair pair = read_pair_line(in_);
    pair_line_ = in_.line_number();
    const bool is_second = !is_whole_ && pair == decided_.back();
    if (!is_second) {
        finish_pair();
        if (!decided_.empty() && !(decided_.back() < pair)) in_.fail("pairs are not ascending");
    }
    const Boxed &a = find(pair[0]), &b = find(pair[1]);
    if (!may_meet(*a.body, *b.body)) in_.fail("these two are not meant to meet");
    read_proof(in_, proof_);
    const Claim& claim = proof_.claim;
    const Question question = claim.question;
    const bool is_contact = question == Question::touching || question == Question::crossing;
    const bool has_number = question == Question::within || question == Question::beyond;
    const bool is_expected =
        is_second ? question == Question::within
                  : is_contact || question == Question::disjoint || (question == Question::beyond && head_.clearance);
    if (!is_expected || (has_number && claim.number != head_.clearance)) {
        throw Refusal{claim.line, "not a claim that decides this pair"};
    }
    with_bodies(a, b, [&](Body& x, Body& y) { check_pair(x, y, proof_); });
    is_whole_ = is_second || question != Question::disjoint || !head_.clearance;
    colliding_ += is_contact ? 1 : 0;
    close_ += is_contact || is_second ? 1 : 0;
    if (!is_second) decided_.push_back(pair);
}

void World::require_the_rest() {
    finish_pair();
    std::vector<const Boxed*> sorted;
    for (const Boxed& each : boxed_) sorted.push_back(&each);
    std::sort(sorted.begin(), sorted.end(), [](const Boxed* x, const Boxed* y) { return x->low[0] < y->low[0]; });
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        for (std::size_t j = i + 1; j < sorted.size() && sorted[j]->low[0] <= sorted[i]->high[0]; ++j) {
            budget_.spend(2);
            const Boxed *a = sorted[i], *b = sorted[j];
            const bool is_apart =
                a->low[1] > b->high[1] || b->low[1] > a->high[1] || a->low[2] > b->high[2] || b->low[2] > a->high[2];
            if (is_apart || !may_meet(*a->body, *b->body)) continue;
            if (b->body->id < a->body->id) std::swap(a, b);
            if (std::binary_search(decided_.begin(), decided_.end(), BodyPair{a->body->id, b->body->id})) continue;
            if (with_bodies(*a, *b, [&](Body& x, Body& y) { return are_boxes_apart(x, y, head_.clearance); })) continue;
            in_.fail("bodies " + std::to_string(a->body->id.slot) + '.' + std::to_string(a->body->id.generation) +
                     " and " + std::to_string(b->body->id.slot) + '.' + std::to_string(b->body->id.generation) +
                     " are not decided");
        }
    }
}

std::string World::words() const {
    std::string words =
        "world of " + std::to_string(boxed_.size()) + " bodies, " + std::to_string(colliding_) + " colliding";
    if (head_.clearance) words += ", " + std::to_string(close_) + " close";
    return words;
}

}  // namespace

std::string check_world(Text& in, const FindMesh& find_mesh, Budget& budget) {
    World world(in, find_mesh, budget);
    for (; in.peek() == "pair"; in.require_line()) world.check_section();
    if (in.line() != "end world") in.fail("a pair, or the end, expected");
    world.require_the_rest();
    return world.words();
}

}  // namespace certificate_checker
