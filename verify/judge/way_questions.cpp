#include "judge/way_questions.hpp"

#include <fmt/format.h>

#include <string>

#include "judge/cast_truth.hpp"
#include "judge/text.hpp"

namespace ecods::judge {
namespace {

std::array<double, 4> numbers(const Quaternion& q) {
    return {q.w, q.x, q.y, q.z};
}

oracle::NamedFeature named(const Feature& feature) {
    return {static_cast<int>(feature.kind), feature.triangle, feature.corner};
}

std::string text(const Vec3& point, const std::optional<Vec3>& normal) {
    return judge::text(point) + (normal ? " along " + judge::text(*normal) : " along nothing");
}

std::optional<Wrong> compare(const ContactPoint& got, const oracle::PlaceOfContact& expected) {
    const bool have_normals = got.normal && expected.normal;
    const bool is_right = same_bits(got.point, expected.point) &&
                          got.normal.has_value() == expected.normal.has_value() &&
                          (!have_normals || same_bits(*got.normal, *expected.normal));
    if (is_right) return std::nullopt;
    return Wrong{"contact_point", text(expected.point, expected.normal), text(got.point, got.normal)};
}

bool is_after_start(const FirstContact& contact) {
    return contact.kind <= ClosestKind::edge_edge;
}

std::string text(const std::optional<WayContact>& met) {
    if (!met) return "nothing";
    return fmt::format("leg {}, ", met->leg) + judge::text(std::optional(met->contact));
}

}  // namespace

oracle::WaySoup way_soup(const Way<MeshShape>& a) {
    oracle::WaySoup way{soup<MeshShape>({*a.what, a.pose}), {}, {}};
    for (const WayNode& node : a.nodes) {
        way.quaternions.push_back(numbers(node.q));
        way.pivots.push_back(node.pivot);
    }
    return way;
}

std::optional<Wrong> ask_about_way(const Way<MeshShape>& a, const Posed<MeshShape>& b, const Ask& ask) {
    const oracle::WaySoup way = way_soup(a);
    const auto exact = oracle::first_contact(way, soup(b));
    std::optional<WayContact> expected;
    if (exact) expected = WayContact{exact->leg, *to_first_contact(exact->contact)};
    const auto met = cast(a, b, ask);
    const bool is_right =
        met.has_value() == expected.has_value() &&
        (!met || (met->leg == expected->leg && is_same(std::optional(met->contact), std::optional(expected->contact))));
    if (!is_right) return Wrong{"cast along a way", text(expected), text(met)};
    if (!met || !is_after_start(met->contact)) return std::nullopt;
    return compare(contact_point(a, b, *met, ask),
                   oracle::place_of_contact(way.leg(met->leg), soup(b), named(met->contact.a), named(met->contact.b)));
}

std::optional<Wrong> ask_about_turn_as_way(const Turning<MeshShape>& a, const WayNode& between,
                                           const Posed<MeshShape>& b, const Ask& ask) {
    const WayNode first{{}, a.turn.pivot_from}, last{a.turn.q, a.turn.pivot_to};
    const Way<MeshShape> direct(*a.what, a.pose, {first, last});
    if (auto wrong = ask_about_way(direct, b, ask)) return wrong;
    const auto turned = cast(a, b, 1, ask);
    const auto met = cast(direct, b, ask);
    const auto of_way = met ? std::optional(met->contact) : std::nullopt;
    if (!is_same(turned, of_way)) return Wrong{"cast of a turn", judge::text(of_way), judge::text(turned)};
    if (turned && contact_point(a, b, *turned, ask) != contact_point(direct, b, *met, ask)) {
        return Wrong{"contact_point of a turn", "that of the way", "another one"};
    }
    const Way<MeshShape> around(*a.what, a.pose, {first, between, last, between});
    return ask_about_way(around, b, ask);
}

std::optional<Wrong> ask_about_point(const Moving<MeshShape>& a, const Moving<MeshShape>& b, const Ask& ask) {
    const auto contact = cast(a, b, 1, ask);
    if (!contact || !is_after_start(*contact)) return std::nullopt;
    const oracle::MovingSoup of_a{soup<MeshShape>({*a.what, a.from}), a.to},
        of_b{soup<MeshShape>({*b.what, b.from}), b.to};
    return compare(contact_point(a, b, *contact, ask),
                   oracle::place_of_contact(of_a, of_b, named(contact->a), named(contact->b)));
}

std::optional<Wrong> ask_about_settling(const Turning<MeshShape>& a, const Pose& to, const Posed<MeshShape>& b,
                                        const Ask& ask) {
    const oracle::LegSoup leg{soup<MeshShape>({*a.what, a.pose}),
                              a.turn.pivot_from,
                              numbers(Quaternion()),
                              numbers(a.turn.q),
                              a.turn.pivot_from,
                              a.turn.pivot_to};
    const auto expected = to_first_contact(oracle::settling_contact(leg, to, soup(b)));
    const auto got = settle(a, to, b, ask);
    if (is_same(got, expected)) return std::nullopt;
    return Wrong{"settle", judge::text(expected), judge::text(got)};
}

}  // namespace ecods::judge
