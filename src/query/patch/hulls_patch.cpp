#include "query/patch/hulls_patch.hpp"

#include <optional>
#include <vector>

#include "base/assert.hpp"
#include "base/double_key.hpp"
#include "base/limits.hpp"
#include "exact/measure/round/distance_beyond.hpp"
#include "exact/point/posed_point.hpp"
#include "geometry/feature_key.hpp"
#include "query/convex/closest_hulls.hpp"
#include "query/convex/exact_hulls.hpp"
#include "query/depth/depth_memory.hpp"
#include "query/patch/facing.hpp"
#include "query/patch/fixed_corners.hpp"
#include "query/patch/patch_rounding.hpp"

namespace ecods::patches {
namespace {

using Kind = Feature::Kind;

class HullsPatch final : public Turn {
  public:
    HullsPatch(convex::PosedHulls& hulls, const exact::Radii& radii, const PatchLimits& limits)
        : hulls_(hulls), radii_(radii), limits_(limits) {}

    ContactPatch find(QueryMemory& memory, PairWitness& witness) {
        find_least(depths::DepthMemory::of(memory), witness);
        patch_.normal = least_.normal;
        fixed_ = FixedCorners::of(hulls_, least_, radii_);
        if (has_radius()) patch_.distance = distance_of_rounded();
        const bool is_flat = hulls_.hull(0).is_flat() || hulls_.hull(1).is_flat();
        if (is_flat || limits_.min_cos_squared < 1) set_normal();
        const HullFeaturePair facing{facing_part(0), facing_part(1)};
        if (facing == least_.parts) {
            use_least();
        } else {
            use_facing(facing);
        }
        return std::move(patch_);
    }

  private:
    // Sets least_ to the least difference of the hulls, and, if there are no radii, patch_.distance to their distance
    // or minus their depth. If the hulls may touch, tries find_deepest() first, because it is much faster than the
    // distance.
    void find_least(depths::DepthMemory& memory, PairWitness& witness) {
        const convex::QuickClosest quick = convex::find_quickly(hulls_, &witness);
        if (quick.may_touch(hulls_) && find_deepest(memory, witness)) return;
        if (const auto closest = convex::find_closest(hulls_, quick, &witness)) {
            least_ = least_of_closest(hulls_, *closest);
            if (!has_radius() || !least_.are_only) core_distance_ = round_distance(hulls_, closest->found);
            patch_.distance = core_distance_;
            return;
        }
        const bool is_found = find_deepest(memory, witness);
        ECODS_ASSERT(is_found);
        (void)is_found;
    }

    bool find_deepest(depths::DepthMemory& memory, PairWitness& witness) {
        const std::optional<depths::ExactDepth> found = depths::find_depth(hulls_, memory);
        if (!found) return false;
        least_ = depths::least_of(hulls_, *found);
        core_distance_ = found->depth;
        patch_.distance = opposite(found->depth);
        witness = {name(0, least_.parts[0]).triangle, name(1, least_.parts[1]).triangle};
        return true;
    }

    bool has_radius() const noexcept { return key_of(radii_.a) != 0 || key_of(radii_.b) != 0; }
    const Reach& reach() {
        if (!reach_) reach_.emplace(radii_);
        return *reach_;
    }
    Feature name(std::size_t side, const HullFeature& part) const noexcept { return name_of(hulls_.hull(side), part); }

    void set_normal() {
        if (has_normal_) return;
        normal_ = scaled_normal(hulls_, least_);
        has_normal_ = true;
    }

    double distance_of_rounded() {
        if (const auto distance = fixed_ ? fixed_->distance() : std::nullopt) return *distance;
        const exact::SquaredDistance square = square_of(hulls_, least_);
        return least_.is_depth ? opposite(exact::round_signed_beyond(square, -reach().sum))
                               : exact::round_signed_beyond(square, reach().sum);
    }

