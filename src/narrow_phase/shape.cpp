#include "ecods/shape.hpp"

#include <mutex>
#include <optional>
#include <utility>

#include "bounds/outline.hpp"
#include "ecods/error.hpp"
#include "narrow_phase/mesh_tree.hpp"

namespace ecods {
namespace {

// Up to here posing every vertex is as quick as asking the outline, and tighter.
constexpr std::size_t vertices_posed_max = 32;

}  // namespace

// All that a mesh's shape has beside the mesh, each part made when it is asked for first: written once under a flag,
// the same whoever comes first.
struct MeshShape::Parts {
    std::once_flag frame_once, outline_once, tree_once;
    TreeFrame frame;
    std::optional<Outline> outline;
    std::unique_ptr<const Tree> tree;
};

MeshShape::MeshShape(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)), parts_(std::make_unique<Parts>()) {
    if (!mesh_) throw NullArgument("mesh");
}

MeshShape::~MeshShape() = default;

const TreeFrame& MeshShape::frame() const {
    std::call_once(parts_->frame_once, [this] { parts_->frame = fit_frame(*mesh_); });
    return parts_->frame;
}

Aabb MeshShape::box(const Pose& pose) const {
    if (mesh_->vertices().size() <= vertices_posed_max || !frame().is_bounded) return box_of(*mesh_, pose);
    std::call_once(parts_->outline_once, [this] { parts_->outline.emplace(*mesh_, frame()); });
    return parts_->outline->box(pose);
}

const MeshShape::Tree& MeshShape::tree() const {
    std::call_once(parts_->tree_once, [this] {
        parts_->tree = std::make_unique<const Tree>(Tree{exact::measure(*mesh_), build_wide_tree(*mesh_, frame())});
    });
    return *parts_->tree;
}

std::size_t MeshShape::tree_bytes() const {
    return sizeof(Tree) - sizeof(WideTree) + tree().boxes.bytes();
}

std::shared_ptr<const MeshShape> refit(const MeshShape& shape, std::vector<Vec3> vertices) {
    const auto triangles = shape.mesh().triangles();
    auto mesh = Mesh::create(std::move(vertices), {triangles.begin(), triangles.end()});
    auto result = std::make_shared<MeshShape>(std::move(mesh));
    result->take_tree(shape);
    return result;
}

// Before anyone else has the shape.
void MeshShape::take_tree(const MeshShape& model) {
    std::call_once(parts_->tree_once, [&] {
        parts_->tree =
            std::make_unique<const Tree>(Tree{exact::measure(*mesh_), refit_wide_tree(model.tree().boxes, *mesh_)});
    });
}

bool TwoBodyTest::intersects_again(const PosedShape& a, const PosedShape& b, QueryMemory& memory,
                                   PairWitness& /*witness*/) const {
    return intersects(a, b, memory);
}

std::vector<TrianglePair> TwoBodyTest::touching_triangles(const PosedShape& a, const PosedShape& b,
                                                          QueryMemory& /*memory*/) const {
    throw NotSupported("the test of shape kinds " + std::to_string(a.shape.kind().value) + " and " +
                       std::to_string(b.shape.kind().value) + " has no triangles to list");
}

}  // namespace ecods
