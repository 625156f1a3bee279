// FCL's meshes: a tree of OBBRSS, which it recommends, or of OBB, which its boolean queries use of it.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>
#include <fcl/narrowphase/distance.h>

#include <limits>
#include <type_traits>

#include "engines/fcl_bodies.hpp"
#include "engines/narrow_engine.hpp"

namespace ecods::bench {

namespace {

// The traversal that collide() makes for these nodes; made by hand, it counts.
template <class Volume>
struct Traversal;
template <>
struct Traversal<fcl::OBBRSSd> {
    using Node = fcl::detail::MeshCollisionTraversalNodeOBBRSSd;
};
template <>
struct Traversal<fcl::OBBd> {
    using Node = fcl::detail::MeshCollisionTraversalNodeOBBd;
};

template <class Volume>
class NarrowFcl final : public NarrowEngine {
  public:
    explicit NarrowFcl(std::span<const scenes::NamedMesh> meshes) {
        for (const scenes::NamedMesh& named : meshes) models_.push_back(to_fcl_model<Volume>(named));
    }

    bool query(const scenes::MeshQuery& query) override {
        const fcl::CollisionRequestd request(1, false);
        fcl::CollisionResultd result;
        return collide(query, request, result) > 0;
    }

    std::optional<NarrowWork> work(const scenes::MeshQuery& query) override {
        const fcl::CollisionRequestd request(1, false);
        fcl::CollisionResultd result;
        typename Traversal<Volume>::Node node;
        fcl::detail::initialize(node, *models_[query.a.mesh_index], to_fcl(query.a.pose), *models_[query.b.mesh_index],
                                to_fcl(query.b.pose), request, result);
        node.enableStatistics(true);
        fcl::detail::collide(&node);
        return NarrowWork{static_cast<std::uint64_t>(node.num_bv_tests),
                          static_cast<std::uint64_t>(node.num_leaf_tests)};
    }

    // For trees of OBB there is none.
    std::optional<double> distance(const scenes::MeshQuery& query) override {
        if constexpr (!std::is_same_v<Volume, fcl::OBBRSSd>) return std::nullopt;
        fcl::DistanceResultd result;
        fcl::distance(models_[query.a.mesh_index].get(), to_fcl(query.a.pose), models_[query.b.mesh_index].get(),
                      to_fcl(query.b.pose), fcl::DistanceRequestd(), result);
        return result.min_distance;
    }

    void list(const scenes::MeshQuery& query, std::vector<TrianglePair>& pairs) override {
        const fcl::CollisionRequestd request(std::numeric_limits<std::size_t>::max(), true);
        fcl::CollisionResultd result;
        pairs.clear();
        collide(query, request, result);
        for (std::size_t i = 0; i < result.numContacts(); ++i) {
            const fcl::Contactd& contact = result.getContact(i);
            pairs.push_back({static_cast<std::uint32_t>(contact.b1), static_cast<std::uint32_t>(contact.b2)});
        }
    }

  private:
    std::size_t collide(const scenes::MeshQuery& query, const fcl::CollisionRequestd& request,
                        fcl::CollisionResultd& result) const {
        return fcl::collide(models_[query.a.mesh_index].get(), to_fcl(query.a.pose), models_[query.b.mesh_index].get(),
                            to_fcl(query.b.pose), request, result);
    }

    std::vector<std::shared_ptr<fcl::BVHModel<Volume>>> models_;
};

}  // namespace

std::unique_ptr<NarrowEngine> set_up_narrow_fcl_obbrss(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<NarrowFcl<fcl::OBBRSSd>>(meshes);
}

std::unique_ptr<NarrowEngine> set_up_narrow_fcl_obb(std::span<const scenes::NamedMesh> meshes) {
    return std::make_unique<NarrowFcl<fcl::OBBd>>(meshes);
}

}  // namespace ecods::bench
