// Defines the default functions of Shape and TwoBodyTest: derived classes need not override the optional ones.
#include <optional>
#include <vector>

#include "ecods/error.hpp"
#include "ecods/shape.hpp"

namespace ecods {
namespace {

std::optional<Hit> first_of(const std::vector<Hit>& hits) {
    return hits.empty() ? std::nullopt : std::optional(hits.front());
}

}  // namespace

// ---- shapes

bool Shape::answers(Question /*question*/) const noexcept {
    return false;
}

std::vector<Hit> Shape::all_hits(const Segment& /*segment*/, const Pose& /*pose*/, const Ask& /*ask*/) const {
    throw NotSupported(Question::hits, kind(), kind());
}
std::vector<Hit> Shape::all_hits(const Ray& /*ray*/, const Pose& /*pose*/, const Ask& /*ask*/) const {
    throw NotSupported(Question::hits, kind(), kind());
}
std::optional<Hit> Shape::first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const {
    return first_of(all_hits(segment, pose, ask));
}
std::optional<Hit> Shape::first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const {
    return first_of(all_hits(ray, pose, ask));
}

// ---- tests of two bodies

bool TwoBodyTest::answers(Question /*question*/) const noexcept {
    return false;
}

Relation TwoBodyTest::relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& /*ask*/) const {
    throw NotSupported(Question::relation, a.what->kind(), b.what->kind());
}

std::vector<TrianglePair> TwoBodyTest::intersecting_triangles(const Posed<Shape>& a, const Posed<Shape>& b,
                                                              const Ask& /*ask*/) const {
    throw NotSupported(Question::intersecting_triangles, a.what->kind(), b.what->kind());
}

double TwoBodyTest::distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& /*ask*/) const {
    throw NotSupported(Question::distance, a.what->kind(), b.what->kind());
}

bool TwoBodyTest::within(const Posed<Shape>& a, const Posed<Shape>& b, double /*max_distance*/,
                         const Ask& /*ask*/) const {
    throw NotSupported(Question::within, a.what->kind(), b.what->kind());
}

ClosestPoints TwoBodyTest::closest(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& /*ask*/) const {
    throw NotSupported(Question::closest, a.what->kind(), b.what->kind());
}

std::vector<TriangleIntersection> TwoBodyTest::intersections(const Posed<Shape>& a, const Posed<Shape>& b,
                                                             const Ask& /*ask*/) const {
    throw NotSupported(Question::intersections, a.what->kind(), b.what->kind());
}

std::vector<CloseFeatures> TwoBodyTest::close_features(const Posed<Shape>& a, const Posed<Shape>& b,
                                                       double /*max_distance*/, const Ask& /*ask*/) const {
    throw NotSupported(Question::close_features, a.what->kind(), b.what->kind());
}

std::optional<FirstContact> TwoBodyTest::cast(const Posed<Shape>& a, const Vec3& /*motion*/, const Posed<Shape>& b,
                                              double /*max_time*/, const Ask& /*ask*/) const {
    throw NotSupported(Question::cast, a.what->kind(), b.what->kind());
}

std::optional<FirstContact> TwoBodyTest::cast_any_motion(const Posed<Shape>& a, const Motion& /*motion_of_a*/,
                                                         const Posed<Shape>& b, const Motion& /*motion_of_b*/,
                                                         double /*max_time*/, const Ask& /*ask*/) const {
    throw NotSupported(Question::cast_any_motion, a.what->kind(), b.what->kind());
}

std::optional<FirstContact> TwoBodyTest::cast_moving(const Moving<Shape>& a, const Moving<Shape>& b,
                                                     double /*max_time*/, const Ask& /*ask*/) const {
    throw NotSupported(Question::cast_moving, a.what->kind(), b.what->kind());
}

}  // namespace ecods
