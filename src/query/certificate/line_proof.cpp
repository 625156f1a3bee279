#include "query/certificate/line_proof.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "base/arithmetic.hpp"
#include "base/assert.hpp"

namespace ecods {
namespace {

double about(const Parameter& s) {
    return std::ldexp(static_cast<double>(s.m), s.e);
}

}  // namespace

LineProof::LineProof(const Posed<MeshShape>& body, const ecods::Segment& segment, const Parameter& end, ApartBy apart,
                     Proof& proof)
    : body_(body),
      tree_(MeshShapeAccess::tree(*body.what)),
      frame_(tree_.boxes, body.pose.R, Vec3::Zero()),
      apart_(apart),
      proof_(proof),
      from_(segment.a - body.pose.t),
      to_(segment.b - body.pose.t),
      parameter_(about(end)),
      points_({&body.what->mesh(), &tree_.extent, &body.pose}, segment, end),
      exact_from_(points_.on_segment(segment, {})),
      exact_to_(points_.on_segment(segment, end)) {}

// The piece ends at from + s (to - from): two products, each with the errors of a difference, a parameter that is
// rounded, and a product; and two sums. Below 8 u' (|from| + |to|) on each axis; products with n add 4 u'.
LineProof::Axis LineProof::bind(const Vec3& n) const {
    Axis axis;
    axis.n = n;
    axis.a = put_on_axis(frame_, n);
    const double from = n.dot(from_), to = n.dot(to_), end = from + parameter_ * (to - from);
    // How large the terms of from_ and to_ are does not matter: each is one rounded difference.
    const double size = n.cwiseAbs().dot(from_.cwiseAbs() + to_.cwiseAbs());
    const double error = (axis.a.error + 32 * two_u * size) * (1 + 0x1p-20);
    axis.low = std::min(from, end) - error;
    axis.high = std::max(from, end) + error;
    axis.is_bounded = axis.a.is_bounded && size < 0x1p300;
    return axis;
}

void LineProof::add_axes() {
    const Mat3 normals = box_normals(tree_.boxes.frame, body_.pose.R);
    const Vec3 direction = to_ - from_;
    for (int k = 0; k < 3; ++k) axes_.push_back(bind(shortened(normals.col(k))));
    for (int k = 0; k < 3; ++k) axes_.push_back(bind(shortened(shortened(direction).cross(shortened(normals.col(k))))));
}

// Chooses the axes of a step, and returns the parts that none of them proves.
template <class X>
std::uint32_t LineProof::open(const X& x) {
    std::uint32_t left = x.lanes();
    of_step_.clear();
    const auto use = [&](Axis& axis) {
        if (!axis.is_bounded || axis.n == Vec3::Zero()) return;
        Reaches reaches;
        find_reaches(axis.a, x, reaches);
        std::uint32_t mask = 0;
        for (std::size_t i = 0; i < x.count; ++i) {
            if (reaches.high[i] < axis.low || reaches.low[i] > axis.high) mask |= 1u << i;
        }
        if ((mask & left) == 0 || (axis.named == no_axis && proof_.axes.size() >= no_axis)) return;
        if (axis.named == no_axis) {
            axis.named = static_cast<Word>(proof_.axes.size());
            proof_.axes.push_back({.is_given = true, .given = axis.n});
        }
        of_step_.push_back(axis.named);
        left &= ~mask;
    };
    for (std::size_t k = 0; k < axes_.size() && left != 0; ++k) use(axes_[k]);
    return left;
}

void LineProof::visit(TreeRef top) {
    const auto with = [&](const auto& x) {
        const std::uint32_t left = open(x);
        std::vector<Word> parts;
        for (std::uint32_t rest = left; rest != 0; rest &= rest - 1)
            parts.push_back(static_cast<Word>(std::countr_zero(rest)));
        proof_.add_opening(StepKind::open_a, of_step_, parts);
        if constexpr (requires { x.child; }) {
            for (std::size_t k = parts.size(); k-- > 0;) stack_.push_back(x.child[parts[k]]);
        } else {
            for (const Word k : parts) decide(x.triangle[k]);
        }
    };
    top.is_leaf() ? with(tree_.boxes.leaves[top.index()]) : with(tree_.boxes.nodes[top.index()]);
}

// The formula along which the triangle and the piece seem to be furthest apart in doubles. It is only a guess, which
// integers confirm: trying the 32 formulas with them, one after the other, takes most of the time of a proof.
AxisFormula LineProof::likely_axis(const Triangle& triangle) const {
    std::array<Vec3, 3> corner;
    for (std::size_t c = 0; c < 3; ++c) corner[c] = body_.pose.R * body_.what->mesh().vertices()[triangle[c]];
    const Vec3 way = parameter_ * (to_ - from_);
    AxisFormula best{};
    double most = -std::numeric_limits<double>::infinity();
    const auto consider = [&](const AxisFormula& formula, const Vec3& n) {
        const double length = n.norm(), x = n.dot(corner[0]), y = n.dot(corner[1]), z = n.dot(corner[2]);
        const double from = n.dot(from_), to = from + n.dot(way);
        const double gap = std::max(std::min(from, to) - std::max({x, y, z}), std::min({x, y, z}) - std::max(from, to));
        if (!(gap > most * length) || length == 0) return;
        best = formula;
        most = gap / length;
    };
    using Kind = AxisFormula::Kind;
    consider({Kind::normal_a}, (corner[1] - corner[0]).cross(corner[2] - corner[1]));
    for (std::uint8_t i = 0; i < 3; ++i) {
        const Vec3 edge = corner[(i + 1u) % 3] - corner[i];
        consider({Kind::edges, i, 0}, edge.cross(way));
        for (std::uint8_t k = 0; k < 3; ++k) consider({Kind::edge_a, i, k}, edge.cross(Vec3::Unit(k)));
        consider({Kind::edge_b, 0, i}, way.cross(Vec3::Unit(i)));
        consider({Kind::coordinate, i}, Vec3::Unit(i));
    }
    return best;
}

void LineProof::decide(std::uint32_t triangle) {
    const Triangle& vertices = body_.what->mesh().triangles()[triangle];
    SixCorners corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = points_.vertex(0, vertices[c]);
    corners[3] = exact_from_;
    corners[4] = corners[5] = exact_to_;
    const AxisFormula likely = likely_axis(vertices);
    if (is_axis(likely, corners, apart_)) return proof_.add_triangles(likely);
    const auto formula = find_axis(corners, apart_);
    ECODS_ASSERT(formula);
    proof_.add_triangles(*formula);
}

void LineProof::run() {
    add_axes();
    stack_.assign(1, tree_.boxes.root);
    while (!stack_.empty()) {
        const TreeRef top = stack_.back();
        stack_.pop_back();
        visit(top);
    }
}

}  // namespace ecods
