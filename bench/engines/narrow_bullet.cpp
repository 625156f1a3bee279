// Bullet's GImpact, its collision detection for two concave moving meshes. It has no query that stops at the first
// contact. btCollisionWorld::contactPairTest, which other shapes are asked by, does not know GImpact: the algorithm is
// asked as the dispatcher asks it.
#include <BulletCollision/Gimpact/btGImpactCollisionAlgorithm.h>
#include <BulletCollision/Gimpact/btGImpactShape.h>
#include <btBulletCollisionCommon.h>

#include <array>
#include <memory>

#include "engines/bullet_mesh.hpp"
#include "engines/narrow_engine.hpp"

namespace ecods::bench {

namespace {

struct BulletMesh {
    explicit BulletMesh(const Mesh& mesh) : arrays(mesh.vertices(), mesh.triangles()) {}

    BulletArrays arrays;
    std::unique_ptr<btGImpactMeshShape> shape;
    std::array<btCollisionObject, 2> objects;  // as the first and as the second of a pair
};

struct AnyContact final : btManifoldResult {
    using btManifoldResult::btManifoldResult;
    bool is_found = false;

    void addContactPoint(const btVector3& /*normal*/, const btVector3& /*point*/, btScalar distance) override {
        if (distance <= 0) is_found = true;
    }
};

class NarrowBullet final : public Touch::Engine {
  public:
    explicit NarrowBullet(const scenes::MeshPairs& workload) : dispatcher_(&configuration_) {
        btGImpactCollisionAlgorithm::registerAlgorithm(&dispatcher_);
        for (const scenes::NamedMesh& named : workload.meshes) {
            meshes_.push_back(std::make_unique<BulletMesh>(*named.mesh));
            build(*meshes_.back());
        }
    }

    double ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        const btCollisionObject *a = placed(query.a, 0), *b = placed(query.b, 1);
        const btCollisionObjectWrapper of_a(nullptr, a->getCollisionShape(), a, a->getWorldTransform(), -1, -1);
        const btCollisionObjectWrapper of_b(nullptr, b->getCollisionShape(), b, b->getWorldTransform(), -1, -1);
        AnyContact any(&of_a, &of_b);
        btCollisionAlgorithm* algorithm = dispatcher_.findAlgorithm(&of_a, &of_b, nullptr, BT_CONTACT_POINT_ALGORITHMS);
        algorithm->processCollision(&of_a, &of_b, btDispatcherInfo(), &any);
        algorithm->~btCollisionAlgorithm();
        dispatcher_.freeCollisionAlgorithm(algorithm);
        return any.is_found ? 1 : 0;
    }

  private:
    static void build(BulletMesh& made) {
        made.shape = std::make_unique<btGImpactMeshShape>(made.arrays.get());
        made.shape->setMargin(0);
        made.shape->updateBound();
        for (btCollisionObject& object : made.objects) object.setCollisionShape(made.shape.get());
    }

    btCollisionObject* placed(const scenes::MeshAt& at, std::size_t role) {
        btCollisionObject& object = meshes_[at.mesh_index]->objects[role];
        object.setWorldTransform(to_bullet(at.pose));
        return &object;
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    std::vector<std::unique_ptr<BulletMesh>> meshes_;
};

}  // namespace

std::vector<NarrowMaker> bullet_narrow() {
    return {{.name = "Bullet GImpact",
             .use = "btGImpactMeshShape, margin 0, its algorithm from the dispatcher; float",
             .is_slow = true,
             .set_up = makes<NarrowBullet>()}};
}

}  // namespace ecods::bench
