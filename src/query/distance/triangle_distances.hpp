// Two posed meshes, ready for questions about the distances of pairs of their triangles.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "exact/measure/distance/closest_slab.hpp"
#include "exact/measure/distance/enclose_distance.hpp"
#include "exact/measure/distance/feature_pair.hpp"
#include "exact/measure/round/squared_distance.hpp"
#include "exact/point/frame.hpp"
#include "exact/point/integer_frame.hpp"
#include "geometry/feature_key.hpp"

namespace ecods {

// Contains a distance. Pairs of triangles whose closest features are the same have the same distance: a search rounds
// one of them.
struct DistanceInterval {
    double lower = 0;
    double upper = std::numeric_limits<double>::infinity();

    // Where this is set, all signs that say so are certain: the distance is exactly that of these two features, which
    // hold the only closest points of the two triangles and are the features of lowest dimension that do.
    bool is_certain = false;
    ClosestKind kind = ClosestKind::intersecting;
    FeatureKey a, b;
};

class TriangleDistances {
  public:
    // Cost: constant. Everything that the arguments refer to must outlive the questions.
    void bind(const exact::BodyRef& a, const exact::BodyRef& b);

    // Contains the distance of triangle `i` of the first mesh and `j` of the second, by doubles with proven bounds.
    // `lower` is 0 where it is not proven to be more.
    DistanceInterval enclose(std::uint32_t i, std::uint32_t j);

    // The distance, rounded once; 0 exactly if the triangles share a point.
    double distance(std::uint32_t i, std::uint32_t j);

    // The sign of the real distance of a pair of triangles less the double d >= 0.
    int compare(std::uint32_t i, std::uint32_t j, double d);

    // The sign of the real distance of the first pair of triangles less that of the second.
    int compare(const TrianglePair& first, const TrianglePair& second);

    // Whether is_not_nearer can say anything: where coordinates fit into two limbs.
    bool can_refer() const noexcept { return points_.is_exact(); }
    // Remembers a pair of triangles that do not meet, for is_not_nearer.
    void refer_to(const TrianglePair& pair);
    // Whether it is certain that the distance of a pair is not less than that of the one referred to. Exact where it
    // says so, and says nothing otherwise: asked of pairs that may tie with it, or share its features, it mostly says
    // so. Cost: some nanoseconds, and 0.1 microseconds for each vertex that was not asked about before.
    bool is_not_nearer(const TrianglePair& pair);

    // The closest points of a pair of triangles, by the rule of ClosestPoints.
    ClosestPoints closest(std::uint32_t i, std::uint32_t j);

    // Adds the pairs of features with which a pair of triangles counts in close_features(), the first by the rule of
    // ClosestPoints first.
    void add_features(std::uint32_t i, std::uint32_t j, std::vector<FeatureNames>& to);
    // What features of one of these pairs are to each other, whichever triangles name them.
    CloseFeatures measure(const FeatureNames& features);

    // No corners if the triangles share no point.
    SharedSet intersection(std::uint32_t i, std::uint32_t j);

  private:
    // The exact distance of a pair of triangles that was asked about lately.
    struct Measured {
        TrianglePair pair;
        bool is_known = false;
        exact::SquaredDistance square;
        exact::FeaturePair features;  // that hold closest points, unless the square is zero
    };

    exact::IntegerPair integers(std::uint32_t i, std::uint32_t j);
    template <class Use>
    auto with_features(std::uint32_t i, std::uint32_t j, Use&& use);
    const Measured& measured(const TrianglePair& pair);
    exact::PointRef first_corner(std::uint32_t i) const noexcept;

    exact::IntegerFrame points_;
    std::array<const Triangle*, 2> triangles_{};
    exact::ClosestSlab slab_;
    std::array<Measured, 2> measured_;  // the one that was asked about last comes first
};

}  // namespace ecods
