#include "check_certificates.hpp"

namespace ecods::check {

void certify_frame(SceneWorld& world, std::size_t body_count, certificates::CertificateFolder& folder) {
    QueryMemory memory;
    folder.add(world.world().certify(memory));
    for (std::size_t i = 0; world.questions().has_distances && i < body_count; ++i) {
        for (std::size_t j = i + 1; j < body_count; ++j) {
            folder.add(certify_distance(world.posed(i), world.posed(j), memory));
        }
    }
}

void certify_case(const scenes::HardCase& hard, certificates::CertificateFolder& folder) {
    const MeshShape shape_a(hard.a.mesh);
    const MeshShape shape_b(hard.b.mesh);
    folder.add_mesh(shape_a);
    folder.add_mesh(shape_b);
    const Posed<MeshShape> a{shape_a, hard.a.pose};
    const Posed<MeshShape> b{shape_b, hard.b.pose};
    QueryMemory memory;
    folder.add(certify(a, b, memory));
    folder.add(certify(b, a, memory));
    const Certificate far = certify_distance(a, b, memory);
    folder.add(far);
    folder.add(certify_within(a, b, far.value(), memory));
    folder.add(certify_within(a, b, 0, memory));
}

}  // namespace ecods::check
