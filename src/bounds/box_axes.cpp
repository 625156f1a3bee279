#include "bounds/box_axes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

#include "bounds/outward.hpp"

namespace ecods {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr float float_infinity = std::numeric_limits<float>::infinity();
constexpr double double_u = 0x1p-52;  // one operation, any rounding mode
constexpr double float_u = 0x1p-23;
constexpr double underflow = 0x1p-100;
constexpr double sum_max = 0x1p100;
constexpr double factor_max = 0x1p900;
constexpr double unit_distance_max = 0x1p-40;  // beyond, margins would suffer

// The root's box.
struct RootBox {
    Vec3 center, half;

    explicit RootBox(const WideTree& tree) {
        for (std::size_t k = 0; k < 3; ++k) {
            center[static_cast<Eigen::Index>(k)] = static_cast<double>(tree.root_center[k]);
            half[static_cast<Eigen::Index>(k)] = static_cast<double>(tree.root_half[k]);
        }
    }
};

// A tree's boxes in the world, with the sums that the bound is made of.
struct Edges {
    Mat3 edges;        // R map
    Vec3 size;         // |R| |map| 1
    Vec3 origin;       // R center
    Vec3 origin_size;  // |R| |center|
    double factor;     // the largest number that a rounding error of these is multiplied by

    Edges(const TreeFrame& frame, const Mat3& R) {
        const Mat3 R_size = R.cwiseAbs();
        edges = R * frame.map;
        size = R_size * frame.map_size;
        origin = R * frame.center;
        origin_size = R_size * frame.center.cwiseAbs();
        factor = std::max(1.0, R_size.maxCoeff()) * frame.size_max;
    }
};

// The normals of the faces as rows, of such length that the box is about [-1, 1] on each; the axes of the world where
// the box is too flat for that. Any choice is sound.
Mat3 axes_of(const Edges& own, const Edges& other) {
    const Vec3 x = own.edges.col(0), y = own.edges.col(1), z = own.edges.col(2);
    const Vec3 yz = y.cross(z);
    const double det = x.dot(yz);
    Mat3 axes;
    if (det * det > 0x1p-40 * (x.squaredNorm() * y.squaredNorm() * z.squaredNorm())) {
        const double factor = 1 / det;
        axes.row(0) = yz * factor;
        axes.row(1) = z.cross(x) * factor;
        axes.row(2) = x.cross(y) * factor;
        return axes;
    }
    const double size = std::max(own.edges.cwiseAbs().maxCoeff(), other.edges.cwiseAbs().maxCoeff());
    return Mat3::Identity() * (size > 0 ? 1 / size : 1.0);
}

// Everything about three axes that the roots need.
void set_exact(AxisSet& set, const Mat3& N, const Edges& a, const Edges& b, const Vec3& d) {
    const Mat3 N_size = N.cwiseAbs();
    set.exact_a = N * a.edges;
    set.exact_b = N * b.edges;
    set.exact_offset = N * ((b.origin - a.origin) + d);
    set.w = N_size * (((a.size + b.size) + (a.origin_size + b.origin_size)) + d.cwiseAbs());
    set.s = (set.exact_a.cwiseAbs() + set.exact_b.cwiseAbs()).rowwise().sum() + set.exact_offset.cwiseAbs();
    const double factor = std::max({a.factor, b.factor, d.cwiseAbs().maxCoeff()}) * N_size.maxCoeff();
    // Written so that NaN is not bounded.
    const bool is_bounded = set.s.maxCoeff() < sum_max && set.w.maxCoeff() < sum_max && factor < factor_max &&
                            set.s.sum() + set.w.sum() < 6 * sum_max;
    set.exact_margin = Vec3::Constant(infinity);
    if (is_bounded) set.exact_margin = 32 * double_u * (set.s + set.w) + Vec3::Constant(underflow);
}

Projection projection_of(const Mat3& P) {
    Projection result{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            const auto k = static_cast<std::size_t>(row), j = static_cast<std::size_t>(column);
            result.p[k][j] = static_cast<float>(P(row, column));
            result.size[k][j] = std::abs(result.p[k][j]);
        }
    }
    return result;
}

