#include "ecods/solid.hpp"

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

// Returns a pointer to a mesh that it does not own.
std::shared_ptr<const Mesh> borrowed(const Mesh& mesh) {
    return {std::shared_ptr<const void>(), &mesh};
}

// Holds the results of the check that a mesh bounds a solid.
struct Checked {
    ProperMesh proper;
    MeshEdges edges;
    std::vector<EdgeOverlap> overlaps;
    std::vector<std::uint8_t> star_faces_in;
};

Checked check(const MeshShape& shape) {
    Checked result;
    result.proper = find_proper(shape.mesh_ptr());
    result.edges = MeshEdges(result.proper);
    check_closed(shape.mesh(), result.proper, result.edges);
    result.star_faces_in = prove_star(result.proper, result.edges);
    if (!result.star_faces_in.empty()) return result;
    const auto least = least_self_contact(result.proper, MeshShapeAccess::tree(shape), result.overlaps);
    if (least) throw self_intersection(*least);
    return result;
}

}  // namespace

void check_solid(const Mesh& mesh) {
    check(MeshShape(borrowed(mesh)));
}

std::vector<TrianglePair> self_intersections(const Mesh& mesh) {
    const MeshShape shape(borrowed(mesh));
    return all_self_contacts(find_proper(shape.mesh_ptr()), MeshShapeAccess::tree(shape));
}

Solid::Solid(std::shared_ptr<const Mesh> mesh) : MeshShape(std::move(mesh)), solid_parts_(std::make_unique<Parts>()) {
    Checked checked = check(*this);
    Parts& parts = *solid_parts_;
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

const Shells& SolidAccess::shells(const Solid& solid) {
    Parts& parts = *solid.solid_parts_;
    return parts.shells.get([&] {
        return parts.star_faces_in.empty() ? find_shells(parts.proper, parts.edges, tree(solid))
                                           : shells_of_star(parts.proper, parts.star_faces_in);
    });
}

}  // namespace ecods
