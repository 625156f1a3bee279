// SmallHulls poses two small convex sets in doubles, with a proven error bound: convex solids of few vertices, or
// meshes of one triangle (a point, a segment, a triangle). It compares their distance with a number, and guesses and
// partly proves which of their features are closest. Nothing is allocated, and poses may be singular.
//
// Points are relative to the translation of the first body's pose.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "exact/point/vectors.hpp"
#include "query/convex/gjk_rounds.hpp"
#include "query/convex/hull.hpp"
#include "query/convex/support_points.hpp"
#include "simd/inline.hpp"

namespace ecods::convex {

class SmallHull {
  public:
    static constexpr std::size_t vertices_max = 64;

    // Sets the hull to the posed shape, relative to `origin`. Returns false if the shape is neither a convex solid of
    // at most vertices_max vertices nor a mesh of one triangle, or if sizes are not ordinary. A triangle's corners must
    // be equal, (p, q, q), or all different.
    bool set(const Posed<MeshShape>& posed, const Vec3& origin) noexcept;

    // Returns the hull of a convex solid; null for a mesh of one triangle.
    const Hull* hull() const noexcept { return hull_; }
    const Posed<MeshShape>& posed() const noexcept { return *posed_; }
    std::uint32_t vertex_count() const noexcept { return vertex_count_; }
    // Returns vertex v as it stands in the mesh, not posed.
    const Vec3& vertex(std::uint32_t v) const noexcept;

    // Returns the posed vertex, rounded. Each coordinate is off by at most delta(), and at most size().
    ECODS_ALWAYS_INLINE exact::Point at(std::uint32_t v) const noexcept {
        const double* group =
            &groups_[v / SupportPoints::lanes * (3 * SupportPoints::lanes) + v % SupportPoints::lanes];
        return {group[0], group[SupportPoints::lanes], group[2 * SupportPoints::lanes]};
    }
    double delta() const noexcept { return delta_; }
    double size() const noexcept { return size_; }
    const exact::Point& center() const noexcept { return center_; }

    // The next functions are inlined into a caller that is compiled for the instruction set in use.
    void pose_vertices() noexcept;
    std::uint32_t support(const exact::Point& along) const noexcept;
    std::size_t count_not_below(const exact::Point& along, double least) const noexcept;

  private:
    bool set_solid(const SupportPoints& points) noexcept;
    bool set_triangle() noexcept;
    void set_bounds(const exact::Point& reach, double factor_max) noexcept;
    exact::Point pose(const exact::Point& v) const noexcept;

    const Posed<MeshShape>* posed_ = nullptr;
    const Hull* hull_ = nullptr;
    const double* unposed_ = nullptr;  // the groups of SupportPoints; null if the vertices are posed already
    std::uint32_t vertex_count_ = 0;
    std::uint32_t number_count_ = 0;  // numbers in groups_: groups of four vertices, as in SupportPoints
    std::array<exact::Point, 3> rows_;
    exact::Point offset_, center_;
    double delta_ = 0, size_ = 0;
    std::array<double, 3 * vertices_max> groups_;
};

// SmallFeatures holds a feature of each of two small hulls by its vertices: one for a vertex, two for an edge, three
// for a face.
struct SmallFeatures {
    std::array<std::array<std::uint32_t, 3>, 2> corners{};
    std::array<std::size_t, 2> count{};
};

class SmallHulls {
  public:
    SmallHulls(const Posed<MeshShape>& a, const Posed<MeshShape>& b) noexcept;

    // Returns false if a body is no small hull; then no other function may be called.
    bool are_small() const noexcept { return are_small_; }
    const SmallHull& operator[](std::size_t side) const noexcept { return hulls_[side]; }
    exact::Point rounded(std::size_t side, std::uint32_t v) const noexcept { return hulls_[side].at(v); }

    // Returns the sign of (distance of the sets) - `sum`, where `sum` may be off by 3 two_u of itself; nullopt if
    // doubles do not decide. Never returns 0.
    std::optional<int> compare(double sum) noexcept;

    // Returns the features that contain the closest points, as guessed in doubles; nullopt if there is no guess.
    // Continues from the result of compare().
    std::optional<SmallFeatures> guess_closest() noexcept;

    // Returns true if all vertices of a hull that are not in its feature are certainly behind it, along the direction
    // n, or along -n for the second hull. n is off by at most `error` on each axis, and the true direction is
    // perpendicular to the feature.
    bool are_others_behind(std::size_t side, const SmallFeatures& features, const exact::Point& n,
                           double error) const noexcept;

  private:
    void prepare() noexcept;
    int find_sign(double sum) noexcept;
    void find_nearest() noexcept;

    std::array<SmallHull, 2> hulls_;
    Simplex simplex_;  // the nearest to the origin so far
    bool are_small_;
};

}  // namespace ecods::convex
