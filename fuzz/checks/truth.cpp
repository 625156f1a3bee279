#include "fuzz/checks/truth.hpp"
#include "scenes/numbers_of.hpp"

#include <algorithm>
#include <utility>

namespace ecods::fuzz {

std::shared_ptr<const Mesh> mesh_of_mesh_shape(const Shape& shape) {
    const auto* of_mesh = dynamic_cast<const MeshShape*>(&shape);
    return of_mesh != nullptr ? of_mesh->mesh_ptr() : nullptr;
}

const TrueBody* Truth::find(BodyId body) const noexcept {
    const auto found = std::ranges::lower_bound(bodies_, body, {}, &TrueBody::id);
    return found != bodies_.end() && found->id == body ? &*found : nullptr;
}

void Truth::look_at(const World& world) {
    renew_bodies(world);
    renew_pairs();
}

void Truth::renew_bodies(const World& world) {
    std::vector<TrueBody> bodies;
    for (const BodyId id : numbers_of(world.bodies())) {
        const auto mesh = mesh_of_(*world.shape(id));
        if (!mesh) continue;
        const Pose pose = world.pose(id);
        const TrueBody* known = find(id);
        if (known != nullptr && known->mesh == mesh && known->pose == pose) {
            bodies.push_back(*known);
            bodies.back().is_changed = false;
        } else {
            bodies.push_back({id, mesh, pose, oracle::OracleMesh(mesh, pose), true});
        }
    }
    bodies_ = std::move(bodies);
}

void Truth::renew_pairs() {
    std::erase_if(pairs_, [&](TruePair& pair) {
        pair.is_changed = false;
        const TrueBody* a = find(pair.ids.a);
        const TrueBody* b = find(pair.ids.b);
        return a == nullptr || b == nullptr || a->is_changed || b->is_changed;
    });
    for (const TrueBody& a : bodies_) {
        if (!a.is_changed) continue;
        for (const TrueBody& b : bodies_) {
            // Of two that changed, the pair is found once.
            if (a.id == b.id || (b.is_changed && b.id < a.id)) continue;
            if (!oracle::boxes_overlap(a.exact.outer_box(), b.exact.outer_box())) continue;
            const TrueBody& first = a.id < b.id ? a : b;
            const TrueBody& second = a.id < b.id ? b : a;
            pairs_.push_back({{first.id, second.id}, oracle::verdict(first.exact, second.exact), true});
        }
    }
    std::ranges::sort(pairs_, {}, &TruePair::ids);
}

}  // namespace ecods::fuzz
