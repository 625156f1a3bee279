// Implements the hits of a MeshShape by the functions for a posed body.
#include "ecods/hit.hpp"
#include "ecods/shape.hpp"

namespace ecods {

std::vector<Hit> MeshShape::all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const {
    return ecods::all_hits(segment, Posed<MeshShape>(*this, pose), ask);
}
std::vector<Hit> MeshShape::all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const {
    return ecods::all_hits(ray, Posed<MeshShape>(*this, pose), ask);
}
std::optional<Hit> MeshShape::first_hit(const Segment& segment, const Pose& pose, const Ask& ask) const {
    return ecods::first_hit(segment, Posed<MeshShape>(*this, pose), ask);
}
std::optional<Hit> MeshShape::first_hit(const Ray& ray, const Pose& pose, const Ask& ask) const {
    return ecods::first_hit(ray, Posed<MeshShape>(*this, pose), ask);
}

}  // namespace ecods
