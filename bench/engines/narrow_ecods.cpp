// ECoDS without a world: intersects() and intersecting_triangles() of two posed meshes.
#include <memory>

#include "ecods/intersection.hpp"
#include "engines/narrow_engine.hpp"

namespace ecods::bench {

namespace {

class NarrowEcods final : public NarrowEngine {
  public:
    explicit NarrowEcods(std::span<const scenes::NamedMesh> meshes) {
        for (const scenes::NamedMesh& named : meshes) {
            shapes_.push_back(std::make_unique<MeshShape>(named.mesh));
            shapes_.back()->tree_bytes();  // makes the tree
        }
    }

    bool query(const scenes::MeshQuery& query) override { return intersects(posed(query.a), posed(query.b), memory_); }

    std::optional<NarrowWork> work(const scenes::MeshQuery& query) override {
        memory_.reset_counts();
        intersects(posed(query.a), posed(query.b), memory_);
        return NarrowWork{memory_.counts().box_tests, memory_.counts().stages.triangle_tests};
    }

    void list(const scenes::MeshQuery& query, std::vector<TrianglePair>& pairs) override {
        pairs = intersecting_triangles(posed(query.a), posed(query.b), memory_);
    }

  private:
    Posed<MeshShape> posed(const scenes::MeshAt& at) const { return {*shapes_[at.mesh_index], at.pose}; }

    std::vector<std::unique_ptr<MeshShape>> shapes_;
    QueryMemory memory_;
};

}  // namespace

std::unique_ptr<NarrowEngine> set_up_narrow_ecods(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<NarrowEcods>(meshes);
}

}  // namespace ecods::bench
