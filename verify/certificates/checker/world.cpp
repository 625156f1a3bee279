#include <algorithm>
#include <map>
#include <utility>

#include "certificate.hpp"

namespace certificate_checker {
namespace {

BodyId read_id(Text& in) {
    const std::string_view word = in.word();
    const std::size_t dot = word.find('.');
    if (dot == std::string_view::npos) in.fail("not a body");
    const std::string numbers = std::string(word.substr(0, dot)) + ' ' + std::string(word.substr(dot + 1)) + '\n';
    BodyId id;
    try {
        Text fields{numbers};
        fields.require_line();
        id = {fields.count(), fields.count()};
        fields.end_of_line();
    } catch (const Refusal&) {
        in.fail("not a body");
    }
    if (id.slot == 0) in.fail("slot 0 is no body's");
    return id;
}

// Null where the world has no body of this id.
const WorldBody* find_body(const WorldHead& head, BodyId id) {
    const auto place = std::ranges::lower_bound(head.bodies, id, {}, &WorldBody::id);
    return place == head.bodies.end() || place->id != id ? nullptr : &*place;
}

// From the current line.
BodyPair read_pair_line(Text& in) {
    in.word();
    const BodyPair pair{read_id(in), read_id(in)};
    in.end_of_line();
    if (!(pair[0] < pair[1])) in.fail("the lesser body comes first");
    return pair;
}

bool do_agree(const GroupFilter& a, const GroupFilter& b) {
    return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
}

}  // namespace

WorldHead read_world_head(Text& in) {
    WorldHead head;
    in.require_line();
    in.expect("clearance");
    if (in.peek() == "none") {
        in.word();
    } else {
        head.clearance = in.distance();
    }
    in.end_of_line();
    for (in.require_line(); in.peek() == "body"; in.require_line()) {
        in.word();
        WorldBody body;
        body.id = read_id(in);
        // The digest stands between the id and the filter.
        body.mesh.line = in.line_number();
        body.mesh.digest = in.word();
        body.filter.groups = in.bits();
        body.filter.mask = in.bits();
        body.mesh.pose = read_pose(in);
        in.end_of_line();
        if (!head.bodies.empty() && !(head.bodies.back().id < body.id)) in.fail("bodies are not ascending");
        head.bodies.push_back(std::move(body));
    }
    for (; in.peek() == "off"; in.require_line()) {
        const BodyPair pair = read_pair_line(in);
        if (find_body(head, pair[0]) == nullptr || find_body(head, pair[1]) == nullptr) in.fail("no such body");
        if (!head.switched_off.empty() && !(head.switched_off.back() < pair)) in.fail("pairs are not ascending");
        head.switched_off.push_back(pair);
    }
    return head;
}

bool may_meet(const WorldHead& head, const WorldBody& a, const WorldBody& b) {
    const bool is_off = std::ranges::binary_search(head.switched_off, BodyPair{a.id, b.id});
    return do_agree(a.filter, b.filter) && !is_off;
}

// Counts bodies by filter, and compares filters, not bodies. Bits that no filter of the world asks for are left out, so
// that they tell no filters apart.
std::uint64_t count_unjudged(const WorldHead& head, Budget& budget) {
    GroupFilter all;
    for (const auto& [id, filter, mesh] : head.bodies) {
        all.groups |= filter.groups;
        all.mask |= filter.mask;
    }
    std::map<GroupFilter, std::uint64_t> counts;
    for (const auto& [id, filter, mesh] : head.bodies) ++counts[{filter.groups & all.mask, filter.mask & all.groups}];
    const std::vector<std::pair<GroupFilter, std::uint64_t>> kinds(counts.begin(), counts.end());
    std::uint64_t unjudged = 0;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        budget.spend(2 * (kinds.size() - i));
        const auto& [a, a_count] = kinds[i];
        for (std::size_t j = i; j < kinds.size(); ++j) {
            const auto& [b, b_count] = kinds[j];
            if (do_agree(a, b)) continue;
            unjudged += i == j ? a_count * (a_count - 1) / 2 : a_count * b_count;
        }
    }
    // Pairs that filters leave out are counted above, switched off or not.
    for (const auto& [a, b] : head.switched_off) {
        if (do_agree(find_body(head, a)->filter, find_body(head, b)->filter)) ++unjudged;
    }
    return unjudged;
}

bool read_section(Text& in, const WorldHead& head, Section& section) {
    const bool is_first = section.line == 0;
    const bool lacks_within = !is_first && head.clearance && section.proof.claim.question == Question::disjoint;
    if (in.line() == "end world" && !lacks_within) return false;
    if (in.peek() != "pair") in.fail(lacks_within ? "a pair lacks its claim within" : "a pair, or the end, expected");
    section.line = in.line_number();
    const BodyPair pair = read_pair_line(in);
    if (lacks_within && pair != section.pair) in.fail("a pair lacks its claim within");
    if (!lacks_within && !is_first && !(section.pair < pair)) in.fail("pairs are not ascending");
    section.pair = pair;
    section.is_second = lacks_within;
    for (const std::size_t i : {0, 1}) {
        section.bodies[i] = find_body(head, pair[i]);
        if (section.bodies[i] == nullptr) in.fail("no such body");
    }
    if (!may_meet(head, *section.bodies[0], *section.bodies[1])) in.fail("these two are not meant to meet");
    read_proof(in, section.proof);
    const Claim& claim = section.proof.claim;
    const bool has_number = claim.question == Question::within || claim.question == Question::beyond;
    bool is_expected = claim.question == Question::touching || claim.question == Question::crossing ||
                       claim.question == Question::disjoint || claim.question == Question::beyond;
    if (section.is_second) is_expected = claim.question == Question::within;
    if (!is_expected || (has_number && claim.number != head.clearance)) {
        throw Refusal{claim.line, "not a claim that decides this pair"};
    }
    in.require_line();
    return true;
}

}  // namespace certificate_checker
