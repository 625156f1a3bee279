#include "query/certificate/line_proof.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "base/arithmetic.hpp"
#include "base/assert.hpp"
#include "bvh/walks/tree_view.hpp"
#include "query/certificate/body_axis.hpp"

namespace ecods {
namespace {

using Kind = AxisFormula::Kind;

class LineProof {
  public:
    LineProof(const Posed<MeshShape>& body, const ecods::Segment& segment, const Parameter& end, ApartBy apart,
              Proof& proof)
        : body_(body, body.pose.t),
          apart_(apart),
          proof_(proof),
          from_(segment.a - body.pose.t),
          to_(segment.b - body.pose.t),
          parameter_(std::ldexp(static_cast<double>(end.m), end.e)),
          points_(body_.ref, segment, end),
          exact_from_(points_.on_segment(segment, {})),
          exact_to_(points_.on_segment(segment, end)) {}

    void run() {
        add_axes();
        const TreeView view(body_.tree);
        std::vector<TreeRef> stack;
        walk_one<LaneOrder::first_first>(
            view, stack, [&](TreeRef ref) { return view.with(ref, [&](const auto& x) { return open(x); }); },
            [&](TreeRef ref, std::uint32_t lanes) {
                for (; lanes != 0; lanes &= lanes - 1)
                    decide(view.leaf(ref).vertices[static_cast<std::size_t>(std::countr_zero(lanes))]);
                return true;
            });
    }

  private:
    struct Axis {
        Vec3 n;
        BodyAxis a;
        double low = 0, high = 0;  // interval of the segment's piece along n, enlarged by all errors
        bool is_bounded = false;
        Proof::Word named = Proof::no_axis;
    };

    Axis bind(const Vec3& n) const;
    void add_axes();
    template <class X>
    std::uint32_t open(const X& x);
    AxisFormula likely_axis(const Triangle& triangle) const;
    void decide(const Triangle& triangle);

    BodyFrame body_;
    ApartBy apart_;
    Proof& proof_;
    Vec3 from_, to_;  // the segment's ends relative to the body's translation, rounded
    double parameter_;
    ExactPoints points_;
    exact::LongVector exact_from_, exact_to_;
    std::vector<Axis> axes_;
};

// Projects the piece of the segment from `from` to from + s (to - from) onto n, s being `parameter_`. The second point
// has two products, each with the errors of a difference, of the rounded parameter and of a product, and two sums: with
// u' = 2^-52, it is off by less than 8 u' (|from| + |to|) on each axis. Products with n add 4 u'.
// Claim: verify/proofs/lines_and_times.py
LineProof::Axis LineProof::bind(const Vec3& n) const {
    Axis axis;
    axis.n = n;
    axis.a = put_on_axis(body_, n);
    const double from = n.dot(from_), to = n.dot(to_), end = from + parameter_ * (to - from);
    // The errors of from_ and to_ are relative to their own sizes, because each is one rounded difference.
    const double size = n.cwiseAbs().dot(from_.cwiseAbs() + to_.cwiseAbs());
    const double error = (axis.a.error + 32 * two_u * size) * (1 + 0x1p-20);
    axis.low = std::min(from, end) - error;
    axis.high = std::max(from, end) + error;
    axis.is_bounded = axis.a.is_bounded && size < 0x1p300;
    return axis;
}

void LineProof::add_axes() {
    const Mat3 normals = body_.normals();
    const Vec3 direction = to_ - from_;
    for (int k = 0; k < 3; ++k) axes_.push_back(bind(shortened(normals.col(k))));
    for (int k = 0; k < 3; ++k) axes_.push_back(bind(shortened(shortened(direction).cross(shortened(normals.col(k))))));
}

// Adds the opening of a node or leaf x of the body's tree to the proof. Returns the lanes of x that no axis proves
// apart from the piece.
template <class X>
std::uint32_t LineProof::open(const X& x) {
    std::uint32_t left = x.lanes();
    proof_.begin_opening();
    for (Axis& axis : axes_) {
        if (left == 0) break;
        if (!axis.is_bounded || axis.n == Vec3::Zero()) continue;
        Reaches<double> reaches;
        find_reaches(axis.a, x, reaches);
        std::uint32_t mask = 0;
        for (std::size_t i = 0; i < x.count; ++i) {
            if (reaches.high[i] < axis.low || reaches.low[i] > axis.high) mask |= 1u << i;
        }
        if ((mask & left) != 0 && proof_.name({.given = axis.n}, axis.named)) left &= ~mask;
    }
    std::array<Proof::Word, tree_width> parts;
    std::size_t count = 0;
    for (std::uint32_t rest = left; rest != 0; rest &= rest - 1)
        parts[count++] = static_cast<Proof::Word>(std::countr_zero(rest));
    proof_.end_opening(StepKind::open_a, {parts.data(), count});
    return left;
}

// Returns the formula whose axis has the widest gap in doubles. The formula is a guess, which integers must confirm.
// Trying all 32 formulas in integers would take most of the time of a proof.
AxisFormula LineProof::likely_axis(const Triangle& triangle) const {
    const std::array<Vec3, 3> corner{body_.at(triangle[0]), body_.at(triangle[1]), body_.at(triangle[2])};
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

void LineProof::decide(const Triangle& triangle) {
    SixCorners corners;
    for (std::size_t c = 0; c < 3; ++c) corners[c] = points_.vertex(0, triangle[c]);
    corners[3] = exact_from_;
    corners[4] = corners[5] = exact_to_;
    AxisFormula formula = likely_axis(triangle);
    if (!is_axis(formula, corners, apart_)) {
        const auto found = find_axis(corners, apart_);
        ECODS_ASSERT(found);
        formula = *found;
    }
    proof_.add_triangles(formula);
}

}  // namespace

void prove_line(const Posed<MeshShape>& body, const ecods::Segment& segment, const Parameter& end, ApartBy apart,
                Proof& proof) {
    LineProof(body, segment, end, apart, proof).run();
}

}  // namespace ecods
