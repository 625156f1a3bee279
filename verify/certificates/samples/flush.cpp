#include <memory>
#include <utility>
#include <vector>

#include "certificates/samples/samples.hpp"
#include "scenes/random.hpp"

namespace ecods::certificates {

std::shared_ptr<const MeshShape> plate(std::uint32_t across) {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint32_t y = 0; y <= across; ++y) {
        for (std::uint32_t x = 0; x <= across; ++x) {
            vertices.emplace_back(static_cast<double>(x) / across, static_cast<double>(y) / across, 0);
            if (x == across || y == across) continue;
            const std::uint32_t i = y * (across + 1) + x;
            triangles.push_back({i, i + 1, i + across + 1});
            triangles.push_back({i + 1, i + across + 2, i + across + 1});
        }
    }
    return std::make_shared<const MeshShape>(Mesh::create(std::move(vertices), std::move(triangles)));
}

void make_flush_samples(std::uint32_t across, std::uint32_t seed, const std::function<void(const Sample&)>& take) {
    scenes::Random random(seed);
    QueryMemory memory;
    const auto shape = plate(across);
    for (const double gap : {0.0, 0x1p-52, 0x1p-40, 0x1p-20}) {
        for (const bool is_turned : {false, true}) {
            Pose a, b;
            if (is_turned) a = Pose::from_quaternion(random.rotation(), random.direction());
            b = a;
            b.t += gap * a.R.col(2) + random.uniform(0, 1) * (a.R.col(0) + a.R.col(1));
            if (!is_turned) b.t[2] = gap;
            take({"plates, relation", shape, shape, certify({*shape, a}, {*shape, b}, memory)});
            take({"plates, distance", shape, shape, certify_distance({*shape, a}, {*shape, b}, memory)});
        }
    }
}

}  // namespace ecods::certificates
