// Searches for a short translation of the second of two solids that parts their interiors. Every result is confirmed by
// solid_relation(), or by depth() if both solids are convex and one is flat.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "ecods/results.hpp"
#include "ecods/solid.hpp"

namespace ecods::depths {

// A Parting is a translation for the pose of the second solid, and an upper bound of its distance from the pose's
// present translation.
struct Parting {
    Vec3 parted = Vec3::Zero();
    double length = std::numeric_limits<double>::infinity();
    // Holds a point near the last contact of the two solids while they are parted, if such a point is known.
    std::optional<Vec3> middle = {};
};

class PartingSearch {
  public:
    PartingSearch(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory);

    const Parting& best() const noexcept { return best_; }
    bool has_found() const noexcept { return best_.length < std::numeric_limits<double>::infinity(); }

    // Tries to part the solids by moving the second one along a unit vector, by `length` or a little more.
    void try_length(const Vec3& direction, double length);

    // Casts the second solid from outside towards the first one, along likely directions, up to the first contact. Then
    // casts it along the normals of the contacts found. Keeps the shortest parting in best().
    void search();

  private:
    struct Direction {
        Vec3 n;
        double reach;  // length of a translation along n after which the boxes are apart
    };

    void add_direction(const Vec3& n);
    double reach_along(const Vec3& n) const;
    std::optional<FirstContact> slide(const Direction& way);
    std::optional<FirstContact> slide_once(const Direction& way);
    std::optional<Vec3> contact_normal(const FirstContact& contact, const Vec3& along) const;
    Vec3 contact_point(const FirstContact& contact, const Vec3& parted) const;
    Vec3 corner(bool second, const FirstContact& contact, std::uint32_t i) const;
    bool confirm(const Vec3& parted);
    bool are_parted(const Posed<Solid>& moved) const;

    const Posed<Solid>& a_;
    const Posed<Solid>& b_;
    QueryMemory& memory_;
    std::array<Vec3, 2> centers_;  // centers of the meshes' posed boxes
    double way_min_;               // paths up to this length are not refined
    std::vector<Direction> directions_;
    Parting best_;
};

}  // namespace ecods::depths
