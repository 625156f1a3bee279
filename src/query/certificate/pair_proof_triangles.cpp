// Finds an axis that proves two triangles apart: the line between their closest features, or, if they touch, an axis
// that separates them weakly.
#include <algorithm>

#include "base/double_key.hpp"
#include "query/certificate/pair_proof.hpp"

namespace ecods {
namespace {

using Kind = AxisFormula::Kind;

constexpr std::size_t contacts_max = 8;

// Returns the corner of the triangle at which the vertex is, or the edge begins; 0 for a face.
std::uint8_t corner_of(const FeatureKey& feature, std::uint32_t triangle, const Triangle& corners) {
    return static_cast<std::uint8_t>(feature_of(feature, triangle, corners).corner);
}

// Returns the axis between the closest features of two triangles that do not meet. The gap along this axis is their
// distance. `i` and `j` are the corners that name the features of a and b.
AxisFormula formula_between(ClosestKind kind, bool a_is_vertex, std::uint8_t i, std::uint8_t j) {
    switch (kind) {
        case ClosestKind::vertex_vertex:
            return {Kind::vertices, i, j};
        case ClosestKind::vertex_edge:
            return a_is_vertex ? AxisFormula{Kind::vertex_a_edge, i, j} : AxisFormula{Kind::vertex_b_edge, j, i};
        case ClosestKind::vertex_face:
            return {a_is_vertex ? Kind::normal_b : Kind::normal_a};
        default:
            return {Kind::edges, i, j};
    }
}

}  // namespace

// Returns the axis between the closest features in `interval`. Call it only if the interval is certain and its lower
// bound is positive.
AxisFormula PairProof::formula_of(const DistanceInterval& interval, std::uint32_t i, std::uint32_t j) const {
    return formula_between(interval.kind, interval.a.is_vertex(), corner_of(interval.a, i, bodies_[0].triangle(i)),
                           corner_of(interval.b, j, bodies_[1].triangle(j)));
}

// Returns the rounded direction from the closest point of triangle i to the closest point of triangle j; zero if the
// closest features are not certain.
Vec3 PairProof::direction_of(std::uint32_t i, std::uint32_t j) {
    const DistanceInterval interval = pair_.enclose(i, j);
    if (!interval.is_certain) return Vec3::Zero();
    Corners<Vec3> corners;
    for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = bodies_[0].at(bodies_[0].triangle(i)[c]);
        corners[3 + c] = bodies_[1].at(bodies_[1].triangle(j)[c]);
    }
    return shortened(vector_of(formula_of(interval, i, j), corners));
}

SixCorners PairProof::corners_of(std::uint32_t i, std::uint32_t j) {
    if (!points_) points_.emplace(bodies_[0].ref, bodies_[1].ref);
    SixCorners corners;
    for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = points_->vertex(0, bodies_[0].triangle(i)[c]);
        corners[3 + c] = points_->vertex(1, bodies_[1].triangle(j)[c]);
    }
    return corners;
}

// Returns the axis along which two triangles have their widest gap. If they share a point, the result depends on
// `ends_at_`: for meeting, nullopt; for crossing, an axis that separates them weakly, or nullopt if they cross.
std::optional<AxisFormula> PairProof::formula_for(std::uint32_t i, std::uint32_t j) {
    const DistanceInterval interval = pair_.enclose(i, j);
    if (interval.is_certain && key_of(interval.lower) > 0) return formula_of(interval, i, j);
    const ClosestPoints closest = pair_.closest(i, j);
    if (closest.kind != ClosestKind::intersecting) {
        return formula_between(closest.kind, closest.a.kind == Feature::Kind::vertex,
                               static_cast<std::uint8_t>(closest.a.corner),
                               static_cast<std::uint8_t>(closest.b.corner));
    }
    if (ends_at_ == EndsAt::meeting) return std::nullopt;
    return find_axis(corners_of(i, j), ApartBy::weakly);
}

// Adds the axis of triangles i and j to the axes that are tried exactly. Returns false, with nothing added, if the list
// is full or the formula involves a vertex.
bool PairProof::add_contact(const AxisFormula& formula, std::uint32_t i, std::uint32_t j) {
    // Formulas that involve a vertex are left out, because each pair of triangles that ties at a vertex needs an axis
    // of its own.
    const bool is_axis =
        formula.kind == Kind::normal_a || formula.kind == Kind::normal_b || formula.kind == Kind::edges;
    if (contacts_.size() == contacts_max || !is_axis) return false;
    const SixCorners corners = corners_of(i, j);
    const ProofAxis axis{.is_given = false, .formula = formula, .a = i, .b = j};
    contacts_.push_back(ContactAxis(axis, corners, *points_, bodies_));
    return true;
}

}  // namespace ecods
