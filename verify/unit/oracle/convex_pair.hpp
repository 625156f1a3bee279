// A second implementation of the relation of two triangles, to judge the oracle: from the definition, by linear
// programming in rational numbers. Slow, and shares no idea with the oracle: no plane, no side, no case of zero area.
//
// A triangle is the set of the convex combinations of its corners, and its relative interior the set of those with
// positive weights only, degenerate or not (Rockafellar, Convex Analysis, theorem 6.4 and section 6). So the common
// points of two triangles are the weights x >= 0 of six columns with: sum x_i a_i = sum y_j b_j, sum x_i = sum y_j = 1.
// This polytope is bounded; it is not empty if and only if it has a vertex, and it has a point with all weights
// positive if and only if each weight is positive in some vertex. Vertices are found by trying all sets of columns.
#pragma once

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstddef>
#include <vector>

#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods::oracle::model {

using Number = boost::multiprecision::cpp_rational;
using Point = std::array<Number, 3>;
using Matrix = std::vector<std::vector<Number>>;  // rows

inline Point posed(const Pose& pose, const Vec3& v) {
    Point point;
    for (int axis = 0; axis < 3; ++axis) {
        point[axis] = Number(pose.t[axis]);
        for (int k = 0; k < 3; ++k) point[axis] += Number(pose.R(axis, k)) * Number(v[k]);
    }
    return point;
}

// Brings the first `columns` columns to reduced row echelon form; returns their rank.
inline std::size_t eliminate(Matrix& m, std::size_t columns) {
    std::size_t rank = 0;
    for (std::size_t column = 0; column < columns && rank < m.size(); ++column) {
        std::size_t pivot = rank;
        while (pivot < m.size() && m[pivot][column] == 0) ++pivot;
        if (pivot == m.size()) continue;
        std::swap(m[pivot], m[rank]);
        const Number scale = m[rank][column];
        for (Number& x : m[rank]) x /= scale;
        for (std::size_t row = 0; row < m.size(); ++row) {
            if (row == rank || m[row][column] == 0) continue;
            const Number factor = m[row][column];
            for (std::size_t k = column; k < m[row].size(); ++k) m[row][k] -= factor * m[rank][k];
        }
        ++rank;
    }
    return rank;
}

inline bool is_coplanar(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
    Matrix differences;
    for (const auto* triangle : {&a, &b}) {
        for (const Point& p : *triangle) differences.push_back({p[0] - a[0][0], p[1] - a[0][1], p[2] - a[0][2]});
    }
    return eliminate(differences, 3) <= 2;
}

inline Relation relation(const std::array<Point, 3>& a, const std::array<Point, 3>& b) {
    bool is_feasible = false;
    std::array<bool, 6> is_positive_somewhere{};
    std::vector<unsigned> dependent;  // sets of columns; those that hold one of them are dependent, too
    for (unsigned subset = 1; subset < 64; ++subset) {
        const auto holds = [subset](unsigned other) { return (subset & other) == other; };
        if (std::any_of(dependent.begin(), dependent.end(), holds)) continue;
        std::vector<std::size_t> columns;
        for (std::size_t i = 0; i < 6; ++i) {
            if (subset >> i & 1U) columns.push_back(i);
        }
        Matrix system(5, std::vector<Number>(columns.size() + 1));
        for (std::size_t k = 0; k < columns.size(); ++k) {
            const bool first = columns[k] < 3;
            const Point& corner = first ? a[columns[k]] : b[columns[k] - 3];
            for (std::size_t axis = 0; axis < 3; ++axis) system[axis][k] = first ? corner[axis] : Number(-corner[axis]);
            system[first ? 3 : 4][k] = 1;
        }
        system[3].back() = system[4].back() = 1;
        const std::size_t rank = eliminate(system, columns.size());
        if (rank < columns.size()) {
            dependent.push_back(subset);
            continue;
        }
        bool is_vertex = true;
        for (std::size_t row = 0; row < 5 && is_vertex; ++row) {
            is_vertex = row < rank ? system[row].back() >= 0 : system[row].back() == 0;
        }
        if (!is_vertex) continue;
        is_feasible = true;
        for (std::size_t k = 0; k < rank; ++k) is_positive_somewhere[columns[k]] |= system[k].back() > 0;
    }
    if (!is_feasible) return Relation::apart;
    for (const bool positive : is_positive_somewhere) {
        if (!positive) return Relation::touching;
    }
    return is_coplanar(a, b) ? Relation::touching : Relation::crossing;
}

inline Relation relation(const Pose& pose_a, const std::array<Vec3, 3>& a, const Pose& pose_b,
                         const std::array<Vec3, 3>& b) {
    return relation({posed(pose_a, a[0]), posed(pose_a, a[1]), posed(pose_a, a[2])},
                    {posed(pose_b, b[0]), posed(pose_b, b[1]), posed(pose_b, b[2])});
}

}  // namespace ecods::oracle::model