    HullFeature facing_part(std::size_t side) const {
        if (!(limits_.min_cos_squared < 1)) return least_.parts[side];
        return facing_feature({hulls_, side}, least_.parts[side], normal_, side == 1, limits_.min_cos_squared);
    }

    Polygons polygons_of(const HullFeaturePair& parts) const {
        return {polygon_of({hulls_, 0}, parts[0], normal_, false), polygon_of({hulls_, 1}, parts[1], normal_, true)};
    }

    // Returns true if pair x is before pair y in the order of ClosestPoints.
    bool is_before(const HullFeaturePair& x, const HullFeaturePair& y) const {
        const auto names = [&](const HullFeaturePair& pair) {
            const auto count = [&](std::size_t side) { return static_cast<std::size_t>(pair[side].kind) + 1; };
            const exact::FeaturePair features = exact::features_of_counts(count(0), count(1));
            return FeatureNames{static_cast<ClosestKind>(features.kind), name(0, pair[0]), name(1, pair[1])};
        };
        return rank(names(x)) < rank(names(y));
    }

    // Computes the corners of the patch of the support features, whose gaps are all equal.
    void use_least() {
        if (is_gap_too_large()) return;
        convex::list_least(hulls_, least_, core_distance_, fixed_ ? fixed_->way() : std::nullopt, pairs_);
        std::size_t first = 0;
        for (std::size_t i = 1; i < pairs_.size(); ++i) {
            if (is_before(pairs_[i], pairs_[first])) first = i;
        }
        const Polygons polygons = polygons_of(least_.parts);
        polygons_ = &polygons;
        order_around(polygons, first, pairs_, *this);
        patch_.corners.reserve(pairs_.size());
        for (const HullFeaturePair& pair : pairs_) {
            PatchCorner& corner = add(pair);
            corner.gap = patch_.distance;
            if (fixed_ && fixed_->round(pair, corner)) continue;
            if (has_radius()) set_normal();
            round_least(hulls_, pair, reach(), normal_, corner);
        }
        keep_corners(patch_, limits_.max_corners, LeastCorners(*this));
    }

    // LeastCorners computes the exact position of a corner of the least difference when the position is needed, as a
    // point of either body: the order and the areas of the corners, seen along the normal, are the same on both bodies.
    class LeastCorners final : public ExactCorners {
      public:
        explicit LeastCorners(HullsPatch& of) noexcept : of_(of) {}
        LongPoint point(std::size_t i) const override {
            const HullFeaturePair& pair = of_.pairs_[i];
            for (const std::size_t side : {0, 1}) {
                if (pair[side].kind != Kind::vertex) continue;
                const exact::PointRef vertex = of_.hulls_.reference({side, pair[side].index});
                return {exact::posed_point(*vertex.pose, *vertex.v), ScaledInteger(1.0)};
            }
            of_.set_normal();
            const Polygons edges{Polygon(of_.hulls_.hull(0), pair[0], false),
                                 Polygon(of_.hulls_.hull(1), pair[1], false)};
            return SeenAlong(of_.hulls_, edges, of_.normal_).corner(pair).at[0];
        }
        ScaledLongVector normal() const override {
            of_.set_normal();
            return of_.normal_.n;
        }

      private:
        HullsPatch& of_;
    };

    // Returns true if the gap exceeds max_gap. Rounding is monotonic, so the rounded gap decides unless it equals the
    // limit.
    bool is_gap_too_large() {
        const std::int64_t gap = key_of(patch_.distance), limit = key_of(limits_.max_gap);
        if (gap != limit || limit == infinity_key) return gap > limit;
        const exact::ExactSum cores = reach().sum.plus(limits_.max_gap);
        const exact::SquaredDistance square = square_of(hulls_, least_);
        if (!least_.is_depth) return cores.sign() < 0 || exact::compare(square, cores) > 0;
        return cores.sign() < 0 && exact::compare(square, -cores) < 0;
    }

