#include "programs/clash/verdict.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "ecods/distance.hpp"

namespace ecods::clash {
namespace {

// Of zero-area triangles a solid has nothing, but a part has them.
std::optional<Verdict> judge_apart(const Part& a, const Part& b, QueryMemory& memory) {
    if (!intersects(surface_of(a), surface_of(b), memory)) return std::nullopt;
    return Verdict{Kind::touching, "touching"};
}

std::optional<Verdict> judge_solids(const Part& a, const Part& b, bool can_be_deep, QueryMemory& memory) {
    if (!can_be_deep) return judge_apart(a, b, memory);
    switch (solid_relation(solid_of(a), solid_of(b), memory)) {
        case Relation::apart:
            return judge_apart(a, b, memory);
        case Relation::touching:
            return Verdict{Kind::touching, "touching"};
        case Relation::overlapping:
            return Verdict{Kind::overlapping, "overlapping"};
        case Relation::inside:
            return Verdict{Kind::inside, "inside"};
        case Relation::contains:
            return Verdict{Kind::inside, "contains"};
        case Relation::equal:
            return Verdict{Kind::equal, "equal"};
        case Relation::crossing:  // of surfaces alone
            break;
    }
    return std::nullopt;
}

// `is_first`: whether the surface is the first of the pair.
std::optional<Verdict> judge_surface(const Part& surface, const Part& solid, bool is_first, QueryMemory& memory) {
    switch (surface_relation(surface_of(surface), solid_of(solid), memory)) {
        case Relation::apart:
            return judge_apart(surface, solid, memory);
        case Relation::touching:
            return Verdict{Kind::touching, "touching"};
        case Relation::inside:
            return Verdict{Kind::inside, is_first ? "inside" : "contains"};
        case Relation::crossing:
            return Verdict{Kind::crossing, "partly_inside"};
        case Relation::overlapping:  // of two solids alone, as the rest
        case Relation::contains:
        case Relation::equal:
            break;
    }
    return std::nullopt;
}

using Corners = std::array<std::array<double, 3>, 3>;

std::vector<Corners> sorted_triangles(const Mesh& mesh) {
    std::vector<Corners> all;
    all.reserve(mesh.triangles().size());
    for (const Triangle& triangle : mesh.triangles()) {
        Corners corners;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& v = mesh.vertices()[triangle[i]];
            corners[i] = {v[0], v[1], v[2]};
        }
        std::sort(corners.begin(), corners.end());
        all.push_back(corners);
    }
    std::sort(all.begin(), all.end());
    return all;
}

// Whether two surfaces are the same triangles at the same pose, in whatever order: their own coordinates are compared,
// -0 as 0. So surfaces that are equal as sets of points, but cut or moved otherwise, are not found to be the same.
bool are_same(const Part& a, const Part& b) {
    if (!(a.pose == b.pose)) return false;
    const Mesh& one = a.shape->mesh();
    const Mesh& other = b.shape->mesh();
    if (&one == &other) return true;
    return one.triangles().size() == other.triangles().size() && sorted_triangles(one) == sorted_triangles(other);
}

std::optional<Verdict> judge_surfaces(const Part& a, const Part& b, QueryMemory& memory) {
    const Relation relation = ecods::relation(surface_of(a), surface_of(b), memory);
    if (relation == Relation::apart) return std::nullopt;
    if (are_same(a, b)) return Verdict{Kind::equal, "equal"};
    if (relation == Relation::crossing) return Verdict{Kind::crossing, "crossing"};
    return Verdict{Kind::touching, "touching"};
}

std::optional<Verdict> judge_contact(const Part& a, const Part& b, bool can_be_deep, QueryMemory& memory) {
    if (a.is_solid && b.is_solid) return judge_solids(a, b, can_be_deep, memory);
    if (b.is_solid) return judge_surface(a, b, true, memory);
    if (a.is_solid) return judge_surface(b, a, false, memory);
    return judge_surfaces(a, b, memory);
}

}  // namespace

Posed<MeshShape> surface_of(const Part& part) {
    return {*part.shape, part.pose};
}

Posed<Solid> solid_of(const Part& part) {
    return {dynamic_cast<const Solid&>(*part.shape), part.pose};
}

std::optional<Verdict> judge_pair(const Part& a, const Part& b, std::optional<double> clearance, QueryMemory& memory,
                                  bool can_be_deep) {
    if (const auto contact = judge_contact(a, b, can_be_deep, memory)) return contact;
    if (!clearance || !within(surface_of(a), surface_of(b), *clearance, memory)) return std::nullopt;
    return Verdict{Kind::clearance, "apart", distance(surface_of(a), surface_of(b), memory)};
}

}  // namespace ecods::clash
