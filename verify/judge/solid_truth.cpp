#include "judge/solid_truth.hpp"

#include <fmt/format.h>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "judge/text.hpp"

namespace ecods::judge {
namespace {

template <class T>
std::optional<Wrong> compare(const char* question, const T& expected, const T& got) {
    if (expected == got) return std::nullopt;
    return Wrong{question, written(expected), written(got)};
}

}  // namespace

Location to_location(const oracle::PointLocation& exact) {
    if (exact.side != oracle::PointSide::on) return {static_cast<Side>(exact.side), {}};
    return {Side::on, to_feature(exact.feature)};
}

std::optional<Wrong> ask_of_common_points(const Posed<MeshShape>& a, const Posed<MeshShape>& b, Relation relation,
                                          QueryMemory& memory) {
    const bool do_meet = relation != Relation::apart;
    const auto require = [&](const char* question, bool got) -> std::optional<Wrong> {
        if (got == do_meet) return std::nullopt;
        return Wrong{fmt::format("{} of bodies that are {}", question, written(relation)), do_meet ? "yes" : "no",
                     got ? "yes" : "no"};
    };
    const Moving<MeshShape> still_a(*a.what, a.pose, a.pose), still_b(*b.what, b.pose, b.pose);
    PairWitness witness;
    for (const bool has_witness : {false, true, true}) {
        const Ask ask = has_witness ? Ask(memory, witness) : Ask(memory);
        if (auto wrong = require("intersects", ecods::intersects(a, b, ask))) return wrong;
        if (auto wrong = require("distance 0", same_bits(ecods::distance(b, a, ask), 0))) return wrong;
        if (auto wrong = require("within(0)", ecods::within(a, b, 0, ask))) return wrong;
        if (do_meet && !ecods::within(b, a, 0x1p-1074, ask)) return Wrong{"within(2^-1074)", "yes", "no"};
        if (auto wrong = require("cast without a way", ecods::cast(a, Vec3::Zero(), b, 1, ask).has_value()))
            return wrong;
        if (auto wrong = require("cast of bodies that stay", ecods::cast(still_b, still_a, 1, ask).has_value()))
            return wrong;
        const ClosestPoints closest = ecods::closest(a, b, ask), turned = ecods::closest(b, a, ask);
        if (auto wrong = require("closest", closest.kind >= ClosestKind::intersecting)) return wrong;
        if (closest.kind != turned.kind && do_meet) {
            return Wrong{"closest of (b, a)", written(closest.kind), written(turned.kind)};
        }
        const DistanceBounds bounds = ecods::distance_bounds(a, b, {.relative = 0x1p-20}, ask);
        if (bounds.lower > closest.distance || bounds.upper < closest.distance) {
            return Wrong{"distance_bounds", text(closest.distance),
                         fmt::format("{:a}, {:a}", bounds.lower, bounds.upper)};
        }
        if (!do_meet) continue;
        const bool has_triangles = !ecods::intersecting_triangles(a, b, memory).empty();
        if (has_triangles != (closest.kind == ClosestKind::intersecting)) {
            return Wrong{"closest", has_triangles ? "intersecting" : "contained", written(closest.kind)};
        }
    }
    return std::nullopt;
}

Relation mirrored(Relation relation) {
    return relation == Relation::inside     ? Relation::contains
           : relation == Relation::contains ? Relation::inside
                                            : relation;
}

std::string text(const Location& location) {
    return location.side == Side::on ? "on " + text(location.feature) : written(location.side);
}

SolidTruth::SolidTruth(const Posed<Solid>& a, const Posed<Solid>& b, std::span<const Vec3> points) : solids_{a, b} {
    const oracle::Soup soup_a = soup(a), soup_b = soup(b);
    relation_ = oracle::solid_relation(soup_a, soup_b);
    surfaces_[0] = oracle::surface_relation(soup_a, soup_b);
    surfaces_[1] = oracle::surface_relation(soup_b, soup_a);
    for (const Vec3& point : points) add(point);
    add_points_of(a);
    add_points_of(b);
}

void SolidTruth::add(const Vec3& point) {
    if (!point.allFinite()) return;
    points_.push_back(
        {point,
         {to_location(oracle::locate(point, soup(solids_[0]))), to_location(oracle::locate(point, soup(solids_[1])))}});
}

void SolidTruth::add_points_of(const Posed<Solid>& solid) {
    const Mesh& mesh = solid.what->mesh();
    const auto count = mesh.triangles().size();
    for (const std::size_t i : {std::size_t{0}, count / 3}) {
        const Triangle& t = mesh.triangles()[i];
        const Vec3 p = solid.pose.R * mesh.vertices()[t[0]] + solid.pose.t,
                   q = solid.pose.R * mesh.vertices()[t[1]] + solid.pose.t;
        add(p);
        add(0.5 * p + 0.5 * q);
    }
}

SolidTruth SolidTruth::with(const Posed<Solid>& a, const Posed<Solid>& b) const {
    SolidTruth other = *this;
    other.solids_[0] = a;
    other.solids_[1] = b;
    return other;
}

std::size_t SolidTruth::on_count() const {
    std::size_t count = 0;
    for (const Located& each : points_)
        count += (each.expected[0].side == Side::on) + (each.expected[1].side == Side::on);
    return count;
}

std::optional<Wrong> SolidTruth::ask(QueryMemory& memory) const {
    const Posed<Solid>&a = solids_[0], &b = solids_[1];
    const Relation other_way = mirrored(relation_);
    const Posed<MeshShape> surface_a(surface_of(*a.what), a.pose), surface_b(surface_of(*b.what), b.pose);
    if (auto wrong = compare("relation", relation_, ecods::relation(a, b, memory))) return wrong;
    if (auto wrong = compare("relation of (b, a)", other_way, ecods::relation(b, a, memory))) return wrong;
    if (auto wrong = compare("relation, in the thread's memory", relation_, ecods::relation(a, b))) return wrong;
    const auto of_surface = ecods::relation(surface_a, b, memory), of_other = ecods::relation(surface_b, a, memory);
    if (auto wrong = compare("relation of a's surface", surfaces_[0], of_surface)) return wrong;
    if (auto wrong = compare("relation of b's surface", surfaces_[1], of_other)) return wrong;
    const auto turned = mirrored(ecods::relation(a, surface_b, memory));
    if (auto wrong = compare("relation to b's surface", surfaces_[1], turned)) return wrong;
    if (auto wrong = ask_of_common_points(a, b, relation_, memory)) return wrong;
    if (auto wrong = ask_of_common_points(surface_a, b, surfaces_[0], memory)) return wrong;
    if (auto wrong = ask_of_common_points(a, surface_b, surfaces_[1], memory)) return wrong;
    for (const Located& each : points_) {
        for (std::size_t s = 0; s < 2; ++s) {
            const Location got = locate(each.point, solids_[s], memory);
            const auto hit = first_hit(Ray{each.point, Vec3(1, 2, 3)}, solids_[s], memory);
            const bool begins_inside = hit && hit->kind == HitKind::inside;
            if (begins_inside != (each.expected[s].side == Side::inside)) {
                return Wrong{fmt::format("first_hit from {}", text(each.point)), written(each.expected[s].side),
                             begins_inside ? "inside" : "not inside"};
            }
            if (got == each.expected[s]) continue;
            return Wrong{fmt::format("locate {} in {}", text(each.point), s == 0 ? "a" : "b"), text(each.expected[s]),
                         text(got)};
        }
    }
    return std::nullopt;
}

}  // namespace ecods::judge