    // Returns the sign of the turn between two edges that cross, each in the direction of its polygon. The cross
    // product of the edges is parallel to the normal.
    int of(const HullFeaturePair& edges) const override {
        std::array<convex::HullVertex, 6> vertices;
        for (const std::size_t side : {0, 1}) {
            const Polygon& polygon = (*polygons_)[side];
            const std::size_t i = polygon.index_of(edges[side]);
            vertices[3 * side] = {side, polygon.corners[i].vertex};
            vertices[3 * side + 1] = vertices[3 * side + 2] = {side, polygon.corners[polygon.next(i)].vertex};
        }
        Eigen::Index most = 0;
        least_.normal.cwiseAbs().maxCoeff(&most);
        return with_exact_features(hulls_, vertices,
                                   [&]<int L>(const auto&, const exact::ExactFeatures<L>& features, const auto&) {
                                       const auto n = features.normal(exact::features_of_counts(2, 2));
                                       const int sign = exact::sign<2 * L>(n[static_cast<std::size_t>(most)]);
                                       return least_.normal[most] < 0 ? -sign : sign;
                                   });
    }

    // Computes the corners of the patch of two features that face the normal within the tilt; each corner has a gap of
    // its own.
    void use_facing(const HullFeaturePair& facing) {
        const Polygons polygons = polygons_of(facing);
        SeenAlong seen(hulls_, polygons, normal_);
        seen.list(pairs_);
        std::size_t first = 0;
        LongCorner least = seen.corner(pairs_[0]);
        for (std::size_t i = 1; i < pairs_.size(); ++i) {
            LongCorner other = seen.corner(pairs_[i]);
            const int more = compare(other.num * least.den, least.num * other.den);
            if (more > 0 || (more == 0 && is_before(pairs_[first], pairs_[i]))) continue;
            first = i;
            least = std::move(other);
        }
        order_around(polygons, first, pairs_, seen);
        std::vector<LongPoint> points;
        const bool is_limited = key_of(limits_.max_gap) != infinity_key;
        for (const HullFeaturePair& pair : pairs_) {
            const LongCorner exact = seen.corner(pair);
            if (is_limited && compare_gap(exact, reach(), normal_, limits_.max_gap) > 0) continue;
            round_corner(exact, reach(), normal_, add(pair));
            points.push_back(exact.at[0]);
        }
        keep_corners(patch_, limits_.max_corners, ListedCorners(points, normal_.n));
    }

    PatchCorner& add(const HullFeaturePair& pair) {
        PatchCorner& corner = patch_.corners.emplace_back();
        corner.a = name(0, pair[0]);
        corner.b = name(1, pair[1]);
        return corner;
    }

    convex::PosedHulls& hulls_;
    const exact::Radii radii_;
    std::optional<Reach> reach_;  // made when it is needed
    const PatchLimits& limits_;
    convex::LeastDifference least_;
    double core_distance_ = 0;  // distance of the cores, or their depth
    std::optional<FixedCorners> fixed_;
    ExactNormal normal_;  // set by set_normal()
    bool has_normal_ = false;
    convex::LeastPairs pairs_;
    const Polygons* polygons_ = nullptr;  // the polygons of least_.parts
    ContactPatch patch_;
};

}  // namespace

void keep_corners(ContactPatch& patch, std::uint32_t max_corners, const ExactCorners& exact) {
    patch.corner_count = static_cast<std::uint32_t>(patch.corners.size());
    if (max_corners == 0 || patch.corners.size() <= max_corners) return;
    std::vector<Vec3> points;
    for (const PatchCorner& corner : patch.corners) points.push_back(corner.point_a);
    std::size_t kept = 0;
    for (const std::size_t i : choose_corners(points, patch.normal, exact, max_corners))
        patch.corners[kept++] = patch.corners[i];
    patch.corners.resize(kept);
}

ContactPatch patch_of_hulls(convex::PosedHulls& hulls, const exact::Radii& radii, const PatchLimits& limits,
                            QueryMemory& memory, PairWitness& witness) {
    return HullsPatch(hulls, radii, limits).find(memory, witness);
}

}  // namespace ecods::patches
