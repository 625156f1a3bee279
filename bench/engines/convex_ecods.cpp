// ECoDS without a world: the questions of convex_solid.hpp and depth.hpp about two posed solids.
#include <limits>
#include <memory>
#include <vector>

#include "ecods/convex_solid.hpp"
#include "ecods/depth.hpp"
#include "engines/convex_engine.hpp"

namespace ecods::bench {

namespace {

using scenes::ConvexQuestion;
using Body = Posed<ConvexSolid>;

class ConvexSolids : public ConvexEngine {
  public:
    explicit ConvexSolids(const scenes::ConvexWorkload& workload) {
        for (const scenes::NamedMesh& named : workload.pairs.meshes)
            solids_.push_back(std::make_unique<ConvexSolid>(named.mesh));
    }

  protected:
    Body posed(const scenes::MeshAt& at) const { return {*solids_[at.mesh_index], at.pose}; }

    QueryMemory memory_;

  private:
    std::vector<std::unique_ptr<ConvexSolid>> solids_;
};

// `Question` is called with both bodies, the memory and what is kept for the query.
template <class Question>
class ConvexEcods final : public ConvexSolids {
  public:
    ConvexEcods(const scenes::ConvexWorkload& workload, Question question)
        : ConvexSolids(workload), question_(question), witnesses_(workload.pairs.queries.size()) {}

    ConvexAnswer ask(const scenes::MeshQuery& query, std::size_t index) override {
        return question_(posed(query.a), posed(query.b), memory_, witnesses_[index]);
    }

  private:
    Question question_;
    std::vector<PairWitness> witnesses_;
};

template <class Question>
std::unique_ptr<ConvexEngine> set_up(const scenes::ConvexWorkload& workload, Question question) {
    return std::make_unique<ConvexEcods<Question>>(workload, question);
}

ConvexAnswer to_answer(const Depth& depth) {
    return {depth.depth, depth.direction};
}

}  // namespace

std::unique_ptr<ConvexEngine> set_up_convex_ecods(const scenes::ConvexWorkload& workload) {
    if (workload.question == ConvexQuestion::depth) {
        return set_up(workload, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness&) {
            return to_answer(depth(a, b, memory));
        });
    }
    return set_up(workload, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness&) {
        return ConvexAnswer{solid_distance(a, b, memory)};
    });
}

std::unique_ptr<ConvexEngine> set_up_convex_ecods_witness(const scenes::ConvexWorkload& workload) {
    if (workload.question == ConvexQuestion::depth) {
        return set_up(workload, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness& witness) {
            return to_answer(depth(a, b, memory, witness));
        });
    }
    return set_up(workload, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness& witness) {
        return ConvexAnswer{solid_distance(a, b, memory, witness)};
    });
}

std::unique_ptr<ConvexEngine> set_up_convex_ecods_closest(const scenes::ConvexWorkload& workload) {
    return set_up(workload, [](const Body& a, const Body& b, QueryMemory& memory, PairWitness&) {
        const auto points = solid_closest(a, b, memory);
        return ConvexAnswer{points ? points->distance : 0};
    });
}

}  // namespace ecods::bench
