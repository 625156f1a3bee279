// PosedHulls prepares two posed convex solids for questions about the pair: support points by searches in doubles,
// rounded points with a proven error bound, and exact points.
//
// All points are relative to the translation of the first solid's pose. Rounded points are in units of 2^exponent().
// The exponent is chosen so that at least one of the solids is neither tiny nor immense, and nothing overflows:
// coordinates are below 2^110. No cost is proportional to the size of a mesh, with one exception: a search scans all
// vertices of a hull of up to `scanned_max` vertices.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "ecods/primitives.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "exact/measure/distance/measure_pair.hpp"
#include "exact/measure/round/scaled_vector.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/vectors.hpp"
#include "query/convex/convex_memory.hpp"
#include "query/convex/convex_parts.hpp"
#include "query/convex/furthest.hpp"
#include "simd/inline.hpp"

namespace ecods::convex {

using exact::Point;

// A HullVertex refers to a vertex of the hull of the first solid (side 0) or of the second (side 1).
struct HullVertex {
    std::size_t side;
    std::uint32_t vertex;
};

// Returns the rows of a pose's R, with each entry replaced by scale(entry).
template <class Scale>
std::array<Point, 3> rows_of(const Pose& pose, const Scale& scale) {
    std::array<Point, 3> rows;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k)
            rows[row][k] = scale(pose.R(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)));
    }
    return rows;
}

// Returns the exact sign of the determinant of a pose's R. `rows` must be the rows of R times a power of two.
Sign orientation(const std::array<Point, 3>& rows, const Pose& pose);

class PosedHulls {
  public:
    // Throws SingularPose. Everything that the arguments refer to must outlive this object. Cost: constant, some tens
    // of nanoseconds.
    PosedHulls(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);

    const Hull& hull(std::size_t side) const noexcept { return *bodies_[side].hull; }
    const Mesh& mesh(std::size_t side) const noexcept { return bodies_[side].solid->mesh(); }
    // Returns true if the pose reflects the solid. The cycles of faces, which are counterclockwise in the mesh, are
    // then clockwise.
    bool is_mirrored(std::size_t side) const noexcept { return bodies_[side].is_mirrored; }

    // Returns the posed vertex, rounded. Each coordinate is off by at most delta().
    ECODS_ALWAYS_INLINE Point rounded(std::size_t side, std::uint32_t vertex) const noexcept {
        return pose(bodies_[side], bodies_[side].points->at(vertex));
    }
    double delta() const noexcept { return delta_; }
    // Returns the posed center of the box around a solid's vertices, rounded.
    Point center(std::size_t side) const noexcept { return pose(bodies_[side], bodies_[side].points->center); }
    // Returns an upper bound of the difference, on any axis, of any two rounded points of one solid.
    double size(std::size_t side) const noexcept { return bodies_[side].size; }
    int exponent() const noexcept { return exponent_; }

    // Returns a support vertex along a direction, in doubles. It is at least as far as `start`; if the hull is scanned,
    // it is at least as far as every other vertex. If the direction is not finite, returns any vertex.
    std::uint32_t support(std::size_t side, const Point& direction, std::uint32_t start) const noexcept;
    // Returns a support vertex along a direction, for callers without a start vertex.
    std::uint32_t support(std::size_t side, const Point& direction) const noexcept;
    // Hulls of up to this many vertices are scanned. In larger hulls a search climbs over edges.
    static constexpr std::size_t scanned_max = 96;
    bool is_scanned(std::size_t side) const noexcept { return bodies_[side].points->vertex_count <= scanned_max; }
    // Returns the support vertex of a scanned hull along `direction`, inlined into a caller that is compiled for the
    // instruction set in use.
    ECODS_ALWAYS_INLINE std::uint32_t scan(std::size_t side, const Point& direction) const noexcept {
        const Body& body = bodies_[side];
        const std::vector<double>& groups = body.points->groups;
        return std::min(last_vertex(body), furthest(groups.data(), groups.size(), in_mesh(body, direction)));
    }

    // Heights are the dot products of vertices with n, computed in the mesh's coordinates. If n is off by at most
    // `error` on each axis, a vertex whose height exceeds another's by more than `margin` is certainly further.
    // Requires delta() of at least 2^-200.
    struct Heights {
        const SupportPoints* points;
        Point along;
        double margin;

        double of(std::uint32_t vertex) const noexcept { return exact::dot(along, points->at(vertex)); }
    };
    Heights heights(std::size_t side, const Point& n, double error) const noexcept;
    // Appends to `list`, ascending, the vertices that may be extreme along n by their heights. The hull must be a
    // scanned one.
    static void list_furthest(const Heights& heights, std::vector<std::uint32_t>& list);

