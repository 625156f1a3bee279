// ECoDS without a world: the questions of distance.hpp about two posed meshes.
#include <limits>
#include <memory>

#include "ecods/distance.hpp"
#include "engines/distance_engine.hpp"

namespace ecods::bench {

namespace {

// `Question` is called with both bodies, the memory, a witness and the distance times the factor.
template <class Question>
class DistanceEcods final : public DistanceEngine {
  public:
    DistanceEcods(std::span<const scenes::NamedMesh> meshes, double factor, Question question)
        : factor_(factor), question_(question) {
        for (const scenes::NamedMesh& named : meshes) {
            shapes_.push_back(std::make_unique<MeshShape>(named.mesh));
            shapes_.back()->tree_bytes();  // makes the tree
        }
    }

    double ask(const scenes::MeshQuery& query, double d) override {
        return question_(posed(query.a), posed(query.b), memory_, witness_, d * factor_);
    }

  private:
    Posed<MeshShape> posed(const scenes::MeshAt& at) const { return {*shapes_[at.mesh_index], at.pose}; }

    double factor_;
    Question question_;
    std::vector<std::unique_ptr<MeshShape>> shapes_;
    QueryMemory memory_;
    PairWitness witness_;
};

template <class Question>
std::unique_ptr<DistanceEngine> set_up(std::span<const scenes::NamedMesh> meshes, double factor, Question question) {
    return std::make_unique<DistanceEcods<Question>>(meshes, factor, question);
}

using Body = Posed<MeshShape>;

}  // namespace

std::unique_ptr<DistanceEngine> set_up_distance_ecods(std::span<const scenes::NamedMesh> meshes, double factor) {
    return set_up(meshes, factor, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness&, double) {
        return distance(a, b, memory);
    });
}

std::unique_ptr<DistanceEngine> set_up_distance_ecods_witness(std::span<const scenes::NamedMesh> meshes,
                                                              double factor) {
    return set_up(meshes, factor, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness& witness, double) {
        return distance(a, b, memory, witness);
    });
}

std::unique_ptr<DistanceEngine> set_up_distance_ecods_bounds(std::span<const scenes::NamedMesh> meshes, double factor) {
    return set_up(meshes, factor, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness&, double d) {
        const DistanceBounds bounds = distance_bounds(a, b, {.relative = 1e-6}, memory);
        const bool is_inside = bounds.lower <= d && d <= bounds.upper;
        return is_inside ? bounds.upper : std::numeric_limits<double>::quiet_NaN();
    });
}

std::unique_ptr<DistanceEngine> set_up_distance_ecods_closest(std::span<const scenes::NamedMesh> meshes,
                                                              double factor) {
    return set_up(meshes, factor, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness&, double) {
        return closest(a, b, memory).distance;
    });
}

std::unique_ptr<DistanceEngine> set_up_distance_ecods_within(std::span<const scenes::NamedMesh> meshes, double factor) {
    return set_up(meshes, factor, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness&, double d) {
        return within(a, b, d, memory) ? 1.0 : 0.0;
    });
}

}  // namespace ecods::bench
