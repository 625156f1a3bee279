#include "programs/clash/make_shape.hpp"

#include <utility>

#include "ecods/convex_solid.hpp"
#include "ecods/error.hpp"
#include "ecods/solid.hpp"

namespace ecods::clash {
namespace {

std::shared_ptr<const MeshShape> make_convex(const std::shared_ptr<const Mesh>& mesh) {
    try {
        return std::make_shared<const ConvexSolid>(mesh);
    } catch (const NotConvex&) {
    } catch (const NoInterior&) {
    }
    return nullptr;
}

}  // namespace

MadeShape make_shape(const std::shared_ptr<const Mesh>& mesh, bool may_be_convex) {
    std::string reason;
    try {
        if (auto convex = may_be_convex ? make_convex(mesh) : nullptr) return {std::move(convex), ""};
        return {std::make_shared<const Solid>(mesh), ""};
    } catch (const NotClosed& error) {
        reason = error.what();
    } catch (const SelfIntersecting& error) {
        reason = error.what();
    }
    return {std::make_shared<const MeshShape>(mesh), reason};
}

}  // namespace ecods::clash
