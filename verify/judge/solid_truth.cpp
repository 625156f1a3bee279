#include "judge/solid_truth.hpp"

#include <fmt/format.h>

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
    if (auto wrong = compare("solid_relation", relation_, solid_relation(a, b, memory))) return wrong;
    if (auto wrong = compare("solid_relation of (b, a)", other_way, solid_relation(b, a, memory))) return wrong;
    if (auto wrong = compare("solid_relation, in the thread's memory", relation_, solid_relation(a, b))) return wrong;
    if (auto wrong = compare("surface_relation", surfaces_[0], ecods::surface_relation(a, b, memory))) return wrong;
    if (auto wrong = compare("surface_relation of (b, a)", surfaces_[1], ecods::surface_relation(b, a, memory))) {
        return wrong;
    }
    for (const Located& each : points_) {
        for (std::size_t s = 0; s < 2; ++s) {
            const Location got = locate(each.point, solids_[s], memory);
            if (got == each.expected[s]) continue;
            return Wrong{fmt::format("locate {} in {}", text(each.point), s == 0 ? "a" : "b"), text(each.expected[s]),
                         text(got)};
        }
    }
    return std::nullopt;
}

}  // namespace ecods::judge
