// Two convex solids at their poses, ready for questions about the pair: support points by searches in doubles, rounded
// points with a proven bound, and exact points.
//
// All points are relative to the translation of the first solid's pose. Rounded points are counted in a power of two,
// 2^exponent(), in which at least one of the two solids is neither tiny nor immense, and nothing overflows:
// coordinates are below 2^110. Nothing here is proportional to the size of a mesh, but for hulls of up to
// `scanned_max` vertices, which a search scans as a whole.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "ecods/convex_solid.hpp"
#include "ecods/predicates.hpp"
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

// A vertex of the hull of the first (0) or the second (1) solid.
struct HullVertex {
    std::size_t side;
    std::uint32_t vertex;
};

// The rows of a pose's R, each entry as `scale` makes it.
template <class Scale>
std::array<Point, 3> rows_of(const Pose& pose, const Scale& scale) {
    std::array<Point, 3> rows;
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t k = 0; k < 3; ++k)
            rows[row][k] = scale(pose.R(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(k)));
    }
    return rows;
}

// The sign of the determinant of a pose's R, of which `rows` are rows times a power of two; decided exactly.
Sign orientation(const std::array<Point, 3>& rows, const Pose& pose);

class PosedHulls {
  public:
    // Throws SingularPose. Everything that the arguments refer to must outlive this. Cost: constant, some dozens of
    // nanoseconds.
    PosedHulls(const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b, QueryMemory& memory);

    const Hull& hull(std::size_t side) const noexcept { return *bodies_[side].hull; }
    const Mesh& mesh(std::size_t side) const noexcept { return bodies_[side].solid->mesh(); }
    // Whether the pose reflects: then faces, whose cycles are counterclockwise in the mesh, are clockwise.
    bool is_mirrored(std::size_t side) const noexcept { return bodies_[side].is_mirrored; }

    // The point of a vertex, rounded: each coordinate is off by at most delta().
    ECODS_ALWAYS_INLINE Point rounded(std::size_t side, std::uint32_t vertex) const noexcept {
        return pose(bodies_[side], bodies_[side].points->at(vertex));
    }
    double delta() const noexcept { return delta_; }
    // About the middle of a solid.
    Point center(std::size_t side) const noexcept { return pose(bodies_[side], bodies_[side].points->center); }
    // No difference of two rounded points of one solid is larger on any axis.
    double size(std::size_t side) const noexcept { return bodies_[side].size; }
    int exponent() const noexcept { return exponent_; }

    // A vertex that is about the furthest along a direction: certainly no worse than `start`, as doubles see it, and
    // of small hulls than all others. Any direction may be asked for; one that is not finite gives any vertex.
    std::uint32_t support(std::size_t side, const Point& direction, std::uint32_t start) const noexcept;
    // A vertex that is about the furthest along a direction, where nothing is known of it.
    std::uint32_t support(std::size_t side, const Point& direction) const noexcept;
    // Up to here all vertices are looked at.
    static constexpr std::size_t scanned_max = 96;
    bool is_scanned(std::size_t side) const noexcept { return bodies_[side].points->vertex_count <= scanned_max; }
    // support() of what is scanned, for callers that are compiled for the instruction set in use.
    ECODS_ALWAYS_INLINE std::uint32_t scan(std::size_t side, const Point& direction) const noexcept {
        const Body& body = bodies_[side];
        const std::vector<double>& groups = body.points->groups;
        return std::min(last_vertex(body), furthest(groups.data(), groups.size(), in_mesh(body, direction)));
    }

    // Products of vertices with n, in the mesh's coordinates; where n is off by `error` on each axis, one vertex is
    // certainly further than another where it is by more than `margin`. Only where delta() is at least 2^-200.
    struct Heights {
        const SupportPoints* points;
        Point along;
        double margin;

        double of(std::uint32_t vertex) const noexcept { return exact::dot(along, points->at(vertex)); }
    };
    Heights heights(std::size_t side, const Point& n, double error) const noexcept;
    // Lists, ascending, the vertices that may be the furthest by these. Not of what is not scanned.
    static void list_furthest(const Heights& heights, std::vector<std::uint32_t>& list);

    // Whether it is proven that all vertices of a solid are behind some corners of it, but for these: along a direction
    // at right angles to all edges among the corners, of which n is off by `error` on each axis. Only where delta() is
    // at least 2^-200; not of what is not scanned.
    bool are_others_behind(std::size_t side, const Point& n, double error,
                           std::span<const std::uint32_t> corners) const noexcept;

    // The vertices of a triangle of the mesh, for a witness that may come from anywhere: corners that are no vertices
    // of the hull, or of a triangle that does not exist, are other vertices.
    std::array<std::uint32_t, 3> vertices_near(std::size_t side, std::uint32_t triangle) const noexcept;

    // Calls `use` with the vertices' points as IntegerPoints<Kernel, N> of the narrowest kernel that holds them, and
    // returns its result: they are exact, counted from the first of them, and in units that it says. Cost: 0.1
    // microseconds when it is asked first, then some dozens of nanoseconds; more where the points' digits do not fit
    // into two limbs.
    template <std::size_t N, class Use>
    auto with_integers(const std::array<HullVertex, N>& vertices, Use&& use);
    // Whether exact points fit into two limbs, and these points: in units of 2^fixed_unit().
    bool has_fixed_points();
    const exact::IntegerVector& fixed(const HullVertex& v) noexcept {
        return memory_.points.at(v.side, mesh_vertex(v));
    }
    int fixed_unit() const noexcept { return memory_.points.unit(); }

    // Points of up to three vertices of each solid as integers, short ones where their digits fit, in units of 2^unit;
    // differences of two coordinates are off by less than 5 units if they are not exact.
    struct Integers {
        std::array<std::array<exact::IntegerVector, 3>, 2> at;
        int unit;
        bool are_exact;
    };
    Integers integers(const std::array<std::span<const std::uint32_t>, 2>& vertices);
    // A solid as all exact questions take a body.
    exact::BodyRef body(std::size_t side) const;
    // By reference, as round_point takes the point that others are counted from.
    exact::PointRef reference(const HullVertex& v) const noexcept {
        return {bodies_[v.side].at, &mesh(v.side).vertices()[mesh_vertex(v)]};
    }

  private:
    struct Body {
        const ConvexSolid* solid;
        const Pose* at;
        const Hull* hull;
        const SupportPoints* points;
        std::array<Point, 3> rows;  // of R, times the power of two that takes points to rounded ones
        Point offset;               // t - t0
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

    // A direction as the mesh's coordinates see it.
    ECODS_ALWAYS_INLINE static Point in_mesh(const Body& body, const Point& direction) noexcept {
        Point along;
        for (std::size_t k = 0; k < 3; ++k) {
            along[k] =
                (body.rows[0][k] * direction[0] + body.rows[1][k] * direction[1]) + body.rows[2][k] * direction[2];
        }
        return along;
    }
    // What fills up the last groups counts as this vertex.
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
    bool is_bound_ = false;  // whether memory_.points is of this pair
};

template <std::size_t N, class Use>
auto PosedHulls::with_integers(const std::array<HullVertex, N>& vertices, Use&& use) {
    if (!is_bound_) bind_exact();
    std::array<exact::VertexRef, N> of_meshes;
    for (std::size_t i = 0; i < N; ++i) of_meshes[i] = {vertices[i].side, mesh_vertex(vertices[i])};
    return memory_.points.with_integers(of_meshes, use);
}

}  // namespace ecods::convex
