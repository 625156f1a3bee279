#include "certificates/samples/samples.hpp"

#include <cmath>
#include <limits>
#include <utility>
#include <variant>

#include "ecods/distance.hpp"
#include "scenes/distance_cases.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/hit_cases.hpp"

namespace ecods::certificates {
namespace {

using Take = std::function<void(const Sample&)>;
using Shape = std::shared_ptr<const MeshShape>;

Shape shape_of(std::shared_ptr<const Mesh> mesh) {
    return std::make_shared<const MeshShape>(std::move(mesh));
}

Shape shape_of(const std::array<Vec3, 3>& corners) {
    return shape_of(Mesh::create({corners[0], corners[1], corners[2]}, {{0, 1, 2}}));
}

void ask_pair(const std::string& name, const Shape& shape_a, const Pose& pose_a, const Shape& shape_b,
              const Pose& pose_b, QueryMemory& memory, const Take& take) {
    const Posed<MeshShape> a(*shape_a, pose_a), b(*shape_b, pose_b);
    const auto give = [&](const char* question, const Certificate& certificate) {
        take({name + ", " + question, shape_a, shape_b, certificate});
    };
    give("relation", certify(a, b, memory));
    give("distance", certify_distance(a, b, memory));
    const double d = distance(a, b, memory), infinity = std::numeric_limits<double>::infinity();
    give("within itself", certify_within(a, b, d, memory));
    give("within infinity", certify_within(a, b, infinity, memory));
    if (d == 0 || d == infinity) return;
    give("within the next higher", certify_within(a, b, std::nextafter(d, infinity), memory));
    give("within the next lower", certify_within(a, b, std::nextafter(d, 0), memory));
    give("within half", certify_within(a, b, d / 2, memory));
    give("within twice", certify_within(a, b, 2 * d, memory));
    give("within 0", certify_within(a, b, 0, memory));
}

}  // namespace

void make_samples(std::size_t count, std::uint32_t seed, const Take& take) {
    scenes::Random random(seed);
    QueryMemory memory;
    const auto for_each = [&](const auto& families, const auto& use) {
        for (const auto& family : families) {
            for (std::size_t k = 0; k < count; ++k) use(std::string(family.name), family.make(random));
        }
    };
    for_each(scenes::hard_families(), [&](const std::string& name, const scenes::PosedPair& pair) {
        ask_pair("hard pairs, " + name, shape_of(pair.a), pair.pose_a, shape_of(pair.b), pair.pose_b, memory, take);
    });
    for_each(scenes::distance_families(), [&](const std::string& name, const scenes::DistanceCase& made) {
        ask_pair("distances, " + name, shape_of(made.a), made.pose_a, shape_of(made.b), made.pose_b, memory, take);
    });
    make_flush_samples(12, seed, take);
    for_each(scenes::hit_families(), [&](const std::string& name, const scenes::HitCase& made) {
        const auto* segment = std::get_if<Segment>(&made.line);
        if (segment == nullptr) return;
        const Shape shape = shape_of(made.mesh);
        take({"hits, " + name, shape, nullptr, certify_hit(*segment, {*shape, made.pose}, memory)});
    });
}

}  // namespace ecods::certificates
