// Embree's rays. It reports the nearest hit; a filter that refuses every hit, and notes it, gives all of them.
#include <algorithm>
#include <array>

#include "engines/embree_triangles.hpp"
#include "engines/hit_engine.hpp"

namespace ecods::bench {

namespace {

class HitEmbree : public HitEngine {
  public:
    HitEmbree(const scenes::SegmentWorkload& workload, RTCSceneFlags flags)
        : all_(posed_triangles(workload)), flags_(flags), device_(make_embree_device()), scene_(make_scene(flags)) {}

    ~HitEmbree() override {
        if (noting_scene_ != nullptr) rtcReleaseScene(noting_scene_);
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit query = to_embree(segments[i]);
            rtcIntersect1(scene_, &context, &query);
            const bool is_hit = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            answers[i] = is_hit ? HitAnswer{query.ray.tfar, query.hit.primID} : HitAnswer{};
        }
    }

    void all_hits(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
        // A context's filter is only asked in a scene that allows it.
        if (noting_scene_ == nullptr)
            noting_scene_ = make_scene(static_cast<RTCSceneFlags>(flags_ | RTC_SCENE_FLAG_CONTEXT_FILTER_FUNCTION));
        triangles.clear();
        NotingContext context{{}, &triangles};
        rtcInitIntersectContext(&context.base);
        context.base.filter = &note;
        RTCRayHit query = to_embree(segment);
        rtcIntersect1(noting_scene_, &context.base, &query);
    }

  protected:
    RTCScene scene() const { return scene_; }

  private:
    struct NotingContext {
        RTCIntersectContext base;
        std::vector<std::uint32_t>* triangles;
    };

    static void note(const RTCFilterFunctionNArguments* arguments) {
        auto* const context = reinterpret_cast<NotingContext*>(arguments->context);
        context->triangles->push_back(RTCHitN_primID(arguments->hit, arguments->N, 0));
        arguments->valid[0] = 0;
    }

    RTCScene make_scene(RTCSceneFlags flags) const {
        return make_embree_scene(device_, all_.vertices, all_.triangles, flags);
    }

    scenes::PosedTriangles all_;
    RTCSceneFlags flags_;
    RTCDevice device_;
    RTCScene scene_;
    RTCScene noting_scene_ = nullptr;  // made when lists are first asked for
};

class HitEmbreePackets final : public HitEmbree {
  public:
    using HitEmbree::HitEmbree;

    void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); i += 16) {
            const std::size_t count = std::min<std::size_t>(16, segments.size() - i);
            ask(segments.subspan(i, count), answers.subspan(i, count));
        }
    }

  private:
    void ask(std::span<const Segment> segments, std::span<HitAnswer> answers) const {
        RTCRayHit16 packet{};
        alignas(64) std::array<int, 16> is_valid{};
        for (std::size_t k = 0; k < segments.size(); ++k) {
            const RTCRayHit query = to_embree(segments[k]);
            is_valid[k] = -1;
            packet.ray.org_x[k] = query.ray.org_x;
            packet.ray.org_y[k] = query.ray.org_y;
            packet.ray.org_z[k] = query.ray.org_z;
            packet.ray.dir_x[k] = query.ray.dir_x;
            packet.ray.dir_y[k] = query.ray.dir_y;
            packet.ray.dir_z[k] = query.ray.dir_z;
            packet.ray.tnear[k] = query.ray.tnear;
            packet.ray.tfar[k] = query.ray.tfar;
            packet.ray.mask[k] = query.ray.mask;
            packet.hit.geomID[k] = query.hit.geomID;
            packet.hit.instID[0][k] = query.hit.instID[0];
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcIntersect16(is_valid.data(), scene(), &context, &packet);
        for (std::size_t k = 0; k < segments.size(); ++k) {
            const bool is_hit = packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
            answers[k] = is_hit ? HitAnswer{packet.ray.tfar[k], packet.hit.primID[k]} : HitAnswer{};
        }
    }
};

}  // namespace

std::unique_ptr<HitEngine> set_up_hit_embree(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitEmbree>(workload, RTC_SCENE_FLAG_NONE);
}

std::unique_ptr<HitEngine> set_up_hit_embree_robust(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitEmbree>(workload, RTC_SCENE_FLAG_ROBUST);
}

std::unique_ptr<HitEngine> set_up_hit_embree_packets(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitEmbreePackets>(workload, RTC_SCENE_FLAG_NONE);
}

}  // namespace ecods::bench
