// FCL's meshes: a tree of OBBRSS, which it recommends, or of OBB, which its boolean queries use of it.
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/detail/traversal/collision/mesh_collision_traversal_node.h>
#include <fcl/narrowphase/detail/traversal/collision_node.h>

#include <limits>

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
class NarrowFcl final : public Touch::Engine, public NarrowLists, public NarrowWork {
  public:
    explicit NarrowFcl(const scenes::MeshPairs& workload) : models_(to_fcl_models<Volume>(workload.meshes)) {}

    double ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        const fcl::CollisionRequestd request(1, false);
        fcl::CollisionResultd result;
        return collide(query, request, result) > 0 ? 1 : 0;
    }

    Work work(const scenes::MeshQuery& query) override {
        const fcl::CollisionRequestd request(1, false);
        fcl::CollisionResultd result;
        typename Traversal<Volume>::Node node;
        fcl::detail::initialize(node, *models_[query.a.mesh_index], to_fcl(query.a.pose), *models_[query.b.mesh_index],
                                to_fcl(query.b.pose), request, result);
        node.enableStatistics(true);
        fcl::detail::collide(&node);
        return {static_cast<std::uint64_t>(node.num_bv_tests), static_cast<std::uint64_t>(node.num_leaf_tests)};
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

std::vector<NarrowMaker> fcl_narrow() {
    return {{.name = narrow_yardstick,
             .use = "BVHModel<OBBRSS>, collide() with one contact and no details; double",
             .has_lists = true,
             .set_up = makes<NarrowFcl<fcl::OBBRSSd>>()},
            {.name = "FCL OBB",
             .use = "BVHModel<OBB>, the rest the same; double",
             .set_up = makes<NarrowFcl<fcl::OBBd>>()}};
}

}  // namespace ecods::bench
