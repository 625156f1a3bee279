// MovingTriangles computes the relative position of two moving triangles, as polynomials in time. Each corner moves on
// a straight line from its position at time 0 to its position at time 1.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "exact/measure/contact/relative_position.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/number/root.hpp"
#include "exact/point/integer_points.hpp"

namespace ecods::exact {

class MovingTriangles final : public RelativePosition {
  public:
    // Takes the corners of both triangles at time 0, and then the same corners at time 1. Ignores points after these.
    template <class Kernel, std::size_t N>
    requires(N >= 12) explicit MovingTriangles(const IntegerPoints<Kernel, N>& points) { set(points.at); }
    explicit MovingTriangles(const std::array<std::array<Integer, 3>, 12>& points) { set(points); }

    Polynomial difference(std::size_t i, std::size_t j, std::size_t axis) const override;
    const Vector& turn(const CornerAndEdge& which) override;
    Polynomial corner_volume(std::size_t side, std::size_t corner) override;
    Polynomial edge_volume(std::size_t edge_a, std::size_t edge_b) const override;

  private:
    using Triangle = std::array<Vector, 3>;

    template <class Points>
    void set(const Points& points) {
        for (std::size_t i = 0; i < 6; ++i) {
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Integer start(points[i][axis]);
                corners_[i / 3][i % 3][axis] = Polynomial(start, Integer(points[i + 6][axis]) - start);
            }
        }
    }

    std::array<Triangle, 2> corners_;
    std::array<std::optional<Vector>, 2> normals_;
    std::array<std::optional<Vector>, 18> turns_;
};

// TrianglesAtRoot evaluates the relative position of two moving triangles at one time, which is the root of a
// polynomial.
template <class P>
class TrianglesAtRoot {
  public:
    TrianglesAtRoot(RelativePositionOf<P>& triangles, RootOf<P>& time) noexcept : triangles_(triangles), time_(time) {
        orders_.fill(unknown);
        turns_.fill(unknown);
        volumes_.fill(unknown);
    }

    // Returns true if the two features share a point at this time. A feature is a corner, an edge without its ends or a
    // face without its edges. Two edges share a point only if they cross and are not parallel.
    bool share_point(const FeaturePair& features);

  private:
    static constexpr std::int8_t unknown = 2;

    // Returns the sign of the polynomial make() at this time. `known` caches the sign, so each polynomial is computed
    // and evaluated only once.
    template <class Make>
    int sign_of(std::int8_t& known, const Make& make);
    int order(std::size_t i, std::size_t j, std::size_t axis);
    int turn(const CornerAndEdge& which, std::size_t axis);
    int corner_volume(std::size_t side, std::size_t corner);
    int edge_volume(std::size_t edge_a, std::size_t edge_b);
    bool is_inside_edge(const CornerAndEdge& which);
    bool is_inside_face(std::size_t side, std::size_t corner);
    bool edges_cross(std::size_t edge_a, std::size_t edge_b);

    RelativePositionOf<P>& triangles_;
    RootOf<P>& time_;
    std::array<std::int8_t, 27> orders_;
    std::array<std::int8_t, 54> turns_;
    std::array<std::int8_t, 15> volumes_;
};

}  // namespace ecods::exact
