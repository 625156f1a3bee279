// StraightMoves refuses the straight moves that rounded bodies have no cast of (rounded.hpp): one of two bodies has a
// radius, and one of them is not translated. A refusal follows from the bodies and their moves alone, not from which
// bodies come near each other, because boxes may differ between versions.
#pragma once

#include <compare>
#include <cstddef>
#include <map>

#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "world/two_body_tests.hpp"

namespace ecods {

class StraightMoves {
  public:
    // Adds to the moves a body that moves straight to the pose `end`, or stays at rest if `end` is null.
    void add(const Posed<Shape>& body, const Pose* end);

    // Returns true if a body was added that is not translated. Bodies that are no mesh and not rounded do not count.
    bool has_turning() const noexcept { return has_turning_; }

    // Throws NotSupported, with both kinds, if the library's test of two of the bodies has no cast of their moves.
    void require_casts(const TwoBodyTests& tests) const;

  private:
    // A Group stands for the bodies of a kind that all have a radius or none, and are all translated or not.
    struct Group {
        ShapeKind kind;
        bool has_radius, is_turning;

        friend auto operator<=>(const Group&, const Group&) = default;
    };

    std::map<Group, std::size_t> counts_;
    bool has_turning_ = false;
};

}  // namespace ecods
