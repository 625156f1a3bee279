// ECoDS without a world: the questions of convex_solid.hpp and depth.hpp about two posed solids.
#include "ecods/convex_solid.hpp"
#include "ecods/depth.hpp"
#include "engines/convex_engine.hpp"
#include "engines/own_shapes.hpp"

namespace ecods::bench {

namespace {

using scenes::ConvexQuestion;
using ConvexBody = Posed<ConvexSolid>;
using AskConvex = ConvexAnswer (*)(const ConvexBody& a, const ConvexBody& b, QueryMemory& memory, PairWitness& witness);

class ConvexEcods final : public Convex::Engine {
  public:
    ConvexEcods(const scenes::ConvexWorkload& workload, AskConvex question)
        : posed_(workload.meshes), question_(question), witnesses_(workload.queries.size()) {}

    ConvexAnswer ask(const scenes::MeshQuery& query, std::size_t index) override {
        return question_(posed_(query.a), posed_(query.b), memory_, witnesses_[index]);
    }

  private:
    OwnShapes<ConvexSolid> posed_;
    AskConvex question_;
    QueryMemory memory_;
    std::vector<PairWitness> witnesses_;
};

ConvexAnswer to_answer(const Depth& depth) {
    return {depth.depth, {depth.direction.x(), depth.direction.y(), depth.direction.z()}};
}

ConvexAnswer ask_solid_distance(const ConvexBody& a, const ConvexBody& b, QueryMemory& memory,
                                PairWitness& /*witness*/) {
    return {solid_distance(a, b, memory)};
}
ConvexAnswer ask_solid_distance_by_witness(const ConvexBody& a, const ConvexBody& b, QueryMemory& memory,
                                           PairWitness& witness) {
    return {solid_distance(a, b, memory, witness)};
}
ConvexAnswer ask_solid_closest(const ConvexBody& a, const ConvexBody& b, QueryMemory& memory,
                               PairWitness& /*witness*/) {
    const auto points = solid_closest(a, b, memory);
    return {points ? points->distance : 0};
}
ConvexAnswer ask_depth(const ConvexBody& a, const ConvexBody& b, QueryMemory& memory, PairWitness& /*witness*/) {
    return to_answer(depth(a, b, memory).value());
}
ConvexAnswer ask_depth_by_witness(const ConvexBody& a, const ConvexBody& b, QueryMemory& memory, PairWitness& witness) {
    return to_answer(depth(a, b, memory, witness).value());
}

}  // namespace

std::vector<ConvexMaker> ecods_convex(ConvexQuestion question) {
    const bool is_depth = question == ConvexQuestion::depth;
    std::vector<ConvexMaker> makers = {
        {.name = "ECoDS convex",
         .use = is_depth ? "depth(), one QueryMemory; rounded once, direction and features by the rule"
                         : "solid_distance(), one QueryMemory; rounded once",
         .is_ecods = true,
         .set_up = makes<ConvexEcods>(is_depth ? ask_depth : ask_solid_distance)},
        {.name = "ECoDS convex, witness",
         .use = "the same, with a PairWitness for each pair, left by the pass before",
         .is_ecods = true,
         .set_up = makes<ConvexEcods>(is_depth ? ask_depth_by_witness : ask_solid_distance_by_witness)}};
    if (!is_depth) {
        makers.push_back({.name = "ECoDS convex closest",
                          .use = "solid_closest(); distance and points rounded once, features by the rule",
                          .is_ecods = true,
                          .set_up = makes<ConvexEcods>(ask_solid_closest)});
    }
    return makers;
}

}  // namespace ecods::bench
