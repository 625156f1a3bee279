// ODE's sweep-and-prune space, over boxes that do not turn.
#include <ode/ode.h>

#include <algorithm>
#include <cstdint>

#include "engines/broad_engine.hpp"

namespace ecods::bench {

namespace {

class BroadOde final : public BroadEngine {
  public:
    explicit BroadOde(const scenes::MovingBoxes& boxes) {
        dInitODE2(0);
        dAllocateODEDataForThread(dAllocateMaskAll);
        space_ = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
        for (const Aabb& box : boxes.boxes) {
            const Vec3 size = box.max - box.min;
            const dGeomID geom = dCreateBox(space_, size.x(), size.y(), size.z());
            dGeomSetData(geom, reinterpret_cast<void*>(static_cast<std::uintptr_t>(geoms_.size())));
            geoms_.push_back(geom);
            move(geom, box);
        }
    }

    ~BroadOde() override {
        dSpaceDestroy(space_);  // with its geoms
        dCloseODE();
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& next : moves) {
            const dGeomID geom = geoms_[next.index];
            if (next.is_new) dSpaceRemove(space_, geom);
            move(geom, next.box);
            if (next.is_new) dSpaceAdd(space_, geom);
        }
        pairs_.clear();
        dSpaceCollide(space_, &pairs_, &note_pair);
    }

    std::vector<ProxyPair> pairs() const override { return pairs_; }

  private:
    static void move(dGeomID geom, const Aabb& box) {
        const Vec3 centre = (box.min + box.max) / 2;
        dGeomSetPosition(geom, centre.x(), centre.y(), centre.z());
    }

    static void note_pair(void* data, dGeomID a, dGeomID b) {
        const auto index = [](dGeomID geom) {
            return static_cast<ProxyIndex>(reinterpret_cast<std::uintptr_t>(dGeomGetData(geom)));
        };
        const auto [low, high] = std::minmax({index(a), index(b)});
        static_cast<std::vector<ProxyPair>*>(data)->push_back({low, high});
    }

    dSpaceID space_ = nullptr;
    std::vector<dGeomID> geoms_;
    std::vector<ProxyPair> pairs_;
};

}  // namespace

std::vector<BroadMaker> ode_broad() {
    return {{.name = "ODE SAP space",
             .use = "dSweepAndPruneSpace: dGeomSetPosition(), dSpaceCollide(); double",
             .traits = {.count_max = 10000},
             .set_up = makes<BroadOde>()}};
}

}  // namespace ecods::bench
