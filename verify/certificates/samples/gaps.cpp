#include "certificates/samples/samples.hpp"

#include <utility>

#include "ecods/distance.hpp"
#include "scenes/mesh_pairs.hpp"
#include "scenes/shapes.hpp"
#include "scenes/ship.hpp"

namespace ecods::certificates {

void make_gap_samples(std::size_t count, std::uint32_t seed, const std::function<void(const Sample&)>& take) {
    QueryMemory memory;
    for (const auto& [name, mesh] : {std::pair{"ship", scenes::ship()},
                                     {"torus_10k", scenes::torus(100, 50, 0.4)},
                                     {"torus_100k", scenes::torus(400, 125, 0.4)}}) {
        const auto shape = std::make_shared<const MeshShape>(mesh);
        for (const scenes::MeshQuery& query : scenes::gap_pairs(name, mesh, 1e-4, count, seed).queries) {
            const Posed<MeshShape> a(*shape, query.a.pose), b(*shape, query.b.pose);
            const double d = distance(a, b, memory);
            if (d == 0) continue;
            take({std::string(name) + ".relation", shape, shape, certify(a, b, memory)});
            take({std::string(name) + ".distance", shape, shape, certify_distance(a, b, memory)});
            take({std::string(name) + ".beyond", shape, shape, certify_within(a, b, d / 2, memory)});
        }
    }
}

}  // namespace ecods::certificates
