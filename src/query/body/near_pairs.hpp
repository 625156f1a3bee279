// NearLine and NearWay list the pairs of triangles that may be within a distance p of each other while a point or a
// body is translated.
//
// Bound. Positions are computed in doubles, with few roundings: of a difference, a product and a sum. Let S be the sum
// of the magnitudes of all terms of a position's coordinates, added over the axes. With u' = two_u, each term goes
// through three roundings, and a parameter may be off by 4 u' of itself, so a position is off by less than 7.1 u' S. S
// as computed has seven roundings, and 8 u' S covers them. A motion of a body may be rounded, too: its terms go through
// one rounding more, and 9 u' S covers them. The distance that is searched is a sum of three rounded numbers, and the
// reach of half a motion is a product with six roundings: 8 u' times each number covers its roundings. Numbers that
// underflow lose less than 2^-1000 in all; times that may be flushed to zero count as 2^-900. If a number overflows,
// all pairs are listed.
// Claim: verify/proofs/root_sums.py
#pragma once

#include <cstddef>
#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/number/exact_sum.hpp"
#include "geometry/line.hpp"
#include "query/body/earliest.hpp"
#include "query/intersection/query_memory.hpp"

namespace ecods {

// A Place is a position in doubles, and an upper bound of its distance from the real one.
struct Place {
    Vec3 point;
    double error;
};
// Returns the position at parameter s of the line. The error bound covers a parameter that is off by up to 4 u' s.
Place place_on(const Line& line, double s);

// NearLine lists the triangles of a boundary that may be within p of points of a line, as pairs with pair.a = 0.
class NearLine {
  public:
    // Everything that the arguments refer to must outlive this object.
    NearLine(const Line& line, const Posed<MeshShape>& boundary, const exact::ExactSum& p, QueryMemory& memory)
        : line_(line), boundary_(boundary), p_(p), memory_(memory) {}

    std::optional<PairList> list(double from, double to, std::size_t most) const;

  private:
    const Line& line_;
    const Posed<MeshShape>& boundary_;
    const exact::ExactSum& p_;
    QueryMemory& memory_;
};

// NearWay lists the pairs of triangles that may come within p of each other while boundary a is translated, b being at
// rest. Each coordinate of `motion` is a real number, rounded once; it may be infinite.
class NearWay {
  public:
    NearWay(const Posed<MeshShape>& a, const Vec3& motion, const Posed<MeshShape>& b, const exact::ExactSum& p,
            QueryMemory& memory)
        : a_(a), motion_(motion), b_(b), p_(p), memory_(memory) {}

    std::optional<PairList> list(double from, double to, std::size_t most) const;

  private:
    const Posed<MeshShape>& a_;
    const Vec3& motion_;
    const Posed<MeshShape>& b_;
    const exact::ExactSum& p_;
    QueryMemory& memory_;
};

}  // namespace ecods
