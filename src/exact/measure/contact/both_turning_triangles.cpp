#include "exact/measure/contact/both_turning_triangles.hpp"

#include <utility>

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::exact {
namespace {

using Vector = RelativePositionOf<Quintic>::Vector;

Vector times(const Quintic& p, const Vector& v) {
    return {p * v[0], p * v[1], p * v[2]};
}

Vector plus(const Vector& v, const Vector& w) {
    return {v[0] + w[0], v[1] + w[1], v[2] + w[2]};
}

// Returns the vector start + s way, as polynomials in s.
Vector linear(const LongVector3& start, const LongVector3& way) {
    return {Quintic(start[0], way[0]), Quintic(start[1], way[1]), Quintic(start[2], way[2])};
}

// Returns q0 g + s q1(g) + s^2 q2(g), the difference of the turned vector N(s) R(s) g and N(s) g
// (turning_triangles.hpp).
Vector change_of(const LongVector3& g, const TurnIntegers& turn) {
    const TurnIntegers::Turned turned = turn.turned(g);
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) result[k] = Quintic({turned.zeroth[k], turned.first[k], turned.second[k]});
    return result;
}

}  // namespace

void BothTurningTriangles::set(std::size_t which, const std::array<LongVector3, 3>& corners, const LongVector3& pivot,
                               const LongVector3& pivot_to, const TurnIntegers& turn) {
    Side& side = sides_[which];
    const LongVector3 m = minus(pivot_to, pivot), none{};
    const Vector place = linear(pivot, m);
    side.norm = Quintic({turn.n[0], turn.n[1], turn.n[2]});
    const auto turned = [&](const LongVector3& g) {
        return plus(times(side.norm, linear(g, none)), change_of(g, turn));
    };
    for (std::size_t i = 0; i < 3; ++i) {
        const LongVector3 g = minus(corners[i], pivot), edge = minus(corners[next_corner(i)], corners[i]);
        side.corner[i] = plus(times(side.norm, linear(corners[i], m)), change_of(g, turn));
        side.edge[i] = turned(edge);
        side.moment[i] = plus(cross(side.edge[i], place), turned(cross(edge, g)));
    }
    const LongVector3 n = cross(minus(corners[1], corners[0]), minus(corners[2], corners[0]));
    side.normal = turned(n);
    side.offset = dot(side.normal, place) + side.norm * Quintic(dot(n, minus(corners[0], pivot)), {});
}

void BothTurningTriangles::set_straight(std::size_t which, const std::array<LongVector3, 3>& from,
                                        const std::array<LongVector3, 3>& to) {
    Side& side = sides_[which];
    side.norm = Quintic(Integer(std::int64_t{1}), {});
    for (std::size_t i = 0; i < 3; ++i) side.corner[i] = linear(from[i], minus(to[i], from[i]));
    for (std::size_t i = 0; i < 3; ++i) {
        side.edge[i] = minus(side.corner[next_corner(i)], side.corner[i]);
        side.moment[i] = cross(side.edge[i], side.corner[i]);
    }
    side.normal = cross(side.edge[0], side.edge[1]);
    side.offset = dot(side.normal, side.corner[0]);
}

Quintic BothTurningTriangles::difference(std::size_t i, std::size_t j, std::size_t axis) const {
    return sides_[1].norm * sides_[0].corner[i][axis] - sides_[0].norm * sides_[1].corner[j][axis];
}

const RelativePositionOf<Quintic>::Vector& BothTurningTriangles::turn(const CornerAndEdge& which) {
    std::optional<Vector>& turn = turns_[index_of(which)];
    if (!turn) {
        const Side &of_corner = sides_[which.side], &of_edge = sides_[1 - which.side];
        turn = minus(cross(of_edge.edge[which.edge], of_corner.corner[which.corner]),
                     times(of_corner.norm, of_edge.moment[which.edge]));
    }
    return *turn;
}

Quintic BothTurningTriangles::corner_volume(std::size_t side, std::size_t corner) {
    const Side &of_corner = sides_[side], &of_face = sides_[1 - side];
    return dot(of_face.normal, of_corner.corner[corner]) - of_corner.norm * of_face.offset;
}

Quintic BothTurningTriangles::edge_volume(std::size_t edge_a, std::size_t edge_b) const {
    const Side &a = sides_[0], &b = sides_[1];
    return dot(a.edge[edge_a], b.moment[edge_b]) + dot(b.edge[edge_b], a.moment[edge_a]);
}

}  // namespace ecods::exact
