// PairQuestion computes the distance and the closest points of two bodies of a world. The distance is signed where
// ClosestPair says so.
#pragma once

#include <optional>

#include "ecods/results.hpp"
#include "world/bodies.hpp"
#include "world/two_body_tests.hpp"

namespace ecods {

class PairQuestion {
  public:
    PairQuestion(const Bodies& bodies, const TwoBodyTests& tests, ProxyPair pair)
        : ids_(bodies.ids_of(pair)),
          a_(bodies[pair.a].posed()),
          b_(bodies[pair.b].posed()),
          test_(tests.find(bodies[pair.a].kind, bodies[pair.b].kind)) {}

    // Returns true if the distance is signed, as ClosestPair says.
    bool is_signed() const;

    // Returns true if the real distance is at most max_distance, which is at least 0; infinity is allowed.
    bool is_within(double max_distance, const Ask& ask) const;
    // Returns is_within(max_distance, ask), but tries `axis` first and may store another axis in `axis`, as
    // convex::within() does.
    bool is_within(double max_distance, const Ask& ask, Vec3& axis) const;

    // Return the distance alone, or all members of ClosestPair.
    double distance(const Ask& ask) const;
    ClosestPair find(const Ask& ask) const;

  private:
    std::optional<ClosestPair> find_signed(const Ask& ask) const;

    BodyPair ids_;
    Posed<Shape> a_, b_;
    OrderedTest test_;
};

}  // namespace ecods
