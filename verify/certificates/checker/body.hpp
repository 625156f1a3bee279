// A posed mesh: how far its parts reach along a vector, first in doubles with a proven bound, then in integers.
#pragma once

#include <limits>
#include <optional>
#include <unordered_map>

#include "certificate.hpp"
#include "mesh.hpp"
#include "numbers.hpp"

namespace certificate_checker {

inline constexpr double infinity = std::numeric_limits<double>::infinity();

// Thrown where the work of a file exceeds its budget (README.md, "Limits").
struct TooCostly {};
struct Budget {
    std::uint64_t left = 0;
    void spend(std::uint64_t units) { units > left ? throw TooCostly{} : left -= units; }
};

template <class Number>
struct Range {
    Number low, high;
};
inline constexpr Range<double> nothing = {infinity, -infinity};
inline bool contains(const Range<double>& range, double x) {
    return range.low <= x && x <= range.high;
}

// Along a vector n, vertex v of the mesh, posed, is at v.n + offset, but for at most `error`. So are the corners of
// boxes.
struct Direction {
    Vector<double> n{};
    double offset = 0, error = 0;
};

class Body {
  public:
    // Doubles are relative to `origin`.
    Body(const Mesh& mesh, const Pose& pose, const Vector<double>& origin, Budget& budget);

    const Mesh& mesh() const { return *mesh_; }
    Budget& budget() const { return *budget_; }
    const Vector<double>& origin() const { return origin_; }
    Direction direction(const Vector<Approximate>& n) const;
    Range<double> box_range(std::uint32_t node, const Direction& d) const;
    Range<double> range(std::uint32_t part, const Direction& d) const;
    Vector<Approximate> approximate_corner(std::uint32_t triangle, std::size_t k) const;

    // Integers are in units of 2^low, at most lowest(). Asked before any of what follows.
    int lowest() const { return std::min(low_R_ + mesh_->low, lowest_bit(pose_.t)); }
    void set_unit(int low);
    const Vector<Integer>& point(std::uint32_t vertex) const;
    const Vector<Integer>& corner(std::uint32_t triangle, std::size_t k) const {
        return point(mesh_->corners(triangle)[k % 3]);
    }
    // `d` is in the direction of n.
    Range<Integer> exact_range(std::uint32_t part, const Direction& d, const Vector<Integer>& n) const;

  private:
    template <class Use>
    void visit(std::uint32_t part, const Direction& d, const Range<double>& inner, const Use& use) const;

    const Mesh* mesh_;
    Pose pose_;
    Vector<double> origin_;
    Budget* budget_;
    Vector<double> offset_{};     // t - origin, rounded
    Vector<double> magnitude_{};  // the sum of absolute values of R's row times vertex, and of t - origin
    bool is_moderate_ = true;     // no double can overflow
    int low_R_, low_ = 0;
    std::array<Vector<Integer>, 3> R_;
    mutable std::unordered_map<std::uint32_t, Vector<Integer>> points_;
};

}  // namespace certificate_checker
