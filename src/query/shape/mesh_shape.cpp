#include "ecods/shape.hpp"

#include <atomic>
#include <utility>

#include "base/lazy.hpp"
#include "base/make_error.hpp"
#include "bounds/support_table.hpp"
#include "query/shape/mesh_tree.hpp"

namespace ecods {
namespace {

// vertices_posed_max is the greatest number of vertices that box() poses one by one: posing is then as fast as a
// support table, and the box is tighter.
constexpr std::size_t vertices_posed_max = 32;

std::uint64_t next_tree_id() noexcept {
    static std::atomic<std::uint64_t> last{0};
    return last.fetch_add(1, std::memory_order_relaxed) + 1;
}

}  // namespace

// Parts holds everything that a MeshShape derives from its mesh. Each member is computed on first use, and does not
// depend on the thread or the query that uses it first.
struct MeshShape::Parts {
    Lazy<LocalFrame> frame;
    Lazy<SupportTable> support_table;
    Lazy<std::unique_ptr<const MeshTree>> tree;
    Lazy<std::unique_ptr<const CoplanarGroups>> groups;
    Lazy<Sha256::Digest> digest;
    Lazy<std::unique_ptr<const MeshShape>> in_other_units;
    Lazy<std::vector<std::uint32_t>> pieces;
    Lazy<std::unique_ptr<const ConvexSolid>> convex;

    // Returns the table from which boxes are computed; null if boxes are computed by posing all vertices.
    const SupportTable* table_for(const MeshShape& shape);
};

MeshShape::MeshShape(std::shared_ptr<const Mesh> mesh) : MeshShape(std::move(mesh), MeshForm::surface) {}

MeshShape::MeshShape(std::shared_ptr<const Mesh> mesh, MeshForm form)
    : mesh_(std::move(mesh)), parts_(std::make_shared<Parts>()), form_(form) {
    if (!mesh_) throw null_argument("mesh");
}

MeshShape::MeshShape(std::shared_ptr<const Mesh> mesh, std::shared_ptr<Parts> parts)
    : mesh_(std::move(mesh)), parts_(std::move(parts)) {}

MeshShape::~MeshShape() = default;

const LocalFrame& MeshShapeAccess::frame(const MeshShape& shape) {
    return shape.parts_->frame.get([&] { return fit_frame(shape.mesh()); });
}

const MeshTree& MeshShapeAccess::tree(const MeshShape& shape) {
    return *shape.parts_->tree.get([&] {
        return std::make_unique<const MeshTree>(
            MeshTree{exact::measure(shape.mesh()), build_mesh_bvh(shape.mesh(), frame(shape)), next_tree_id()});
    });
}

const CoplanarGroups& MeshShapeAccess::groups(const MeshShape& shape) {
    return *shape.parts_->groups.get([&] {
        const MeshTree& own = tree(shape);
        return std::make_unique<const CoplanarGroups>(find_coplanar_groups(shape.mesh(), own.extent, own.boxes));
    });
}

const Sha256::Digest& MeshShapeAccess::digest(const MeshShape& shape, Sha256::Digest (*make)(const MeshShape&)) {
    return shape.parts_->digest.get([&] { return make(shape); });
}

std::shared_ptr<const MeshShape> MeshShapeAccess::surface(const MeshShape& shape) {
    return std::shared_ptr<const MeshShape>(new MeshShape(shape.mesh_, shape.parts_));
}

const std::vector<std::uint32_t>& MeshShapeAccess::pieces(const MeshShape& shape,
                                                          std::vector<std::uint32_t> (*find)(const MeshShape&)) {
    return shape.parts_->pieces.get([&] { return find(shape); });
}

const MeshShape& MeshShapeAccess::in_other_units(const MeshShape& shape,
                                                 std::shared_ptr<const Mesh> (*make)(const Mesh& mesh, int e), int e) {
    return *shape.parts_->in_other_units.get([&] { return std::make_unique<const MeshShape>(make(shape.mesh(), e)); });
}

const ConvexSolid& MeshShapeAccess::convex(const MeshShape& shape,
                                           std::unique_ptr<const ConvexSolid> (*make)(const MeshShape&)) {
    return *shape.parts_->convex.get([&] { return make(shape); });
}

void MeshShapeAccess::refit_tree(const MeshShape& shape, const MeshShape& model) {
    shape.parts_->tree.get([&] {
        return std::make_unique<const MeshTree>(
            MeshTree{exact::measure(shape.mesh()), refit_mesh_bvh(tree(model).boxes, shape.mesh()), next_tree_id()});
    });
}

const SupportTable* MeshShape::Parts::table_for(const MeshShape& shape) {
    if (shape.mesh().vertices().size() <= vertices_posed_max) return nullptr;
    const LocalFrame& own = MeshShapeAccess::frame(shape);
    // A frame cannot be scaled to fit a very large or very small mesh, and a table would bound such a mesh poorly.
    if (!own.is_bounded || own.half.maxCoeff() < 0.25) return nullptr;
    return &support_table.get([&] { return SupportTable(shape.mesh(), own); });
}

Aabb MeshShape::box(const Pose& pose) const {
    const SupportTable* const table = parts_->table_for(*this);
    return table != nullptr ? table->box(pose) : box_of(*mesh_, pose);
}

void MeshShapeAccess::find_boxes(const MeshShape& shape, std::span<const Pose* const> poses,
                                 std::span<Aabb* const> boxes) {
    if (const SupportTable* const table = shape.parts_->table_for(shape)) return table->boxes(poses, boxes);
    for (std::size_t i = 0; i < poses.size(); ++i) *boxes[i] = box_of(shape.mesh(), *poses[i]);
}

std::size_t MeshShape::tree_bytes() const {
    const MeshTree& tree = MeshShapeAccess::tree(*this);
    return sizeof(MeshTree) - sizeof(MeshBvh) + tree.boxes.bytes();
}

std::shared_ptr<const MeshShape> refit(const MeshShape& shape, std::vector<Vec3> vertices) {
    const auto triangles = shape.mesh().triangles();
    auto mesh = Mesh::create(std::move(vertices), {triangles.begin(), triangles.end()});
    auto result = std::make_shared<const MeshShape>(std::move(mesh));
    MeshShapeAccess::refit_tree(*result, shape);
    return result;
}

}  // namespace ecods
