// Ids name bodies and pairs of a World. This header stands alone.
//
// An id is opaque, small and passed by value. An id of zeros is null and names nothing. Ids contain no pointers, so
// traces can record them. An id keeps nothing alive.
//
// Example: verify/examples/how_do_i, ignore_pairs().
#pragma once

#include <compare>
#include <cstdint>
#include <iosfwd>

#include "ecods/export.hpp"

namespace ecods {

// A BodyId names one body of one World, from its creation to its destruction (Box3D: b3BodyId; Jolt: BodyID). The slot
// of a destroyed body is used again with a new generation. So an id that outlives its body is recognised (StaleBody)
// and never names another body. A slot whose generations are used up, after 65,536 bodies, is never used again; it
// keeps its memory. An id of another world is recognised by the number of its world. There are 65,535 numbers: worlds
// are numbered in order, then from 1 again.
//
// The number of the world is not written down: it is in no trace, no digest and no message. An id that a program makes
// of slot and generation alone has world 0, and counts as an id of the world that it is given to.
struct BodyId {
    std::uint32_t slot = 0;        // 1-based; 0 is null
    std::uint16_t generation = 0;  // number of earlier bodies in the slot
    std::uint16_t world = 0;

    constexpr explicit operator bool() const noexcept { return slot != 0; }

    // Orders ids by slot, then by generation (the order in which pairs are listed), then by world.
    constexpr std::uint64_t rank() const noexcept {
        return std::uint64_t{slot} << 32 | std::uint32_t{generation} << 16 | world;
    }
    friend constexpr bool operator==(const BodyId&, const BodyId&) = default;
    friend constexpr auto operator<=>(const BodyId& a, const BodyId& b) { return a.rank() <=> b.rank(); }
};

// A BodyPair names two bodies, with the smaller id first. Lists of pairs are ascending and contain each pair once.
struct BodyPair {
    BodyId a;
    BodyId b;

    friend constexpr auto operator<=>(const BodyPair&, const BodyPair&) = default;
};

// A TrianglePair names one triangle of each of two meshes, by index: `a` in the first mesh, `b` in the second.
struct TrianglePair {
    std::uint32_t a = 0;
    std::uint32_t b = 0;

    friend constexpr auto operator<=>(const TrianglePair&, const TrianglePair&) = default;
};

// A Question is a question that a two-body test, or a shape (hits), may leave unanswered (shape.hpp). Two of the
// questions are never put to a test, and occur in NotSupported alone: every test answers `intersects`, and only meshes
// answer `certify`.
enum class Question : std::uint8_t {
    relation,
    intersecting_triangles,
    distance,
    within,
    closest,
    intersections,
    close_features,
    cast,
    cast_moving,
    hits,
    intersects,
    certify,
    cast_any_motion,
};

// A ShapeKind is the kind of a shape, by which a World selects the test for two bodies. Kind 0 is the triangle mesh;
// the three greatest kinds are rounded shapes (rounded.hpp) and half spaces (solid.hpp); the caller defines all
// other values.
struct ShapeKind {
    std::uint32_t value = 0;

    static constexpr ShapeKind mesh() noexcept { return {}; }
    static constexpr ShapeKind rounded() noexcept { return {~std::uint32_t{0}}; }
    static constexpr ShapeKind rounded_convex() noexcept { return {~std::uint32_t{1}}; }  // rounded, with a convex core
    static constexpr ShapeKind half_space() noexcept { return {~std::uint32_t{2}}; }
    friend constexpr auto operator<=>(const ShapeKind&, const ShapeKind&) = default;
};

// A CollisionFilter says which bodies may meet. A body is in groups, and its mask names the groups that it meets. Two
// bodies may meet if each is in a group that the other's mask names. By default a body is in the first group and its
// mask names all groups, so all bodies may meet. A body whose mask is zero meets nothing. (Bullet: group and mask;
// Box3D: category and mask bits.)
struct CollisionFilter {
    std::uint64_t groups = 1;
    std::uint64_t mask = ~std::uint64_t{0};

    friend constexpr bool operator==(const CollisionFilter&, const CollisionFilter&) = default;
};

[[nodiscard]] constexpr bool may_meet(const CollisionFilter& a, const CollisionFilter& b) noexcept {
    return (a.groups & b.mask) != 0 && (b.groups & a.mask) != 0;
}

// Write ids in the form that traces and messages use: "3.1" (slot and generation), "(3.1, 12.0)", "(7, 2)"; "mesh",
// "rounded", "rounded convex", "half space", "kind 7".
ECODS_API std::ostream& operator<<(std::ostream& out, BodyId body);
ECODS_API std::ostream& operator<<(std::ostream& out, const BodyPair& pair);
ECODS_API std::ostream& operator<<(std::ostream& out, const TrianglePair& pair);
ECODS_API std::ostream& operator<<(std::ostream& out, ShapeKind kind);

}  // namespace ecods
