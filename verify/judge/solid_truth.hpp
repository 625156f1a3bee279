// Everything that include/ecods/solid.hpp answers about two posed solids, judged by the oracle.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ecods/solid.hpp"
#include "judge/distance_truth.hpp"
#include "oracle/solid.hpp"

namespace ecods::judge {

// As the library writes it.
Location to_location(const oracle::PointLocation& exact);

// What is to be said of (b, a) if this is said of (a, b).
Relation mirrored(Relation relation);

std::string text(const Location& location);

// Asks the questions whose answers a relation decides in part: those that say if the bodies share a point. Without and
// with a witness.
std::optional<Wrong> ask_of_common_points(const Posed<MeshShape>& a, const Posed<MeshShape>& b, Relation relation,
                                          QueryMemory& memory);

// What is true of two solids, and of points in both, known before the library is asked: it may be asked in any
// floating-point environment. Beside the points that are given these are some corners of either solid and points of its
// edges, as doubles have them.
class SolidTruth {
  public:
    SolidTruth(const Posed<Solid>& a, const Posed<Solid>& b, std::span<const Vec3> points = {});

    Relation relation() const { return relation_; }
    Relation surface_relation() const { return surfaces_[0]; }  // of a's surface to b
    std::size_t on_count() const;                               // of all points, in both

    // The same, to be asked of other solids of the same meshes.
    SolidTruth with(const Posed<Solid>& a, const Posed<Solid>& b) const;

    // Asks all of it, in both orders.
    std::optional<Wrong> ask(QueryMemory& memory) const;

  private:
    struct Located {
        Vec3 point;
        Location expected[2];
    };
    void add(const Vec3& point);
    void add_points_of(const Posed<Solid>& solid);

    Posed<Solid> solids_[2];
    Relation relation_ = Relation::apart;
    Relation surfaces_[2] = {};
    std::vector<Located> points_;
};

// Whether the mesh bounds a solid, and why not: check_solid and self_intersections beside the oracle.
std::optional<Wrong> ask_whether_solid(const Mesh& mesh);

}  // namespace ecods::judge
