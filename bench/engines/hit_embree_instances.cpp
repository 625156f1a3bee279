// Embree's instances: the triangles of a mesh once, whichever number of bodies has it.
#include <array>

#include "engines/embree_triangles.hpp"
#include "engines/hit_engine.hpp"

namespace ecods::bench {

namespace {

class HitEmbreeInstances final : public HitEngine {
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

    void first_hits(std::span<const Segment> segments, std::span<HitAnswer> answers) override {
        for (std::size_t i = 0; i < segments.size(); ++i) {
            RTCIntersectContext context;
            rtcInitIntersectContext(&context);
            RTCRayHit query = to_embree(segments[i]);
            rtcIntersect1(scene_, &context, &query);
            const bool is_hit = query.hit.geomID != RTC_INVALID_GEOMETRY_ID;
            answers[i] = is_hit ? HitAnswer{query.ray.tfar, first_triangles_[query.hit.instID[0]] + query.hit.primID}
                                : HitAnswer{};
        }
    }

  private:
    std::vector<std::uint32_t> first_triangles_;
    RTCDevice device_;
    RTCScene scene_;
    std::vector<RTCScene> meshes_;
};

}  // namespace

std::unique_ptr<HitEngine> set_up_hit_embree_instances(const scenes::SegmentWorkload& workload) {
    return std::make_unique<HitEmbreeInstances>(workload);
}

}  // namespace ecods::bench
