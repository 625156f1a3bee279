// This file computes the points at which two features are closest at a time, and the direction between them, while one
// is translated.
//
// Names are those of rounded_contact.hpp. At time s let W = w + s m be the vector from the piece's first corner to the
// point s m, and D = y - x the vector from the closest point x of A's feature to the closest point y of B's. D leads
// from s m to its foot in the piece, so it is minus the part of W that is perpendicular to the piece. Times a number N,
//
//     two vertices         N = 1     N D = -W
//     vertex and edge u    N = u.u   N D = u x (u x W)
//     plate, n = u x v     N = n.n   N D = -n (n.W)
//
// The point is x + (r / p) D = y - ((p - r) / p) D, with the radius r of A. A vertex of A is x = a + s m; a vertex of B
// is y = b. Of two edges, y = b + t v for the edge v of B: W + D is a multiple of u plus t v, and n x u is
// perpendicular to u and D, so N t = W . (n x u). All of these are linear in s, and s is a sum of a fraction and a
// root, so each coordinate is such a sum, too.
#include "exact/measure/contact/rounded_contact.hpp"
#include "exact/measure/round/round_root_sum.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::exact {
namespace {

// A LinearVector is a linear function of time: slope * time + begin.
struct LinearVector {
    ScaledLongVector slope, begin;

    friend LinearVector operator+(const LinearVector& a, const LinearVector& b) {
        return {plus(a.slope, b.slope), plus(a.begin, b.begin)};
    }
    friend LinearVector operator*(const LinearVector& a, const ScaledInteger& x) {
        return {times(a.slope, x), times(a.begin, x)};
    }
};

// Returns the quotient sum / den. den must be positive.
RootSum quotient(RootSum sum, const ScaledInteger& den) {
    sum.z = sum.z * den.m();
    sum.e -= den.e();
    sum.w = sum.w * den.m() * den.m();
    sum.f -= den.e();
    return sum;
}

Vec3 round_at(const LinearVector& v, const RootSum& time, const ScaledInteger& den) {
    Vec3 result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[static_cast<Eigen::Index>(k)] = round_root_sum(quotient(affine(v.slope[k], time, v.begin[k]), den));
    }
    return result;
}

}  // namespace

// Returns the factor N of the table above: 1 for two vertices, u.u for an edge, n.n for a plate. It is 0 if an edge has
// no length, or if edges or sides are parallel.
ScaledInteger RoundedContact::square_of(const Piece& piece) {
    if (piece.dimension == 0) return ScaledInteger(1.0);
    const ScaledLongVector n = piece.dimension == 1 ? piece.u : cross(piece.u, piece.v);
    return dot(n, n);
}

// Returns N D of the table above, with the vector x in place of W.
ScaledLongVector RoundedContact::across(const Piece& piece, const ScaledLongVector& x) {
    if (piece.dimension == 0) return {-x[0], -x[1], -x[2]};
    if (piece.dimension == 1) return cross(piece.u, cross(piece.u, x));
    const ScaledLongVector n = cross(piece.u, piece.v);
    return times(n, -dot(n, x));
}

std::optional<RoundedContact::Place> RoundedContact::place(const FeaturePair& f, const RootSum& time,
                                                           const ScaledInteger& radius_a) const {
    const Piece piece = piece_of(f);
    const ScaledInteger square = square_of(piece);
    if (square.sign() == 0) return std::nullopt;
    const LinearVector d{across(piece, motion_), across(piece, piece.w)};  // N D
    const ScaledInteger den = square * p_, radius_b = p_ - radius_a;
    LinearVector point;  // N p times the point
    if (f.has_vertex(0)) {
        point = LinearVector{motion_, corner(0, f.a)} * den + d * radius_a;
    } else {
        LinearVector y = LinearVector{{}, corner(1, f.b)} * square;  // N y
        if (!f.has_vertex(1)) {
            const ScaledLongVector along = cross(cross(piece.u, piece.v), piece.u);
            y = y + LinearVector{times(piece.v, dot(motion_, along)), times(piece.v, dot(piece.w, along))};
        }
        point = y * p_ + d * -radius_b;
    }
    return Place{round_at(point, time, den), round_at(d, time, den)};
}

}  // namespace ecods::exact
