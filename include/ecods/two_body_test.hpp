// The test of two bodies, for shapes of the caller's own (World::set_test).
//
// Example: verify/examples/own_shape.
#pragma once

#include <optional>
#include <vector>

#include "ecods/ask.hpp"
#include "ecods/export.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/results.hpp"
#include "ecods/shape.hpp"

namespace ecods {

// Answers questions about two shapes of one pair of kinds. A World calls it for candidate pairs only, with the shape of
// the first kind first. The answers must be functions of the shapes and poses: verdicts are kept while neither body
// changes. A World always gives the memory in `ask`, and the witness that the last call for the pair left where it
// keeps one; neither may change an answer.
class ECODS_API TwoBodyTest {
  public:
    virtual ~TwoBodyTest() = default;

    // Returns true if the shapes share a point.
    virtual bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const = 0;

    // Optional questions: a test overrides those that it answers, and says so by answers(). The others throw
    // NotSupported, with the kinds and the question, and so does World where it is asked one of them. Where World asks
    // of many pairs (set_clearance, nearest, closest_pair, cast, meetings), a test that does not answer is refused
    // before any is asked.
    virtual bool answers(Question question) const noexcept;  // the default: none of them

    // Returns apart exactly where intersects() is false.
    virtual Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Returns the pairs of triangles that share a point, ascending.
    virtual std::vector<TrianglePair> intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                             const Ask& ask) const;

    // Returns the distance, rounded once; 0 exactly where intersects() is true.
    virtual double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // Returns true if the real distance is at most max_distance >= 0, and wherever intersects() is true.
    virtual bool within(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance, const Ask& ask) const;

    virtual ClosestPoints closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const;

    // These answer as intersection.hpp and distance.hpp say.
    virtual std::vector<TriangleIntersection> intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                            const Ask& ask) const;
    virtual std::vector<CloseFeatures> close_features(const Posed<Shape>& a, const Posed<Shape>& b, double max_distance,
                                                      const Ask& ask) const;

    // Return the first contact of a, which is translated by time times `motion`, with b, and that of two shapes that
    // each go from one pose to another (cast.hpp); nothing if the real time is above max_time, which is from 0 to 1.
    // The time is 0 exactly where intersects() is true at the start. Where the shape that a World moves is of the
    // second kind, the other one is moved here by -motion.
    virtual std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b,
                                             double max_time, const Ask& ask) const;
    virtual std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                                    const Ask& ask) const;
};

}  // namespace ecods
