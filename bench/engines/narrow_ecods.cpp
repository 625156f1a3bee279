// ECoDS without a world: intersects() and intersecting_triangles() of two posed meshes.
#include "ecods/intersection.hpp"

#include <tuple>

#include "engines/narrow_engine.hpp"
#include "engines/own_shapes.hpp"

namespace ecods::bench {

namespace {

class NarrowEcods final : public Touch::Engine, public NarrowLists, public NarrowWork {
  public:
    explicit NarrowEcods(const scenes::MeshPairs& workload) : posed_(workload.meshes) {}

    double ask(const scenes::MeshQuery& query, std::size_t /*index*/) override {
        return intersects(posed_(query.a), posed_(query.b), memory_) ? 1 : 0;
    }

    Work work(const scenes::MeshQuery& query) override {
        QueryCounts counts;
        std::ignore = intersects(posed_(query.a), posed_(query.b), {memory_, counts});
        return {counts.box_tests, counts.stages.triangle_tests};
    }

    void list(const scenes::MeshQuery& query, std::vector<TrianglePair>& pairs) override {
        pairs = intersecting_triangles(posed_(query.a), posed_(query.b), memory_);
    }

  private:
    OwnShapes<MeshShape> posed_;
    QueryMemory memory_;
};

}  // namespace

std::vector<NarrowMaker> ecods_narrow() {
    return {{.name = "ECoDS",
             .use = "MeshShape, intersects(), one QueryMemory; exact",
             .is_ecods = true,
             .has_lists = true,
             .set_up = makes<NarrowEcods>()}};
}

}  // namespace ecods::bench
