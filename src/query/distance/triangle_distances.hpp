// TriangleDistances computes distances and closest points of pairs of triangles of two posed meshes, exactly.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "exact/measure/distance/closest_slab.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/distance/fixed_closest.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/point/frame.hpp"
#include "exact/point/integer_frame.hpp"
#include "geometry/feature_key.hpp"

namespace ecods {

// A DistanceInterval contains the distance of two triangles. Pairs with the same closest features have the same
// distance, so a search needs to round it for only one of them.
struct DistanceInterval {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();

    // `is_certain` is true if all signs that determine the closest features are certain. The distance is then exactly
    // the distance of features a and b. These two features contain the only closest points of the two triangles, and no
    // features of lower dimension contain them.
    bool is_certain = false;
    ClosestKind kind = ClosestKind::intersecting;
    FeatureKey a, b;
};

class TriangleDistances {
  public:
    // Binds the two meshes. Cost: constant. Everything that the arguments refer to must outlive this object.
    void bind(const exact::BodyRef& a, const exact::BodyRef& b);

    // Returns an interval, with bounds that doubles prove, that contains the distance of triangle `i` of the first mesh
    // and triangle `j` of the second. `lower` is 0 unless a greater bound is proven.
    DistanceInterval enclose(std::uint32_t i, std::uint32_t j);

    // Returns the distance of triangles i and j, rounded once. It is 0 exactly if they share a point.
    double distance(std::uint32_t i, std::uint32_t j);

    // Returns distance() of a pair, from numbers of fixed width; nullopt if the rounding is not certain, or the
    // interval is not. `interval` is the result of enclose() for the pair.
    std::optional<double> fixed_distance(const TrianglePair& pair, const DistanceInterval& interval);

    // Returns the sign of n . (p - q) for a point p, the first triangle, and a corner q and the normal n of the second.
    // The closest features must be the point and the face, which enclose() has found certain.
    int side_of_face(const TrianglePair& pair);

    // Returns the distance of a pair minus the margin, rounded once; 0 if it is negative (exact::round_beyond).
    double distance_beyond(const TrianglePair& pair, const exact::ExactSum& margin);
    // Returns the distance of a pair minus the margin, rounded once, also if it is negative
    // (exact::round_signed_beyond).
    double signed_beyond(const TrianglePair& pair, const exact::ExactSum& margin);

    // Return the sign of (the real distance of triangles i and j) - d, for a number d >= 0.
    int compare(std::uint32_t i, std::uint32_t j, double d);
    int compare(const TrianglePair& pair, const exact::ExactSum& d);

    // Returns the sign of (the real distance of the first pair) - (the real distance of the second pair).
    int compare(const TrianglePair& first, const TrianglePair& second);

    // Returns true if all coordinates fit into two limbs; otherwise is_not_nearer() always returns false.
    bool can_refer() const noexcept { return points_.is_exact(); }
    // Sets the pair of triangles with which is_not_nearer() compares others. The two triangles must not share a point.
    void refer_to(const TrianglePair& pair);
    // Returns true if `pair` is certainly at least as far apart as the pair given to refer_to(); false proves nothing.
    // If `pair` may have the same distance as the given pair, or shares features with that pair, the result is usually
    // true. Cost: some nanoseconds, and 0.1 microseconds for each new vertex.
    bool is_not_nearer(const TrianglePair& pair);

    // Returns the closest points of triangles i and j, chosen by the rule of ClosestPoints if there are several. If the
    // triangles do not meet and radii are given, points and distance are those of the rounded triangles. Sets point_a
    // only if it is `wanted`, since rounding it takes a third of the time; point_a may be left out only without radii.
    enum class PointA : std::uint8_t { wanted, left_out };
    ClosestPoints closest(std::uint32_t i, std::uint32_t j, const exact::Radii& radii = {},
                          PointA point_a = PointA::wanted);

    // Appends to `to` the pairs of features of triangles i and j that close_features() lists. The first appended pair
    // is the one that the rule of ClosestPoints chooses.
    void add_features(std::uint32_t i, std::uint32_t j, std::vector<FeatureNames>& to);
    // Returns the distance, points and direction of two features. The result does not depend on the triangles that name
    // them.
    CloseFeatures measure(const FeatureNames& features);

    // Returns the points that triangles i and j share; a set without corners if they share none.
    SharedSet intersection(std::uint32_t i, std::uint32_t j);

  private:
    // A Measured caches the exact distance of a pair of triangles for later calls.
    struct Measured {
        TrianglePair pair;
        bool is_known = false;
        exact::SquaredDistance square;
        exact::FeaturePair features;  // features with closest points; not set if the square is zero
    };

    exact::IntegerPair integers(std::uint32_t i, std::uint32_t j);
    // Returns the closest points of triangles i and j in fixed precision; nullopt unless doubles prove the closest
    // features.
    std::optional<exact::FixedClosest> find_fixed(std::uint32_t i, std::uint32_t j, const exact::Radii& radii);
    template <class Use>
    auto with_features(std::uint32_t i, std::uint32_t j, Use&& use);
    const Measured& measured(const TrianglePair& pair);
    exact::PointRef first_corner(std::uint32_t i) const noexcept;

    exact::IntegerFrame points_;
    std::array<const Triangle*, 2> triangles_{};
    exact::ClosestSlab slab_;
    std::array<Measured, 2> measured_;  // most recently used first
};

}  // namespace ecods
