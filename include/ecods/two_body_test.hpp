// A two-body test answers questions about the caller's own shapes (World::set_test). (FCL, Coal:
// CollisionFunctionMatrix; Parry: QueryDispatcher; Bullet: btCollisionAlgorithm.)
//
// Example: verify/examples/own_shape.
#pragma once

#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/motion.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Answers questions about two shapes of one pair of kinds. A World calls a test only for candidate pairs, with the
// shape of the first kind first. Answers must depend on the shapes and poses alone: a verdict is kept while neither
// body changes. In `ask` a World always gives a memory, and the witness that the last call for the pair left, if it
// stores one; no answer may depend on them. A test that asks a World a question must pass this memory on: without a
// memory, the executor runs the question after the call that runs the test, so the test would wait for ever.
class ECODS_API TwoBodyTest {
  public:
    virtual ~TwoBodyTest() = default;

    // Returns true if the shapes share a point.
    virtual bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const = 0;

    // The following questions are optional: a test overrides those that it answers, and answers() returns true for
    // them. The others throw NotSupported, with the kinds and the question; a World that is asked one of them throws
    // it, too. If a World asks about many pairs (set_clearance, nearest, closest_pair, cast, meetings), it refuses a
    // test that does not answer before it asks any.
    virtual bool answers(Question question) const noexcept;  // by default: none

    // Returns apart exactly if intersects() is false.
    virtual Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Returns the pairs of triangles that share a point, ascending.
    virtual std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                             const Ask& ask) const;

    // Returns the distance, rounded once; 0 exactly if intersects() is true.
    virtual double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Returns true if the real distance is at most max_distance >= 0, so always if intersects() is true.
    virtual bool within(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance, const Ask& ask) const;

    virtual ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Answer as intersection.hpp and distance.hpp say.
    virtual std::vector<TriangleIntersection> intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                            const Ask& ask) const;
    virtual std::vector<CloseFeatures> close_features(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance,
                                                      const Ask& ask) const;

    // Return the first contact of a, translated by time times `motion`, with b; or of two shapes that each move from
    // one pose to another (cast.hpp). Return nullopt if the real time is above max_time, which is from 0 to 1. The time
    // is 0 exactly if intersects() is true at the start. If the shape that a World moves is of the second kind, `a` is
    // the other shape, moved by -motion.
    virtual std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b,
                                             double max_time, const Ask& ask) const;
    virtual std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                                    const Ask& ask) const;

    // Returns the first contact of two shapes that move in any way (turn.hpp), with max_time and times as above. A
    // World asks this if one turns, or is translated among bodies that move (meetings); a body at rest has the motion
    // Motion().
    virtual std::optional<FirstContact> cast_any_motion(const Posed<Shape>& a, const Motion& motion_of_a,
                                                        const Posed<Shape>& b, const Motion& motion_of_b,
                                                        double max_time, const Ask& ask) const;
};

}  // namespace ecods
