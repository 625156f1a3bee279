// Hits are the points where a segment or a ray meets a body, in their order (Parry: cast_ray; Jolt: CastRay; Bullet:
// rayTest; Box3D: b3World_CastRay; Embree: rtcIntersect1). No World is needed.
//
//     std::optional<Hit> hit = first_hit(Ray{eye, direction}, {cube, pose});
//     if (hit) hit->parameter, hit->point, hit->triangle()
//
// A body is as in intersection.hpp. A line that begins inside a solid, and not on its surface, hits the solid at
// parameter 0, with the kind `inside`, and then its surface. A triangle is hit if it shares a point with the segment or
// ray, ends included. So nothing leaks through an edge or a vertex: every triangle with this edge or vertex is hit. A
// triangle that is only close to the line is not hit. Real numbers decide, in any rounding mode.
//
// The parameter of a point of a segment is 0 at its first end and 1 at its second; for a ray it is the multiple of the
// direction. Parameters and coordinates are the true ones, rounded once (distance.hpp says how). A positive parameter
// is at least 2^-1074, so it is 0 exactly if the line begins on the surface; beyond the largest double it is infinity.
// Hits are in the order of the real parameters, not of the rounded ones.
//
// Everything is defined for all finite poses, also singular ones; for zero-area triangles, which are the segments or
// points that they span; and for a segment of length 0, which is a point. Threads are as in intersection.hpp. All
// functions throw InvalidArgument if validate() refuses the segment or ray.
//
// A hit has no normal and no side of its own: computing them takes some microseconds, which most callers do not need.
// hit_normal() gives the normal of one hit; sided_hits() gives all hits with normals, and says whether the line enters
// or leaves there; inside_parts() gives the parts of the line that are inside a solid.
//
// Example: verify/examples/how_do_i, ray().
// Example: verify/examples/how_do_i, way_through_a_world().
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Return the hit with the least parameter; if several triangles tie, the least triangle; nullopt if there is no hit.
//
// Use a witness for a line that moves little: its triangle `b` is tried first, and replaced by the triangle that is
// hit. If a segment moves in small steps, the memory keeps the triangles near its path, and most steps need no walk.
// Cost: a walk along the line, nearest boxes first; some tenths of a microsecond for each triangle whose hit doubles
// cannot separate from the first; and the rounding.
[[nodiscard]] ECODS_API std::optional<Hit> first_hit(const Segment& segment, const Posed<MeshShape>& body,
                                                     const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<Hit> first_hit(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask = {});

// Return the hit of every triangle that is hit, ascending by real parameter, then by triangle.
[[nodiscard]] ECODS_API std::vector<Hit> all_hits(const Segment& segment, const Posed<MeshShape>& body,
                                                  const Ask& ask = {});
[[nodiscard]] ECODS_API std::vector<Hit> all_hits(const Ray& ray, const Posed<MeshShape>& body, const Ask& ask = {});

// HitListsOf holds the hits of many lines: line i has hits[first[i]] to hits[first[i + 1] - 1].
template <class AnyHit>
struct HitListsOf {
    std::vector<AnyHit> hits;
    std::vector<std::size_t> first;  // one entry more than there are lines

    std::span<const AnyHit> of(std::size_t line) const {
        return std::span(hits).subspan(first[line], first[line + 1] - first[line]);
    }
};
using HitLists = HitListsOf<Hit>;          // of one body
using BodyHitLists = HitListsOf<BodyHit>;  // of the bodies of a World

// Return all_hits() of each line, in the order of the lines. The error's `index` says which line is not valid.
[[nodiscard]] ECODS_API HitLists all_hits(std::span<const Segment> segments, const Posed<MeshShape>& body,
                                          const Ask& ask = {});
[[nodiscard]] ECODS_API HitLists all_hits(std::span<const Ray> rays, const Posed<MeshShape>& body, const Ask& ask = {});

// ---- normals and sides

// Return the unit normal at a hit, (q - p) x (r - p) of the posed corners p, q, r of a triangle, each coordinate
// rounded once.
//
// If the hit's feature is a face, the triangle is the hit's. At an edge or a vertex, it is chosen from all triangles
// that the line hits first at the same real parameter: it is the one whose unit normal n is most opposed to the line's
// direction d (the real n . d is least); if several tie, the least triangle. Zero-area triangles do not count. So the
// normal depends neither on which of these triangles the hit names, nor on the order of triangles, unless two normals
// tie. It points out of a solid whose triangles are counterclockwise seen from outside, at a pose that does not mirror.
//
// The result is empty if no triangle counts, for the kind `inside`, or if the line has no such hit at an edge or a
// vertex (whether the line has a given hit of a face is not checked). Throw InvalidArgument. Cost: about two
// microseconds for a face; otherwise that of all_hits(), and some microseconds for each triangle at the parameter.
[[nodiscard]] ECODS_API std::optional<Vec3> hit_normal(const Segment& segment, const Posed<MeshShape>& body,
                                                       const Hit& hit, const Ask& ask = {});
[[nodiscard]] ECODS_API std::optional<Vec3> hit_normal(const Ray& ray, const Posed<MeshShape>& body, const Hit& hit,
                                                       const Ask& ask = {});

// A Passage says what a line does at a hit.
enum class Passage : std::uint8_t {
    enters,   // it is inside the solid just after the hit, and not inside just before
    leaves,   // it is inside just before, and not just after
    grazes,   // neither: it touches the surface from outside or from inside, or runs along it
    crosses,  // of a surface: the line goes through it
    begins,   // it begins inside the solid: HitKind::inside
};

// A SidedHit is a hit with its normal, and the sides on which the line is before and after it.
//
// `before` is where the line is just before the hit's parameter, `after` where it is just after its leave_parameter:
// `on` means that the line runs along the surface there, in any of the triangles. The line is taken to go on beyond its
// ends, so a ray that begins on a face and goes inwards enters there. A line of length 0 is `on`, and grazes.
//
// A surface, a flat solid, or a solid at a singular pose has no inside: `before` and `after` are outside or on, and
// outside beyond the line's ends. There, a hit of the kinds front and back crosses. At an edge or a vertex, the line is
// shifted aside by an infinitesimal multiple of (1, k, k^2), for the least k = 0, 1, ... with which the shifted line
// meets no prolonged edge of the hit triangles that is in a common plane with the line. The line crosses there if the
// shifted line crosses an odd number of the triangles that are hit first at the same real parameter. (If all edges
// there belong to an even number of triangles, any shift gives the same answer.) All other hits graze.
struct SidedHit {
    Hit hit;
    Side before = Side::outside, after = Side::outside;
    Passage passage = Passage::grazes;
    std::optional<Vec3> normal;  // the normal that hit_normal() returns
};

// Return all_hits(), each with its normal and its sides. Throw InvalidArgument. Cost: that of all_hits(), one locate(),
// and some microseconds for each hit.
[[nodiscard]] ECODS_API std::vector<SidedHit> sided_hits(const Segment& segment, const Posed<MeshShape>& body,
                                                         const Ask& ask = {});
[[nodiscard]] ECODS_API std::vector<SidedHit> sided_hits(const Ray& ray, const Posed<MeshShape>& body,
                                                         const Ask& ask = {});

// A PartEnd says how a part of a line begins or ends.
enum class PartEnd : std::uint8_t {
    of_line,  // the line itself begins or ends there, inside
    crosses,  // at the surface; beyond it the line is outside
    grazes,   // at one point of the surface; beyond it the line is inside again
    along,    // at the surface; from there on the line runs along it
};

// An InsidePart is a part of a line that is inside a solid: the points at parameters between `from` and `to`. Ends on
// the surface do not belong to it. Parameters and points are the true ones, rounded once, as in Hit.
struct InsidePart {
    double from = 0, to = 0;
    PartEnd begin = PartEnd::of_line, end = PartEnd::of_line;
    Vec3 from_point = Vec3::Zero(), to_point = Vec3::Zero();

    friend bool operator==(const InsidePart&, const InsidePart&) = default;
};

// Return the parts of the line that are inside the solid, ascending. Each part is as long as possible, so where a line
// touches the surface from inside at one point, one part ends and the next begins, both by `grazes`. A piece of the
// line that only touches the surface, or runs along it, is no part. A flat solid, a solid at a singular pose, and a
// line of length 0 have no parts. Throw InvalidArgument. Cost: that of all_hits(), one locate(), and some microseconds
// for each hit of an edge or a vertex.
[[nodiscard]] ECODS_API std::vector<InsidePart> inside_parts(const Segment& segment, const Posed<Solid>& solid,
                                                             const Ask& ask = {});
[[nodiscard]] ECODS_API std::vector<InsidePart> inside_parts(const Ray& ray, const Posed<Solid>& solid,
                                                             const Ask& ask = {});

// ---- answers of a World

// A BodySidedHit is a hit with its normal and sides, and its body. Hits have the order and the ranks of BodyHit. The
// sides are those of this body alone.
struct BodySidedHit {
    BodyId body;
    SidedHit sided;
};

// A BodyInsidePart is a part of a line that is inside a solid. Parts are ordered by the real parameter where they
// begin, then by id. Parts of several bodies may overlap.
struct BodyInsidePart {
    BodyId body;
    InsidePart part;

    friend bool operator==(const BodyInsidePart&, const BodyInsidePart&) = default;
};

}  // namespace ecods
