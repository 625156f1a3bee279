// What a proof needs of two triangles: the axis of their closest features, or of their contact.
#include "base/double_key.hpp"
#include "query/certificate/closest_axis.hpp"
#include "query/certificate/pair_proof.hpp"

namespace ecods {
namespace {

using Kind = AxisFormula::Kind;

constexpr std::size_t contacts_max = 8;

}  // namespace

// From the one triangle to the other where they are closest, about; zero where that is not clear.
Vec3 PairProof::direction_of(std::uint32_t i, std::uint32_t j) {
    const DistanceInterval interval = pair_.enclose(i, j);
    if (!interval.is_certain) return Vec3::Zero();
    return shortened(direction_along(formula_of(interval, a_, i, b_, j), a_, i, b_, j));
}

SixCorners PairProof::corners_of(std::uint32_t i, std::uint32_t j) {
    if (!points_) {
        points_.emplace(exact::BodyRef{&a_.what->mesh(), &tree_a_.extent, &a_.pose},
                        exact::BodyRef{&b_.what->mesh(), &tree_b_.extent, &b_.pose});
    }
    SixCorners corners;
    for (std::size_t c = 0; c < 3; ++c) {
        corners[c] = points_->vertex(0, a_.what->mesh().triangles()[i][c]);
        corners[3 + c] = points_->vertex(1, b_.what->mesh().triangles()[j][c]);
    }
    return corners;
}

// Along which two triangles are apart as far as they can be; nothing where the walk ends.
std::optional<AxisFormula> PairProof::formula_for(std::uint32_t i, std::uint32_t j) {
    const DistanceInterval interval = pair_.enclose(i, j);
    if (interval.is_certain && key_of(interval.lower) > 0) return formula_of(interval, a_, i, b_, j);
    const ClosestPoints closest = pair_.closest(i, j);
    if (closest.kind != ClosestKind::intersecting) return formula_of(closest);
    if (ends_at_ == EndsAt::meeting) return std::nullopt;
    return find_axis(corners_of(i, j), ApartBy::weakly);
}

// Two triangles that no axis of their parts' proves to be apart. Returns false if the walk ends here.
bool PairProof::decide(std::uint32_t i, std::uint32_t j) {
    const auto formula = formula_for(i, j);
    if (!formula) {
        found_ = TrianglePair{i, j};
        return false;
    }
    proof_.add_triangles(*formula);
    return true;
}

// Has the axis of two triangles tried exactly from now on. Returns false if there is none more.
bool PairProof::add_contact(const AxisFormula& formula, std::uint32_t i, std::uint32_t j) {
    // Of ties at a vertex each pair of triangles has a line of its own.
    const bool is_axis =
        formula.kind == Kind::normal_a || formula.kind == Kind::normal_b || formula.kind == Kind::edges;
    if (contacts_.size() == contacts_max || !is_axis) return false;
    const SixCorners corners = corners_of(i, j);
    const std::array<ContactAxis::Body, 2> bodies{ContactAxis::Body{&tree_a_.boxes, &a_.what->mesh(), &frame_a_},
                                                  ContactAxis::Body{&tree_b_.boxes, &b_.what->mesh(), &frame_b_}};
    const ProofAxis named{.is_given = false, .formula = formula, .a = i, .b = j};
    contacts_.push_back({ContactAxis(named, corners, *points_, bodies, frame_b_.origin - frame_a_.origin), no_axis});
    return true;
}

}  // namespace ecods
