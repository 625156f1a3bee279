// Answers exact queries about the distances of pairs of triangles of two posed meshes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ecods/distance.hpp"
#include "ecods/intersection.hpp"
#include "exact/measure/distance/closest_slab.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/point/frame.hpp"
#include "exact/point/integer_frame.hpp"
#include "geometry/feature_key.hpp"

namespace ecods {

// An interval that contains a distance. Pairs of triangles with the same closest features have the same distance, of
// which a search rounds one.
struct DistanceInterval {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();

    // True if the signs that determine the closest features are all certain: the distance is exactly that of features a
    // and b. They hold the only closest points of the two triangles, and are the features of lowest dimension that do.
    bool is_certain = false;
    ClosestKind kind = ClosestKind::intersecting;
    FeatureKey a, b;
};

class TriangleDistances {
  public:
    // Cost: constant. Everything that the arguments refer to must outlive this.
    void bind(const exact::BodyRef& a, const exact::BodyRef& b);

    // An interval that contains the distance of triangle `i` of the first mesh and `j` of the second, from doubles with
    // proven bounds. `lower` is 0 unless more is proven.
    DistanceInterval enclose(std::uint32_t i, std::uint32_t j);

    // The distance, rounded once; exactly 0 if and only if the triangles share a point.
    double distance(std::uint32_t i, std::uint32_t j);

    // The sign of (the real distance of a pair of triangles) - d, for a double d >= 0.
    int compare(std::uint32_t i, std::uint32_t j, double d);

    // The sign of (the real distance of the first pair) - (that of the second pair).
    int compare(const TrianglePair& first, const TrianglePair& second);

    // True if is_not_nearer can succeed: the coordinates fit into two limbs.
    bool can_refer() const noexcept { return points_.is_exact(); }
    // Sets the pair of triangles, which do not meet, that is_not_nearer compares with.
    void refer_to(const TrianglePair& pair);
    // True if the distance of `pair` is certainly not less than that of the pair given to refer_to. False proves
    // nothing. For pairs that may tie with that pair, or share its features, the answer is mostly true. Cost: some
    // nanoseconds, and 0.1 microseconds for each new vertex.
    bool is_not_nearer(const TrianglePair& pair);

    // The closest points of a pair of triangles, chosen by the rule of ClosestPoints.
    ClosestPoints closest(std::uint32_t i, std::uint32_t j);

    // Appends the pairs of features for which close_features() lists a pair of triangles. The first one is chosen by
    // the rule of ClosestPoints.
    void add_features(std::uint32_t i, std::uint32_t j, std::vector<FeatureNames>& to);
    // The distance, points and direction of two features of a pair of triangles, whichever triangles name them.
    CloseFeatures measure(const FeatureNames& features);

    // The common points of two triangles; without corners if there are none.
    SharedSet intersection(std::uint32_t i, std::uint32_t j);

  private:
    // The exact distance of a pair of triangles, kept for the next calls.
    struct Measured {
        TrianglePair pair;
        bool is_known = false;
        exact::SquaredDistance square;
        exact::FeaturePair features;  // features that hold closest points, unless the square is zero
    };

    exact::IntegerPair integers(std::uint32_t i, std::uint32_t j);
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
