#include "fuzz/checks/truth.hpp"

#include <algorithm>
#include <utility>

#include "ecods/rounded.hpp"
#include "fuzz/base/mesh_form.hpp"
#include "oracle/solid.hpp"
#include "oracle/solid_points.hpp"
#include "scenes/numbers_of.hpp"

namespace ecods::fuzz {
namespace {

TruePair judge_rounded(const TrueBody& a, const TrueBody& b) {
    TruePair pair{{a.id, b.id}, {}, false, false, false, true, distance_of(a, b)};
    const int sign = pair.rounded->compare(0);
    pair.verdict.relation = sign > 0 ? Relation::apart : sign == 0 ? Relation::touching : Relation::crossing;
    return pair;
}

// The boxes that contain the bodies, by the middle of their sum of radii; with doubles, so a little more.
bool may_overlap(const TrueBody& a, const TrueBody& b) {
    if (a.radius == 0 && b.radius == 0) return oracle::boxes_overlap(a.exact.outer_box(), b.exact.outer_box());
    const Aabb x = a.exact.outer_box(), y = b.exact.outer_box();
    for (int axis = 0; axis < 3; ++axis) {
        const double gap = std::max(x.min[axis] - y.max[axis], y.min[axis] - x.max[axis]), sum = a.radius + b.radius;
        if (gap > sum + sum * 0x1p-40 + 0x1p-1000) return false;
    }
    return true;
}

TruePair judge(const TrueBody& a, const TrueBody& b) {
    if (a.radius != 0 || b.radius != 0) return judge_rounded(a, b);
    const bool are_surfaces = a.form == MeshForm::surface && b.form == MeshForm::surface;
    TruePair pair{{a.id, b.id}, oracle::verdict(a.exact, b.exact), false, false, are_surfaces, true};
    for (TrianglePair& triangles : pair.verdict.triangles) {
        triangles = {a.boundary.name(triangles.a), b.boundary.name(triangles.b)};
    }
    if (pair.verdict.relation != Relation::apart) return pair;
    pair.is_a_inside = b.boundary.has_inside && oracle::has_piece_inside(a.soup(), b.soup());
    pair.is_b_inside = a.boundary.has_inside && oracle::has_piece_inside(b.soup(), a.soup());
    return pair;
}

}  // namespace

oracle::RoundedDistance distance_of(const TrueBody& a, const TrueBody& b) {
    const oracle::Soup of_a = a.soup(), of_b = b.soup();
    oracle::ExactClosest cores = oracle::MeshDistances(of_a, of_b).closest();
    const bool is_inside = (b.boundary.has_inside && oracle::has_piece_inside(of_a, of_b)) ||
                           (a.boundary.has_inside && oracle::has_piece_inside(of_b, of_a));
    if (is_inside) cores.distance = {};
    return {cores, a.radius, b.radius};
}

std::shared_ptr<const Mesh> mesh_of_mesh_shape(const Shape& shape) {
    const auto* of_mesh = dynamic_cast<const MeshShape*>(&shape);
    return of_mesh != nullptr ? of_mesh->mesh_ptr() : nullptr;
}

std::shared_ptr<const MeshShape> surface_shape(const std::shared_ptr<const Shape>& shape) {
    if (const auto* solid = dynamic_cast<const Solid*>(shape.get())) return surface_of(*solid);
    return std::dynamic_pointer_cast<const MeshShape>(shape);
}

Boundary boundary_of(const Shape& shape, const std::shared_ptr<const Mesh>& mesh, const Pose& pose) {
    if (form_of(shape) == MeshForm::surface) return {mesh, {}, false};
    const int dimension = dimension_of(shape);
    if (dimension < 2) return {mesh, {}, false};
    Boundary result{mesh, {}, dimension == 3 && !oracle::is_singular(pose)};
    std::vector<Triangle> proper;
    for (std::uint32_t i = 0; i < mesh->triangles().size(); ++i) {
        if (!oracle::has_area(*mesh, i)) continue;
        proper.push_back(mesh->triangles()[i]);
        result.names.push_back(i);
    }
    if (proper.size() == mesh->triangles().size()) {
        result.names.clear();
    } else {
        result.mesh = Mesh::create({mesh->vertices().begin(), mesh->vertices().end()}, std::move(proper));
    }
    return result;
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
        const auto shape = world.shape(id);
        const auto mesh = mesh_of_(*shape);
        if (!mesh) continue;
        const Pose pose = world.pose(id);
        const MeshForm form = form_of(*shape);
        const double radius = radius_of(*shape);
        const bool is_rounded = dynamic_cast<const Rounded*>(shape.get()) != nullptr;
        const TrueBody* known = find(id);
        const bool has_same_shape = known != nullptr && known->mesh == mesh && known->form == form &&
                                    known->radius == radius && known->is_rounded == is_rounded;
        if (has_same_shape && known->pose == pose) {
            bodies.push_back(*known);
            bodies.back().is_changed = false;
        } else {
            Boundary boundary = boundary_of(*shape, mesh, pose);
            const oracle::OracleMesh exact(boundary.mesh, pose);
            bodies.push_back({id, mesh, form, radius, is_rounded, pose, std::move(boundary), exact, true});
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
            if (!may_overlap(a, b)) continue;
            const TrueBody& first = a.id < b.id ? a : b;
            const TrueBody& second = a.id < b.id ? b : a;
            pairs_.push_back(judge(first, second));
        }
    }
    std::ranges::sort(pairs_, {}, &TruePair::ids);
}

}  // namespace ecods::fuzz
