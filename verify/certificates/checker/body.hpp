// A posed mesh: how far its parts reach along a vector, first in doubles with a proven bound, then in integers.
#pragma once

#include <limits>
#include <optional>
#include <unordered_map>

#include "certificate.hpp"
#include "mesh.hpp"
#include "numbers.hpp"

namespace certificate_checker {

// Thrown where the work of a file exceeds its budget (README.md, "Limits").
struct TooCostly {};
struct Budget {
    std::uint64_t left = 0;
    void spend(std::uint64_t units) {
        if (units > left) throw TooCostly{};
        left -= units;
    }
};

struct Range {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};
struct ExactRange {
    Integer low, high;
};

// Along a vector n, vertex v of the mesh, posed, is at v.n + offset, but for at most `error`. So are the corners of
// boxes.
struct Direction {
    Vector<double> n{};
    double offset = 0;
    double error = 0;
};

// A piece of a segment: from + s (to - from) for the two s, each of which is half the sum of two doubles.
struct Piece {
    Vector<double> from, to;
    std::array<std::array<double, 2>, 2> s;
};

class Body {
  public:
    // In doubles, coordinates are relative to `origin`.
    Body(const Mesh& mesh, const Pose& pose, const Vector<double>& origin, Budget& budget);
    // A body of one triangle, with corners at the ends of the piece: the first, the last, the last.
    Body(const Piece& piece, const Vector<double>& origin, Budget& budget);

    const Mesh& mesh() const { return piece_ ? own_mesh_ : *mesh_; }
    // The part that is the caller's triangle; nothing if there is none.
    std::optional<std::uint32_t> triangle(std::uint32_t number) const;

    Direction direction(const Vector<Approximate>& n) const;
    Range outer_range(std::uint32_t part, const Direction& d) const;  // contains the part's range
    Range range(std::uint32_t part, const Direction& d) const;
    Vector<Approximate> approximate_corner(std::uint32_t triangle_part, std::size_t k) const;

    // Integers are in units of 2^low, which must be at most lowest_bit(). Asked before any of what follows.
    int lowest_bit() const;
    void set_unit(int low);
    const Vector<Integer>& corner(std::uint32_t triangle_part, std::size_t k) const;
    // `d` is in the direction of n.
    ExactRange exact_range(std::uint32_t part, const Direction& d, const Vector<Integer>& n) const;

  private:
    template <class Use>
    void visit(std::uint32_t part, const Direction& d, const Range& inner, const Use& use) const;
    Range box_range(std::uint32_t node, const Direction& d) const;
    const Vector<Integer>& point(std::uint32_t vertex) const;
    void measure(const Vector<double>& origin);

    const Mesh* mesh_ = nullptr;
    Mesh own_mesh_;
    std::optional<Piece> piece_;
    Pose pose_;
    Budget* budget_;
    Vector<double> offset_{};     // t - origin, rounded
    Vector<double> slack_{};      // how far vertices may be from where they should be: a piece's ends are rounded
    Vector<double> magnitude_{};  // at least the sum of absolute values of R's row times vertex, and of t - origin
    bool is_moderate_ = true;     // no double can overflow
    int low_ = 0;
    std::array<Vector<Integer>, 3> R_;
    Vector<Integer> t_;
    mutable std::unordered_map<std::uint32_t, Vector<Integer>> points_;
};

}  // namespace certificate_checker
