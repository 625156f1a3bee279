// Two posed meshes, made ready for exact questions about pairs of their triangles.
//
// Everything is relative to the translation of the first body: its points are R v, the second's are R v + (t - t0). The
// bounds then grow with the distance of the bodies from each other, not from the origin.
//
// Vertices are posed when a triangle that has them is reached, rounded for the filter and, if that leaves a question
// open, as integers. Both are kept in small caches of fixed size, so no query pays for the size of a mesh.
#pragma once

#include <cstdint>

#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/predicates.hpp"
#include "exact/number/limbs.hpp"
#include "exact/point/integer_width.hpp"
#include "exact/point/mesh_extent.hpp"
#include "exact/point/vertex_cache.hpp"
#include "exact/sign/filter.hpp"
#include "exact/sign/plain_signs.hpp"

namespace ecods::exact {

// Which stage decided how many pairs of triangles.
struct StageCounts {
    std::uint64_t triangle_tests = 0;
    std::uint64_t filter_passes = 0;
    std::uint64_t semi_static_passes = 0;
    std::uint64_t local_passes = 0;
    std::uint64_t one_limb = 0;
    std::uint64_t two_limbs = 0;
    std::uint64_t many_limbs = 0;
};

// One of the two bodies: the mesh, what is known of it, and its pose.
struct BodySide {
    const Mesh* mesh;
    const MeshExtent* extent;
    const Pose* pose;
};

class BodyPair {
  public:
    BodyPair();

    // Cost: constant. What the arguments refer to must outlive the questions.
    void bind(const BodySide& a, const BodySide& b);

    // The exact relation of triangle `a` of the first mesh and `b` of the second.
    Relation relation(std::uint32_t a, std::uint32_t b);

    const StageCounts& counts() const noexcept { return counts_; }
    void reset_counts() noexcept { counts_ = {}; }

  private:
    using OneLimbPoint = std::array<std::int64_t, 3>;
    using TwoLimbPoint = std::array<Int128, 3>;

    struct Side {
        BodySide body{};
        Vec3 offset = Vec3::Zero();  // fl(t - t0)
        VertexCache<Point> rounded;
        VertexCache<OneLimbPoint> one_limb;
        VertexCache<TwoLimbPoint> two_limbs;
    };

    // How wide the exact coordinates of all of the two bodies may be.
    enum class ExactState { not_prepared, one_limb_fits, two_limbs_fit, too_wide };

    void forget_points() noexcept;
    void pose(const Side& side, std::uint32_t vertex, Point& p) const;
    const Point& rounded_point(Side& side, std::uint32_t vertex);
    Relation decide(const Triangle& a, const Triangle& b, const SixRounded& points, FilterAnswer answer,
                    const FilterTrace& trace);
    TwoLimbPoint exact_point(const Side& side, std::uint32_t vertex) const;
    const OneLimbPoint& one_limb_point(Side& side, std::uint32_t vertex);
    const TwoLimbPoint& two_limb_point(Side& side, std::uint32_t vertex);
    void find_bounds();
    void prepare_exact();
    bool points_are_doubles(const BitRange& digits) const;
    bool are_short(const Vec3& unit) const;
    Vec3 common_unit(const std::array<DyadicDifference, 3>& offset) const;
    void count_in(const Vec3& unit);
    Relation decide_plainly(const SixRounded& points);
    Relation decide_by_differences(const SixRounded& points);
    Relation decide_open(const Triangle& a, const Triangle& b, const SixRounded& points, const FilterTrace& trace);
    template <class Use>
    Relation use_kernel(const Triangle& a, const Triangle& b, Use&& use);

    Side sides_[2];
    double delta_ = 0;         // error of a rounded coordinate
    double static_bound_ = 0;  // for all determinants of points of the two bodies
    Vec3 extent_ = Vec3::Zero();

    ExactState exact_state_ = ExactState::not_prepared;
    bool plain_is_exact_ = false;
    bool differences_are_exact_ = false;  // of rounded points; plain_is_exact_ is stronger
    bool is_counted_ = false;             // whether rounded points are divided by unit_
    Vec3 unit_ = Vec3::Ones();
    int exact_low_ = 0;            // exact points are multiples of 2^exact_low_
    double to_integers_ = 1;       // 2^-exact_low_, where differences are exact
    TwoLimbPoint exact_offset_{};  // t - t0 in these units

    StageCounts counts_;
};

}  // namespace ecods::exact
