#include "ecods/shape.hpp"

#include <utility>

#include "base/lazy.hpp"
#include "bounds/support_table.hpp"
#include "ecods/error.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

// Up to here posing every vertex is as quick as asking the support_table, and tighter.
constexpr std::size_t vertices_posed_max = 32;

}  // namespace

// All that a mesh's shape has beside the mesh, each part the same whoever asks for it first.
struct MeshShape::Parts {
    Lazy<LocalFrame> frame;
    Lazy<SupportTable> support_table;
    Lazy<std::unique_ptr<const Tree>> tree;
};

MeshShape::MeshShape(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)), parts_(std::make_unique<Parts>()) {
    if (!mesh_) throw NullArgument("mesh");
}

MeshShape::~MeshShape() = default;

const LocalFrame& MeshShape::frame() const {
    return parts_->frame.get([this] { return fit_frame(*mesh_); });
}

Aabb MeshShape::box(const Pose& pose) const {
    if (mesh_->vertices().size() <= vertices_posed_max || !frame().is_bounded) return box_of(*mesh_, pose);
    return parts_->support_table.get([this] { return SupportTable(*mesh_, frame()); }).box(pose);
}

const MeshShape::Tree& MeshShape::tree() const {
    return *parts_->tree.get([this] {
        return std::make_unique<const Tree>(Tree{exact::measure(*mesh_), build_mesh_bvh(*mesh_, frame())});
    });
}

std::size_t MeshShape::tree_bytes() const {
    return sizeof(Tree) - sizeof(MeshBvh) + tree().boxes.bytes();
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
    parts_->tree.get([&] {
        return std::make_unique<const Tree>(Tree{exact::measure(*mesh_), refit_mesh_bvh(model.tree().boxes, *mesh_)});
    });
}

bool TwoBodyTest::intersects_again(const PosedShape& a, const PosedShape& b, QueryMemory& memory,
                                   PairWitness& /*witness*/) const {
    return intersects(a, b, memory);
}

std::vector<TrianglePair> TwoBodyTest::intersecting_triangles(const PosedShape& a, const PosedShape& b,
                                                              QueryMemory& /*memory*/) const {
    throw NotSupported("the test of shape kinds " + std::to_string(a.shape.kind().value) + " and " +
                       std::to_string(b.shape.kind().value) + " has no triangles to list");
}

}  // namespace ecods
