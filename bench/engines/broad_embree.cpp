// Embree's collision of a scene with itself. Its leaves may hold bounds that are larger than the boxes, so each pair
// that it reports is tested; and it reports a pair in either order, or both.
#include <algorithm>
#include <mutex>

#include "engines/broad_engine.hpp"
#include "engines/embree_triangles.hpp"

namespace ecods::bench {

namespace {

class BroadEmbree final : public BroadEngine {
  public:
    explicit BroadEmbree(const scenes::MovingBoxes& boxes) : device_(make_embree_device()) {
        for (const Aabb& box : boxes.boxes) boxes_.push_back(to_embree(box));
        scene_ = rtcNewScene(device_);
        rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_DYNAMIC);
        rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_LOW);
        geometry_ = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_USER);
        rtcSetGeometryUserPrimitiveCount(geometry_, static_cast<unsigned>(boxes_.size()));
        rtcSetGeometryUserData(geometry_, this);
        rtcSetGeometryBoundsFunction(geometry_, &give_bounds, nullptr);
        rtcCommitGeometry(geometry_);
        rtcAttachGeometry(scene_, geometry_);
        rtcCommitScene(scene_);
    }

    ~BroadEmbree() override {
        rtcReleaseGeometry(geometry_);
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    void run_frame(std::span<const scenes::BoxMove> moves) override {
        for (const scenes::BoxMove& move : moves) boxes_[move.index] = to_embree(move.box);
        if (!moves.empty()) {
            rtcCommitGeometry(geometry_);
            rtcCommitScene(scene_);
        }
        pairs_.clear();
        rtcCollide(scene_, scene_, &note_pairs, this);
    }

    std::vector<ProxyPair> pairs() const override { return pairs_; }

  private:
    static RTCBounds to_embree(const Aabb& box) {
        const auto f = [](double x) { return static_cast<float>(x); };
        return {f(box.min.x()), f(box.min.y()), f(box.min.z()), 0, f(box.max.x()), f(box.max.y()), f(box.max.z()), 0};
    }

    static void give_bounds(const RTCBoundsFunctionArguments* arguments) {
        const BroadEmbree& self = *static_cast<const BroadEmbree*>(arguments->geometryUserPtr);
        *arguments->bounds_o = self.boxes_[arguments->primID];
    }

    static bool overlap(const RTCBounds& a, const RTCBounds& b) {
        return a.lower_x <= b.upper_x && b.lower_x <= a.upper_x && a.lower_y <= b.upper_y && b.lower_y <= a.upper_y &&
               a.lower_z <= b.upper_z && b.lower_z <= a.upper_z;
    }

    static void note_pairs(void* data, RTCCollision* collisions, unsigned count) {
        BroadEmbree& self = *static_cast<BroadEmbree*>(data);
        // Embree may call from several threads.
        const std::lock_guard lock(self.mutex_);
        for (unsigned i = 0; i < count; ++i) {
            const ProxyIndex a = collisions[i].primID0, b = collisions[i].primID1;
            if (a < b && overlap(self.boxes_[a], self.boxes_[b])) self.pairs_.push_back({a, b});
        }
    }

    RTCDevice device_;
    RTCScene scene_ = nullptr;
    RTCGeometry geometry_ = nullptr;
    std::vector<RTCBounds> boxes_;
    std::vector<ProxyPair> pairs_;
    std::mutex mutex_;
};

}  // namespace

std::vector<BroadMaker> embree_broad() {
    return {{.name = "Embree rtcCollide",
             .use = "user geometry, dynamic scene of low build quality, rebuilt each frame, one thread; float",
             .set_up = makes<BroadEmbree>()}};
}

}  // namespace ecods::bench
