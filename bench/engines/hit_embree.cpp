// Embree's rays. It reports the nearest hit; a filter that refuses every hit, and notes it, gives all of them.
// Instances have the triangles of a mesh once, whichever number of bodies has it.
#include <algorithm>
#include <array>

#include "engines/embree_triangles.hpp"
#include "engines/hit_engine.hpp"

namespace ecods::bench {

namespace {

RTCRayHit first_hit_in(RTCScene scene, const Segment& segment) {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query = to_embree(segment);
    rtcIntersect1(scene, &context, &query);
    return query;
}

bool is_hit(const RTCRayHit& query) {
    return query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
}

class HitEmbree : public FirstHits::Engine, public HitLists {
  public:
    HitEmbree(const scenes::SegmentWorkload& workload, RTCSceneFlags flags)
        : all_(posed_triangles(workload)), flags_(flags), device_(make_embree_device()), scene_(make_scene(flags)) {}

    ~HitEmbree() override {
        if (noting_scene_ != nullptr) rtcReleaseScene(noting_scene_);
        rtcReleaseScene(scene_);
        rtcReleaseDevice(device_);
    }

    HitAnswer ask(const Segment& segment, std::size_t /*index*/) override {
        const RTCRayHit query = first_hit_in(scene_, segment);
        return is_hit(query) ? HitAnswer{query.ray.tfar, static_cast<double>(query.hit.primID)} : HitAnswer{};
    }

    void list(const Segment& segment, std::vector<std::uint32_t>& triangles) override {
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

    void ask_all(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); i += 16) {
            const std::size_t count = std::min<std::size_t>(16, segments.size() - i);
            ask_together(segments.subspan(i, count), answers.subspan(i, count));
        }
    }

  private:
    void ask_together(std::span<const Segment> segments, std::span<HitAnswer> answers) const {
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
            const bool is_found = packet.hit.geomID[k] != RTC_INVALID_GEOMETRY_ID;
            answers[k] =
                is_found ? HitAnswer{packet.ray.tfar[k], static_cast<double>(packet.hit.primID[k])} : HitAnswer{};
        }
    }
};

class HitEmbreeInstances final : public FirstHits::Engine {
  public:
    explicit HitEmbreeInstances(const scenes::SegmentWorkload& workload)
        : first_triangles_(first_triangles(workload)), device_(make_embree_device()), scene_(rtcNewScene(device_)) {
        for (const scenes::NamedMesh& named : workload.meshes)
            meshes_.push_back(
                make_embree_scene(device_, named.mesh->vertices(), named.mesh->triangles(), RTC_SCENE_FLAG_NONE));
        for (const scenes::MeshAt& body : workload.bodies) {
            RTCGeometry instance = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_INSTANCE);
            rtcSetGeometryInstancedScene(instance, meshes_[body.mesh_index]);
            std::array<float, 12> columns{};
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 3; ++row)
                    columns[static_cast<std::size_t>(3 * column + row)] =
                        static_cast<float>(column < 3 ? body.pose.R(row, column) : body.pose.t[row]);
            rtcSetGeometryTransform(instance, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns.data());
            rtcCommitGeometry(instance);
            rtcAttachGeometry(scene_, instance);
            rtcReleaseGeometry(instance);
        }
        rtcCommitScene(scene_);
    }

    ~HitEmbreeInstances() override {
        rtcReleaseScene(scene_);
        for (RTCScene mesh : meshes_) rtcReleaseScene(mesh);
        rtcReleaseDevice(device_);
    }

    HitAnswer ask(const Segment& segment, std::size_t /*index*/) override {
        const RTCRayHit query = first_hit_in(scene_, segment);
        if (!is_hit(query)) return {};
        return {query.ray.tfar, static_cast<double>(first_triangles_[query.hit.instID[0]] + query.hit.primID)};
    }

  private:
    std::vector<std::uint32_t> first_triangles_;
    RTCDevice device_;
    RTCScene scene_;
    std::vector<RTCScene> meshes_;
};

}  // namespace

std::vector<HitMaker> embree_hits() {
    return {{.name = hit_yardstick,
             .use = "rtcIntersect1(), one mesh of all triangles, flags and build quality as by default; for lists a "
                    "filter that refuses each hit; float",
             .has_lists = true,
             .set_up = makes<HitEmbree>(RTC_SCENE_FLAG_NONE)},
            {.name = "Embree robust",
             .use = "the same with RTC_SCENE_FLAG_ROBUST; float",
             .has_lists = true,
             .set_up = makes<HitEmbree>(RTC_SCENE_FLAG_ROBUST)},
            {.name = "Embree, 16 at once",
             .use = "rtcIntersect16() of consecutive segments: what several questions in one call give, which ECoDS "
                    "does not offer; float",
             .set_up = makes<HitEmbreePackets>(RTC_SCENE_FLAG_NONE)},
            {.name = "Embree instances",
             .use = "rtcIntersect1(), a scene for each mesh and an instance for each body; float",
             .traits = {.bodies = HitBodies::many},
             .set_up = makes<HitEmbreeInstances>()}};
}

}  // namespace ecods::bench