enum class Own { a, b };

// What nodes and leaves need, too. `own`: whose normals the axes are. The last factor makes up for the conversion of
// bounds.
void set_floats(AxisSet& set, Own own) {
    set.a = projection_of(set.exact_a);
    set.b = projection_of(set.exact_b);
    const Mat3& P = own == Own::a ? set.exact_a : set.exact_b;
    Vec3 e = (P - Mat3::Identity()).cwiseAbs().rowwise().sum();
    const bool is_unit = e.maxCoeff() <= unit_distance_max;
    (own == Own::a ? set.a : set.b).is_unit = is_unit;
    if (!is_unit) e.setZero();
    const bool is_bounded = set.exact_margin[0] < infinity;
    for (int row = 0; row < 3; ++row) {
        const auto k = static_cast<std::size_t>(row);
        const double in_float = float_u * set.s[row], in_double = 16 * double_u * set.w[row] + underflow;
        const double margin = (16 * in_float + in_double + 2 * e[row]) * (1 + 0x1p-22);
        const double point_error = (8 * in_float + in_double + e[row]) * (1 + 0x1p-22);
        set.b.margin[k] = is_bounded ? static_cast<float>(margin) : float_infinity;
        set.point_error[k] = is_bounded ? static_cast<float>(point_error) : float_infinity;
        set.b.shift[k] = static_cast<float>(set.exact_offset[row]);
    }
}

// Which of the three faces separates, or -1.
int separating_face(const AxisSet& set, const RootBox& a, const RootBox& b) {
    const Vec3 distance = (set.exact_a * a.center - set.exact_b * b.center - set.exact_offset).cwiseAbs();
    const Vec3 reach = set.exact_a.cwiseAbs() * a.half + set.exact_b.cwiseAbs() * b.half + set.exact_margin;
    for (int row = 0; row < 3; ++row) {
        if (distance[row] > reach[row]) return row;
    }
    return -1;
}

bool separates_on_edges(const AxisSet& set, int i, int j, const RootBox& a, const RootBox& b) {
    const Vec3 n = set.exact_a.col(i).cross(set.exact_b.col(j));
    const Vec3 on_a = set.exact_a.transpose() * n, on_b = set.exact_b.transpose() * n;
    const double distance = std::abs(on_a.dot(a.center) - on_b.dot(b.center) - n.dot(set.exact_offset));
    const double reach = on_a.cwiseAbs().dot(a.half) + on_b.cwiseAbs().dot(b.half);
    return distance > reach + (n.cwiseAbs().dot(set.exact_margin) + 0x1p-800);
}

}  // namespace

int BoxAxes::bind(const PosedTree& a, const PosedTree& b, const Vec3& d) {
    if (!a.tree.frame.is_bounded || !b.tree.frame.is_bounded) return bind_unbounded();
    const Edges edges_a(a.tree.frame, a.R), edges_b(b.tree.frame, b.R);
    const RootBox root_a(a.tree), root_b(b.tree);
    set_exact(sets_[0], axes_of(edges_a, edges_b), edges_a, edges_b, d);
    if (const int axis = separating_face(sets_[0], root_a, root_b); axis >= 0) return axis;
    set_exact(sets_[1], axes_of(edges_b, edges_a), edges_a, edges_b, d);
    if (const int axis = separating_face(sets_[1], root_a, root_b); axis >= 0) return 3 + axis;
    for (int i = 0; i < 9; ++i) {
        if (separates_on_edges(sets_[0], i / 3, i % 3, root_a, root_b)) return 6 + i;
    }
    set_floats(sets_[0], Own::a);
    set_floats(sets_[1], Own::b);
    return -1;
}

// Nothing is separated by what has no bounds.
int BoxAxes::bind_unbounded() {
    for (AxisSet& set : sets_) {
        set.a = set.b = {};
        set.b.margin.fill(float_infinity);
        set.point_error.fill(float_infinity);
    }
    return -1;
}

}  // namespace ecods
