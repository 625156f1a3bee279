#include "exact/measure/contact/turning_triangles.hpp"

#include "exact/measure/distance/feature_pair.hpp"
#include "exact/number/dyadic.hpp"
#include "exact/point/vectors.hpp"

namespace ecods::exact {
namespace {

LongVector3 plus(const LongVector3& a, const LongVector3& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

LongVector3 times(const Integer& k, const LongVector3& a) {
    return {k * a[0], k * a[1], k * a[2]};
}

LongVector3 twice(const LongVector3& a) {
    return plus(a, a);
}

LongVector3 negative(const LongVector3& a) {
    return {-a[0], -a[1], -a[2]};
}

}  // namespace

TurnIntegers::TurnIntegers(double w, const Vec3& axis)
    : TurnIntegers(Quaternion(), Quaternion{w, axis[0], axis[1], axis[2]}) {}

TurnIntegers::TurnIntegers(const Quaternion& from, const Quaternion& to) {
    const std::array<double, 8> numbers{from.w, from.x, from.y, from.z, to.w, to.x, to.y, to.z};
    BitRange digits;
    for (const double x : numbers) digits.include(decode(x));
    const auto in_unit = [&](std::size_t i) -> Integer {
        const Dyadic x = decode(numbers[i]);
        return x.m == 0 ? Integer() : Integer(x.m) << (x.e - digits.low);
    };
    e = in_unit(0);
    u = in_unit(4) - e;
    for (std::size_t k = 0; k < 3; ++k) {
        f[k] = in_unit(1 + k);
        v[k] = in_unit(5 + k) - f[k];
    }
    const Integer both = e * u + dot(f, v);
    n = {e * e + dot(f, f), both + both, u * u + dot(v, v)};
}

TurnIntegers::Turned TurnIntegers::turned(const LongVector3& g) const {
    const LongVector3 at_start = cross(f, g), d = cross(v, g), mixed = plus(cross(f, d), cross(v, at_start));
    return {twice(plus(times(e, at_start), cross(f, at_start))),
            twice(plus(plus(times(e, d), times(u, at_start)), mixed)), twice(plus(times(u, d), cross(v, d)))};
}

void TurningTriangles::set(const std::array<LongVector3, point_count>& points) {
    const LongVector3& pivot = points[6];
    const LongVector3 gone = minus(pivot, points[10]);
    m_ = minus(minus(points[7], pivot), minus(points[9], points[8]));
    for (std::size_t i = 0; i < 3; ++i) {
        p_[i] = plus(points[i], gone);
        y_[i] = points[3 + i];
        r_[i] = minus(y_[i], pivot);
    }
    for (std::size_t i = 0; i < 3; ++i) {
        const LongVector3 g = minus(p_[i], pivot);
        turning_edge_[i] = minus(p_[next_corner(i)], p_[i]);
        resting_edge_[i] = minus(y_[next_corner(i)], y_[i]);
        turned_corner_[i] = turn_.turned(g);
        turned_edge_[i] = turn_.turned(turning_edge_[i]);
        turned_moment_[i] = turn_.turned(cross(turning_edge_[i], g));
    }
}

// Returns N (start + s way) + rest, as a polynomial in s.
Polynomial TurningTriangles::over_norm(const Integer& start, const Integer& way, const Beside<Integer>& rest) const {
    const LongVector3& n = turn_.n;
    return Polynomial(Polynomial::Coefficients{n[0] * start + rest.zeroth, n[1] * start + n[0] * way + rest.first,
                                               n[2] * start + n[1] * way + rest.second, n[2] * way + rest.third});
}

RelativePosition::Vector TurningTriangles::over_norm(const LongVector3& start, const LongVector3& way,
                                                     const Rest& rest) const {
    Vector result;
    for (std::size_t k = 0; k < 3; ++k) {
        result[k] = over_norm(start[k], way[k], {rest.zeroth[k], rest.first[k], rest.second[k], rest.third[k]});
    }
    return result;
}

Polynomial TurningTriangles::difference(std::size_t i, std::size_t j, std::size_t axis) const {
    const Turned& g = turned_corner_[i];
    return over_norm(p_[i][axis] - y_[j][axis], m_[axis], {g.zeroth[axis], g.first[axis], g.second[axis]});
}

const RelativePosition::Vector& TurningTriangles::turn(const CornerAndEdge& which) {
    std::optional<Vector>& turn = turns_[index_of(which)];
    if (!turn) {
        turn = which.side == 0 ? turn_of_turning(which.corner, which.edge) : turn_of_resting(which.corner, which.edge);
    }
    return *turn;
}

// Returns the turn of a corner that turns about an edge at rest.
RelativePosition::Vector TurningTriangles::turn_of_turning(std::size_t corner, std::size_t edge) const {
    const LongVector3& b = resting_edge_[edge];
    const Turned& g = turned_corner_[corner];
    return over_norm(cross(b, minus(p_[corner], y_[edge])), cross(b, m_),
                     {cross(b, g.zeroth), cross(b, g.first), cross(b, g.second)});
}

// Returns the turn of a corner at rest about an edge that turns.
RelativePosition::Vector TurningTriangles::turn_of_resting(std::size_t corner, std::size_t edge) const {
    const LongVector3 &a = turning_edge_[edge], &r = r_[corner];
    const Turned &q = turned_edge_[edge], &h = turned_moment_[edge];
    return over_norm(cross(a, minus(y_[corner], p_[edge])), cross(m_, a),
                     {minus(cross(q.zeroth, r), h.zeroth), plus(minus(cross(q.first, r), h.first), cross(m_, q.zeroth)),
                      plus(minus(cross(q.second, r), h.second), cross(m_, q.first)), cross(m_, q.second)});
}

Polynomial TurningTriangles::corner_volume(std::size_t side, std::size_t corner) {
    if (side == 0) {
        const LongVector3 n = cross(resting_edge_[0], minus(y_[2], y_[0]));
        const Turned& g = turned_corner_[corner];
        return over_norm(dot(n, minus(p_[corner], y_[0])), dot(n, m_),
                         {dot(n, g.zeroth), dot(n, g.first), dot(n, g.second)});
    }
    const LongVector3 n = cross(turning_edge_[0], minus(p_[2], p_[0]));
    const Turned q = turn_.turned(n);
    const LongVector3& r = r_[corner];
    return over_norm(dot(n, minus(y_[corner], p_[0])), -dot(n, m_),
                     {dot(q.zeroth, r), dot(q.first, r) - dot(q.zeroth, m_), dot(q.second, r) - dot(q.first, m_),
                      -dot(q.second, m_)});
}

// turned_moment_ holds a x g, the negative of h = g x a in the formula.
Polynomial TurningTriangles::edge_volume(std::size_t edge_a, std::size_t edge_b) const {
    const LongVector3 &a = turning_edge_[edge_a], &b = resting_edge_[edge_b];
    const LongVector3 br = cross(b, r_[edge_b]), bm = negative(cross(b, m_));
    const Turned &q = turned_edge_[edge_a], &moment = turned_moment_[edge_a];
    return over_norm(
        dot(a, cross(b, minus(y_[edge_b], p_[edge_a]))), dot(a, bm),
        {dot(q.zeroth, br) + dot(b, moment.zeroth), dot(q.first, br) + dot(b, moment.first) + dot(q.zeroth, bm),
         dot(q.second, br) + dot(b, moment.second) + dot(q.first, bm), dot(q.second, bm)});
}

}  // namespace ecods::exact
