#include "engines/embree_triangles.hpp"

#include <stdexcept>

#include "simd/instruction_set.hpp"

namespace ecods::bench {

namespace {

const char* configuration() {
    if (instruction_set() == supported_instruction_set()) return "threads=1,user_threads=1";
    return instruction_set() == InstructionSet::avx2 ? "threads=1,user_threads=1,max_isa=avx2"
                                                     : "threads=1,user_threads=1,max_isa=sse2";
}

}  // namespace

RTCDevice make_embree_device() {
    RTCDevice device = rtcNewDevice(configuration());
    if (device == nullptr) throw std::runtime_error("Embree gives no device");
    return device;
}

RTCScene make_embree_scene(RTCDevice device, std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                           RTCSceneFlags flags) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* const coordinates = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), vertices.size()));
    for (std::size_t i = 0; i < vertices.size(); ++i)
        for (int axis = 0; axis < 3; ++axis)
            coordinates[3 * i + static_cast<std::size_t>(axis)] = static_cast<float>(vertices[i][axis]);
    auto* const indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), triangles.size()));
    for (std::size_t i = 0; i < triangles.size(); ++i)
        for (std::size_t k = 0; k < 3; ++k) indices[3 * i + k] = triangles[i][k];
    rtcCommitGeometry(geometry);
    RTCScene scene = rtcNewScene(device);
    rtcSetSceneFlags(scene, flags);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene);
    return scene;
}

RTCRayHit to_embree(const Segment& segment) {
    const auto f = [](double x) { return static_cast<float>(x); };
    RTCRayHit query{};
    const Vec3 arm = segment.b - segment.a;
    query.ray.org_x = f(segment.a.x());
    query.ray.org_y = f(segment.a.y());
    query.ray.org_z = f(segment.a.z());
    query.ray.dir_x = f(arm.x());
    query.ray.dir_y = f(arm.y());
    query.ray.dir_z = f(arm.z());
    query.ray.tnear = 0;
    query.ray.tfar = 1;
    query.ray.mask = ~0U;
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return query;
}

}  // namespace ecods::bench
