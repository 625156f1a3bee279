#include "programs/clash/make_shape.hpp"

#include <utility>

#include "ecods/error.hpp"
#include "ecods/shape.hpp"

namespace ecods::clash {
namespace {

// Returns null where the mesh bounds a solid that is not convex; throws where it bounds none.
std::shared_ptr<const MeshShape> make_convex(const std::shared_ptr<const Mesh>& mesh) {
    try {
        return std::make_shared<const ConvexSolid>(mesh);
    } catch (const NotSolid& error) {
        if (error.reason != NotSolid::Reason::dent) throw;
    }
    return nullptr;
}

}  // namespace

MadeShape make_shape(const std::shared_ptr<const Mesh>& mesh, bool may_be_convex) {
    try {
        if (auto convex = may_be_convex ? make_convex(mesh) : nullptr) return {std::move(convex), ""};
        return {std::make_shared<const Solid>(mesh), ""};
    } catch (const NotSolid& error) {
        return {std::make_shared<const MeshShape>(mesh), error.what()};
    }
}

}  // namespace ecods::clash
