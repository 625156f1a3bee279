// Bodies of all kinds, meshes, solids, rounded bodies and half spaces, and how far two of them are from each other, by
// the oracle.
#pragma once

#include <memory>

#include "ecods/shape.hpp"
#include "ecods/world.hpp"
#include "oracle/oracle.hpp"
#include "oracle/rounded.hpp"

namespace ecods::judge {

// A body of a world. Its pose must be regular, and a solid have no triangles without an area.
struct MixedBody {
    BodyId id;
    std::shared_ptr<const Shape> shape;
    Pose pose;
    CollisionFilter filter;

    bool is_half_space() const { return shape->kind() == ShapeKind::half_space(); }
    bool is_convex() const { return dynamic_cast<const ConvexSolid*>(shape.get()) != nullptr; }
    bool is_rounded() const;
    // True if it has a depth with a rounded body that has one.
    bool has_depth() const { return core().form() == MeshForm::convex || core().mesh().triangles().size() == 1; }
    const MeshShape& core() const;
    double radius() const;
    oracle::Soup soup() const { return {core().mesh().vertices(), core().mesh().triangles(), pose}; }
};

// The distance that ClosestPair promises: it is signed for two convex bodies, and for a half space and another body.
class MixedDistance {
  public:
    MixedDistance(const MixedBody& a, const MixedBody& b);

    double nearest() const;       // rounded once, at least 2^-1074 in magnitude unless it is 0
    int compare(double d) const;  // the sign of the real number less d

  private:
    oracle::FractionAndRoot number_;
};

}  // namespace ecods::judge
