#include "ecods/solid.hpp"

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "base/make_error.hpp"
#include "query/solid/self_contacts.hpp"
#include "query/solid/solid_parts.hpp"
#include "query/solid/split_edges.hpp"
#include "query/solid/star_proof.hpp"

namespace ecods {
namespace {

// Returns a pointer that does not own the mesh.
std::shared_ptr<const Mesh> borrowed(const Mesh& mesh) {
    return {std::shared_ptr<const void>(), &mesh};
}

// Checked holds the results of the check that a mesh bounds a solid.
struct Checked {
    ProperMesh proper;
    MeshEdges edges;
    std::vector<EdgeOverlap> overlaps;
    std::vector<std::uint8_t> star_faces_in;
};

Checked check(const MeshShape& shape, ProperMesh proper) {
    Checked result;
    result.proper = std::move(proper);
    if (std::ranges::none_of(result.proper.has_area, [](auto has) { return has != 0; }) &&
        !result.proper.has_area.empty())
        throw no_area(shape.mesh().vertices().size());
    result.edges = MeshEdges(result.proper);
    check_closed(shape.mesh(), result.proper, result.edges);
    result.star_faces_in = prove_star(result.proper, result.edges);
    if (!result.star_faces_in.empty()) return result;
    const auto least = least_self_contact(result.proper, MeshShapeAccess::tree(shape), result.overlaps);
    if (least) throw self_intersection(*least);
    return result;
}

// Returns the solid's boundary, without the triangles of zero area.
SolidBoundary find_boundary(const Solid& solid) {
    const std::vector<std::uint8_t>& has_area = SolidAccess::parts(solid).has_area;
    SolidBoundary result;
    if (has_area.empty()) return result;
    const Mesh& mesh = solid.mesh();
    std::vector<Triangle> triangles;
    for (std::uint32_t i = 0; i < has_area.size(); ++i) {
        if (has_area[i] == 0) continue;
        triangles.push_back(mesh.triangles()[i]);
        result.names.push_back(i);
    }
    result.shape = std::make_unique<const MeshShape>(
        Mesh::create({mesh.vertices().begin(), mesh.vertices().end()}, std::move(triangles)));
    return result;
}

}  // namespace

void check_solid(const Mesh& mesh) {
    const MeshShape shape(borrowed(mesh));
    check(shape, find_proper(shape.mesh_ptr()));
}

std::vector<TrianglePair> self_intersections(const Mesh& mesh) {
    const MeshShape shape(borrowed(mesh));
    return all_self_contacts(find_proper(shape.mesh_ptr()), MeshShapeAccess::tree(shape));
}

Solid::Solid(std::shared_ptr<const Mesh> mesh) : Solid(std::move(mesh), MeshForm::solid) {}

Solid::Solid(std::shared_ptr<const Mesh> mesh, MeshForm form)
    : MeshShape(std::move(mesh), form), solid_parts_(std::make_unique<Parts>()) {
    Parts& parts = *solid_parts_;
    ProperMesh proper = find_proper(mesh_ptr());
    if (form == MeshForm::convex) {
        if (auto flat = find_flat(proper)) {
            if (flat->is_polygon()) parts.has_area = proper.has_area;
            parts.flat = std::make_unique<const FlatMesh>(std::move(*flat));
            parts.proper = std::move(proper);
            return;
        }
    }
    Checked checked = check(*this, std::move(proper));
    parts.has_area = checked.proper.has_area;
    if (checked.overlaps.empty()) {
        parts.proper = std::move(checked.proper);
        parts.edges = std::move(checked.edges);
        parts.star_faces_in = std::move(checked.star_faces_in);
        return;
    }
    SplitMesh split = split_edges(checked.proper, checked.overlaps);
    parts.proper = std::move(split.mesh);
    parts.origins = std::move(split.origins);
    parts.edges = MeshEdges(parts.proper);
    parts.split_shape = std::make_unique<const MeshShape>(parts.proper.mesh);
}

Solid::~Solid() = default;

const MeshTree& SolidAccess::tree(const Solid& solid) {
    const auto& split = parts(solid).split_shape;
    return MeshShapeAccess::tree(split ? *split : static_cast<const MeshShape&>(solid));
}

std::shared_ptr<const MeshShape> surface_of(const Solid& solid) {
    return SolidAccess::surface(solid);
}

const std::shared_ptr<const MeshShape>& SolidAccess::surface(const Solid& solid) {
    return solid.solid_parts_->surface.get([&] { return MeshShapeAccess::surface(solid); });
}

const SolidBoundary& SolidAccess::boundary(const Solid& solid) {
    return solid.solid_parts_->boundary.get([&] { return find_boundary(solid); });
}

const Shells& SolidAccess::shells(const Solid& solid) {
    Parts& parts = *solid.solid_parts_;
    return parts.shells.get([&] {
        return parts.star_faces_in.empty() ? find_shells(parts.proper, parts.edges, tree(solid))
                                           : shells_of_star(parts.proper, parts.star_faces_in);
    });
}

}  // namespace ecods
