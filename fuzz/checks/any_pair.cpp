#include "fuzz/checks/any_pair.hpp"

#include <cstdint>

namespace ecods::fuzz {
namespace {

const TrueBody& any(const std::vector<const TrueBody*>& bodies, scenes::Random& random) {
    return *bodies[random.below(static_cast<std::uint32_t>(bodies.size()))];
}

}  // namespace

AnyPair::AnyPair(const World& world, const Truth& truth) {
    for (const TrueBody& body : truth.bodies()) {
        if (dynamic_cast<const MeshShape*>(world.shape(body.id).get()) == nullptr) continue;
        all_.push_back(&body);
        if (body.is_changed) changed_.push_back(&body);
    }
}

std::optional<std::array<const TrueBody*, 2>> AnyPair::draw(scenes::Random& random,
                                                            std::size_t triangle_pairs_max) const {
    if (all_.size() < 2) return std::nullopt;
    const TrueBody& a = any(changed_.empty() ? all_ : changed_, random);
    const TrueBody& b = any(all_, random);
    if (a.id == b.id || a.mesh->triangles().size() * b.mesh->triangles().size() > triangle_pairs_max)
        return std::nullopt;
    return std::array{&a, &b};
}

}  // namespace ecods::fuzz
