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

std::optional<Verdict> judge_contact(const Part& a, const Part& b, bool can_be_deep, QueryMemory& memory) {
    const bool has_solid = a.is_solid || b.is_solid;
    if (a.is_solid && b.is_solid && !can_be_deep) return judge_apart(a, b, memory);
    switch (relation(body_of(a), body_of(b), memory)) {
        case Relation::apart:
            return has_solid ? judge_apart(a, b, memory) : std::nullopt;
        case Relation::touching:
            if (!has_solid && are_same(a, b)) return Verdict{Kind::equal, "equal"};
            return Verdict{Kind::touching, "touching"};
        case Relation::crossing:
            if (has_solid) return Verdict{Kind::crossing, "partly_inside"};
            if (are_same(a, b)) return Verdict{Kind::equal, "equal"};
            return Verdict{Kind::crossing, "crossing"};
        case Relation::overlapping:
            return Verdict{Kind::overlapping, "overlapping"};
        case Relation::inside:
            return Verdict{Kind::inside, "inside"};
        case Relation::contains:
            return Verdict{Kind::inside, "contains"};
        case Relation::equal:
            return Verdict{Kind::equal, "equal"};
    }
    return std::nullopt;
}

}  // namespace

Posed<MeshShape> body_of(const Part& part) {
    return {*part.shape, part.pose};
}

Posed<MeshShape> surface_of(const Part& part) {
    if (!part.is_solid) return body_of(part);
    return {ecods::surface_of(*solid_of(part).what), part.pose};
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
