// FixedClosest computes the closest points of two features in fixed precision, about as fast as in doubles. It returns
// nullopt where this precision does not decide; its other answers are those of exact arithmetic.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "exact/measure/distance/closest_on_segments.hpp"
#include "exact/measure/round/fixed_vector.hpp"
#include "exact/measure/round/rounded_ends.hpp"
#include "exact/measure/round/scaled_vector.hpp"

namespace ecods::exact {

// A PosedFeature refers to a feature of a posed body by its vertices: one for a vertex, two for an edge, three of a
// face.
struct PosedFeature {
    const Pose* pose;
    std::array<const Vec3*, 3> corners;
    std::size_t count;
};

class FixedClosest {
  public:
    // A Foot is what is known of the foot of a vertex: `in_face` if it is known to be in the face; `in_triangle` if
    // of_features() must prove that it is in the triangle of the face's three corners.
    enum class Foot : std::uint8_t { in_triangle, in_face };

    // Names holds the kind and the names of the two features that contain the closest points.
    struct Names {
        ClosestKind kind = ClosestKind::vertex_vertex;
        Feature a, b;
    };

    // Returns the closest points of the features; nullopt unless fixed precision proves that exactly one pair of points
    // is closest, in the interiors of both features. The features are two vertices, two edges, or a vertex and any
    // feature. If the foot is known to be in a face, it must also be in the parallelogram of the first corner and the
    // two others. Sets the kind in the result's names.
    static std::optional<FixedClosest> of_features(const std::array<PosedFeature, 2>& features, const Radii& radii,
                                                   Names names, Foot foot = Foot::in_triangle) noexcept;

    // Returns the closest points of two bodies whose cores overlap by the vector between the points. Radii then move
    // the points away from each other, and are added to the distance, which is a depth.
    FixedClosest inverted() const noexcept;

    FixedClosest(const ClosestOnSegments& at, const FixedVector& w, int unit, const Radii& radii,
                 const Names& names) noexcept
        : at_(at), w_(w), unit_(unit), radii_(radii), names_(names) {}

    // Returns the distance of the features minus both radii, rounded once, also if it is negative. This function and
    // the next ones return nullopt if a rounding is not certain.
    std::optional<double> signed_distance() const noexcept;
    std::optional<ClosestPoints> signed_closest() const noexcept;
    // Returns adjacent doubles around the distance of the rounded bodies, or the distance twice if it is a double.
    std::optional<DistanceBounds> distance_bounds() const noexcept;
    // Returns the unit vector from the first feature's closest point to the second's.
    std::optional<Vec3> direction() const noexcept;
    // Returns the middle of the two closest points, unless they are inverted().
    std::optional<Vec3> middle() const noexcept;

    // Returns true if the features have no other pair of closest points.
    bool is_only() const noexcept { return at_.is_only; }
    const Names& names() const noexcept { return names_; }

    // Returns the vector from the first closest point to the second; its coordinates are off by at most errors().
    IntegerVector between() const noexcept { return difference(at_.point[1], at_.point[0]); }
    ErrorBounds errors() const noexcept {
        const auto& [x, y] = at_.errors;
        return {x[0] + y[0], x[1] + y[1], x[2] + y[2]};
    }

  private:
    // A Gap is a number in units of 2^unit, with an error bound.
    struct Gap {
        FixedNumber number;
        int unit;
    };
    Gap gap() const noexcept;  // the distance of the features less both radii

    ClosestOnSegments at_;
    FixedVector w_;
    int unit_;
    bool is_inverted_ = false;
    Radii radii_;
    Names names_;
};

}  // namespace ecods::exact