    // Returns true if all vertices of a solid other than `corners` are proven to be behind the corners, along the
    // direction that n approximates within `error` on each axis. The direction must be perpendicular to all edges among
    // the corners, and delta() at least 2^-200. Returns false if the hull is not scanned.
    bool are_others_behind(std::size_t side, const Point& n, double error,
                           std::span<const std::uint32_t> corners) const noexcept;

    // Returns the vertices of a triangle of the mesh, which a witness names. A corner that is no vertex of the hull is
    // replaced by another vertex. If the triangle does not exist, returns the same vertex three times.
    std::array<std::uint32_t, 3> vertices_near(std::size_t side, std::uint32_t triangle) const noexcept;

    // Calls `use` with the vertices' exact points as IntegerPoints<Kernel, N>, in the narrowest kernel that holds them,
    // and returns its result. Points are relative to the first one, in the unit of IntegerPoints. Cost: 0.1
    // microseconds on first use, then some tens of nanoseconds; more if the points' digits do not fit into two limbs.
    template <std::size_t N, class Use>
    auto with_integers(const std::array<HullVertex, N>& vertices, Use&& use);
    // Returns true if exact points fit into two limbs. If it is true, fixed() returns the exact points in units of
    // 2^fixed_unit().
    bool has_fixed_points();
    const exact::IntegerVector& fixed(const HullVertex& v) noexcept {
        return memory_.points.at(v.side, mesh_vertex(v));
    }
    int fixed_unit() const noexcept { return memory_.points.unit(); }
    // Returns an exponent such that fixed() points are below 2^fixed_high(). Call it after has_fixed_points().
    int fixed_high() const noexcept { return memory_.points.digits().high + 3; }

    // Integers holds points of up to three vertices of each solid as integers, in units of 2^unit. They are short
    // integers if their digits fit. Unless are_exact, the difference of two coordinates is off by less than 5 units.
    struct Integers {
        std::array<std::array<exact::IntegerVector, 3>, 2> at;
        int unit;
        bool are_exact;
    };
    Integers integers(const std::array<std::span<const std::uint32_t>, 2>& vertices);
    // Returns the solid in the form that exact questions take.
    exact::BodyRef body(std::size_t side) const;
    // Returns a reference to the vertex, in the form in which round_point() takes the origin of relative points.
    exact::PointRef reference(const HullVertex& v) const noexcept {
        return {bodies_[v.side].at, &mesh(v.side).vertices()[mesh_vertex(v)]};
    }

  private:
    struct Body {
        const ConvexSolid* solid;
        const Pose* at;
        const Hull* hull;
        const SupportPoints* points;
        std::array<Point, 3>
            rows;      // rows of R, times the power of two with which they map mesh points to rounded points
        Point offset;  // t - t0
        double size;
        bool is_mirrored;
    };

    ECODS_ALWAYS_INLINE static Point pose(const Body& body, const Point& v) noexcept {
        Point p;
        for (std::size_t k = 0; k < 3; ++k) {
            const Point& r = body.rows[k];
            p[k] = ((r[0] * v[0] + r[1] * v[1]) + r[2] * v[2]) + body.offset[k];
        }
        return p;
    }

    // Returns a direction in the mesh's coordinates: R^T direction.
    ECODS_ALWAYS_INLINE static Point in_mesh(const Body& body, const Point& direction) noexcept {
        Point along;
        for (std::size_t k = 0; k < 3; ++k) {
            along[k] =
                (body.rows[0][k] * direction[0] + body.rows[1][k] * direction[1]) + body.rows[2][k] * direction[2];
        }
        return along;
    }
    // Returns the index of the last vertex. Copies of it pad the SIMD groups, so a search clamps the index that it
    // finds to this one.
    static std::uint32_t last_vertex(const Body& body) noexcept { return body.points->vertex_count - 1; }
    std::uint32_t mesh_vertex(const HullVertex& v) const noexcept {
        return bodies_[v.side].hull->mesh_vertices[v.vertex];
    }
    bool scale_plainly() noexcept;
    void scale_any() noexcept;
    void find_bounds() noexcept;
    void find_orientation(std::size_t side);
    static std::uint32_t climb(const Body& body, const Point& along, std::uint32_t start) noexcept;
    void bind_exact();
    bool find_short(const std::array<std::span<const std::uint32_t>, 2>& vertices, Integers& result) const noexcept;

    std::array<Body, 2> bodies_;
    ConvexMemory& memory_;
    double delta_ = 0;
    int exponent_ = 0;
    bool is_bound_ = false;  // true if memory_.points is bound to this pair
};

template <std::size_t N, class Use>
auto PosedHulls::with_integers(const std::array<HullVertex, N>& vertices, Use&& use) {
    if (!is_bound_) bind_exact();
    std::array<exact::VertexRef, N> of_meshes;
    for (std::size_t i = 0; i < N; ++i) of_meshes[i] = {vertices[i].side, mesh_vertex(vertices[i])};
    return memory_.points.with_integers(of_meshes, use);
}

}  // namespace ecods::convex
