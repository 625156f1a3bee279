#include <limits>

#include "base/double_key.hpp"
#include "geometry/find_invalid.hpp"
#include "query/intersection/asking.hpp"
#include "world/least.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Returns the mesh of a subject or a body. Throws NotSupported if its shape is not a mesh.
Posed<MeshShape> mesh_at(const Posed<Shape>& posed) {
    if (posed.what->kind() != ShapeKind::mesh()) {
        throw NotSupported(Question::cast, posed.what->kind(), ShapeKind::mesh());
    }
    return {static_cast<const MeshShape&>(*posed.what), posed.pose};
}

// Returns true if the mesh is a solid; false if it is a surface.
bool is_solid(const Posed<MeshShape>& mesh) noexcept {
    return mesh.what->form() != MeshForm::surface;
}

}  // namespace

std::optional<BodyEntry> World::entering(const Asked& asked, const Vec3& motion, const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    validate_motion(motion);
    const Posed<MeshShape> mover = mesh_at(subject.posed);
    for (ProxyIndex proxy = 0; proxy < w.bodies.end(); ++proxy) {
        if (!w.bodies[proxy].is_alive() || w.passes_over(subject, proxy)) continue;
        if (is_solid(mesh_at(w.bodies[proxy].posed())) != is_solid(mover)) {
            throw NotSupported("entering: the subject and all bodies must be surfaces, or all solids");
        }
    }
    Asking asking(ask);
    Least<ProxyIndex> least(1);
    FirstEntry entry;
    w.broad_phase.visit_along(w.box_of(subject), motion, least.bound(), [&](ProxyIndex proxy) {
        if (w.passes_over(subject, proxy) || !least.reach(proxy)) return least.bound();
        const auto found = ecods::entering(mover, motion, mesh_at(w.bodies[proxy].posed()), 1, asking.memory());
        if (found && least.take(proxy, found->time)) entry = *found;
        return least.bound();
    });
    if (!least.has_name()) return std::nullopt;
    return BodyEntry{w.bodies.id_of(least.name()), entry};
}

ContactPoint World::contact_point(const Asked& asked, const Vec3& motion, const BodyContact& contact,
                                  const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    const ProxyIndex proxy = w.bodies.require(contact.body);
    return ecods::contact_point(mesh_at(subject.posed), motion, mesh_at(w.bodies[proxy].posed()), contact.contact, ask);
}

}  // namespace ecods
