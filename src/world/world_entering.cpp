#include "query/body/posed_body.hpp"
#include "query/intersection/asking.hpp"
#include "query/patch/rounded_contact_point.hpp"
#include "world/first_met.hpp"
#include "world/rounded_test.hpp"

namespace ecods {
namespace {

// Returns the mesh of a subject or a body. Throws NotSupported if its shape is not a mesh.
Posed<MeshShape> mesh_at(const Posed<Shape>& posed) {
    if (posed.what->kind() != ShapeKind::mesh()) {
        throw NotSupported(Question::cast, posed.what->kind(), ShapeKind::mesh());
    }
    return {static_cast<const MeshShape&>(*posed.what), posed.pose};
}

// Returns true if the mesh is a solid, and false if it is a surface. Throws NotSupported for a solid without an inside.
bool has_inside_to_enter(const Posed<MeshShape>& mesh) {
    if (mesh.what->form() == MeshForm::surface) return false;
    if (!PosedBody(mesh).has_inside()) throw NotSupported("entering: a solid is flat, or at a singular pose");
    return true;
}

// Returns true if all bodies are surfaces. Cost: a pass over the kinds.
bool are_surfaces(const Bodies& bodies) {
    return bodies.are_meshes() && bodies.solid_count() == 0;
}

}  // namespace

std::optional<BodyEntry> World::entering(const Asked& asked, const Vec3& motion, double max_time,
                                         const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    auto first = search_along<FirstBodyEntered>(motion, max_time);
    const Posed<MeshShape> mover = mesh_at(subject.posed);
    const bool is_solid = has_inside_to_enter(mover);
    if (is_solid || !are_surfaces(w.bodies)) {
        w.for_each_asked(subject, [&](const Slot& slot) {
            if (has_inside_to_enter(mesh_at(slot.posed())) == is_solid) return;
            throw NotSupported("entering: the subject and all bodies must be surfaces, or all solids");
        });
    }
    Asking asking(ask);
    // Searches for entries up to max_time, not up to the time of an entry found before: only entries that precede the
    // limit are found, so an entry that ties with the one found before would not be found.
    first.visit(w, subject, w.box_of(subject), motion, [&](const Slot& slot, double) {
        return ecods::entering(mover, motion, mesh_at(slot.posed()), max_time, asking.memory());
    });
    return w.traced_of<calls::Entering>(ask, first.answer(w.bodies), asked, motion, max_time);
}

ContactPoint World::contact_point(const Asked& asked, const Vec3& motion, const BodyContact& contact,
                                  const Ask& ask) const {
    const Impl& w = impl();
    const Subject subject = w.subject_of(asked);
    const ProxyIndex proxy = w.bodies.require(contact.body);
    const RoundedPair bodies{require_core(subject.posed), require_core(w.bodies[proxy].posed())};
    return ecods::contact_point(bodies, motion, contact.contact, ask);
}

}  // namespace ecods
