// A short translation of the second of two solids that parts their interiors: solid_relation() has confirmed it.
#pragma once

#include <array>
#include <limits>
#include <optional>
#include <vector>

#include "ecods/first_contact.hpp"
#include "ecods/solid.hpp"

namespace ecods::depths {

// A translation for the pose of the second solid, and an upper bound of how far that is from the one it has.
struct Parting {
    Vec3 parted = Vec3::Zero();
    double length = std::numeric_limits<double>::infinity();
    // About in the middle of what the solids have in common there where they touch last, if that is known.
    std::optional<Vec3> middle = {};
};

class PartingSearch {
  public:
    PartingSearch(const Posed<Solid>& a, const Posed<Solid>& b, QueryMemory& memory);

    const Parting& best() const noexcept { return best_; }
    bool has_found() const noexcept { return best_.length < std::numeric_limits<double>::infinity(); }

    // Takes the second solid out along the direction by a length, or a little more.
    void try_length(const Vec3& direction, double length);

    // Comes in from outside, against likely directions, up to the first contact, and from there turns to the normals of
    // such contacts.
    void search();

  private:
    struct Direction {
        Vec3 n;
        double reach;  // how far out the boxes are apart
    };

    void add_direction(const Vec3& n);
    double reach_along(const Vec3& n) const;
    std::optional<FirstContact> slide(const Direction& way);
    std::optional<FirstContact> slide_once(const Direction& way);
    std::optional<Vec3> contact_normal(const FirstContact& contact, const Vec3& along) const;
    Vec3 contact_point(const FirstContact& contact, const Vec3& parted) const;
    Vec3 corner(bool second, const FirstContact& contact, std::uint32_t i) const;
    bool confirm(const Vec3& parted);

    const Posed<Solid>& a_;
    const Posed<Solid>& b_;
    QueryMemory& memory_;
    std::array<Vec3, 2> centers_;  // of the posed boxes of the meshes
    double way_min_;               // shorter ones are not made shorter
    std::vector<Direction> directions_;
    Parting best_;
};

}  // namespace ecods::depths
