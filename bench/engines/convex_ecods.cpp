// ECoDS without a world: the questions of solid.hpp about two posed convex solids.
#include <cmath>

#include "ecods/contact.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"
#include "engines/convex_engine.hpp"
#include "engines/own_shapes.hpp"

namespace ecods::bench {

namespace {

using scenes::ConvexQuestion;
using ConvexBody = Posed<ConvexSolid>;
using AskConvex = ConvexAnswer (*)(const ConvexBody& a, const ConvexBody& b, const Ask& ask);

class ConvexEcods final : public Convex::Engine {
  public:
    ConvexEcods(const scenes::ConvexWorkload& workload, AskConvex question, bool has_witnesses = false)
        : posed_(workload.meshes), question_(question), witnesses_(has_witnesses ? workload.queries.size() : 0) {}

    ConvexAnswer ask(const scenes::MeshQuery& query, std::size_t index) override {
        Ask ask(memory_);
        if (!witnesses_.empty()) ask.witness = &witnesses_[index];
        return question_(posed_(query.a), posed_(query.b), ask);
    }

  private:
    OwnShapes<ConvexSolid> posed_;
    AskConvex question_;
    QueryMemory memory_;
    std::vector<PairWitness> witnesses_;  // one a query, or none
};

ConvexAnswer to_answer(const Depth& depth) {
    return {depth.depth, {depth.direction.x(), depth.direction.y(), depth.direction.z()}};
}

ConvexAnswer ask_solid_distance(const ConvexBody& a, const ConvexBody& b, const Ask& ask) {
    return {distance(a, b, ask)};
}
ConvexAnswer ask_solid_closest(const ConvexBody& a, const ConvexBody& b, const Ask& ask) {
    return {closest(a, b, ask).distance};
}
ConvexAnswer ask_depth(const ConvexBody& a, const ConvexBody& b, const Ask& ask) {
    return to_answer(depth(a, b, ask).value());
}

ConvexAnswer ask_patch(const ConvexBody& a, const ConvexBody& b, const Ask& ask) {
    const ContactPatch patch = contact_patch(a, b, {}, ask);
    const Vec3& n = patch.normal;
    return {std::abs(patch.distance), {n.x(), n.y(), n.z()}};
}

}  // namespace

std::vector<ConvexMaker> ecods_convex(ConvexQuestion question) {
    const bool is_depth = question == ConvexQuestion::depth;
    std::vector<ConvexMaker> makers = {
        {.name = "ECoDS convex",
         .use = is_depth ? "depth(), one QueryMemory; rounded once, direction and features by the rule"
                         : "distance(), one QueryMemory; rounded once",
         .is_ecods = true,
         .set_up = makes<ConvexEcods>(is_depth ? ask_depth : ask_solid_distance)},
        {.name = "ECoDS convex, witness",
         .use = "the same, with a PairWitness for each pair, left by the pass before",
         .is_ecods = true,
         .set_up = makes<ConvexEcods>(is_depth ? ask_depth : ask_solid_distance, true)}};
    makers.push_back({.name = "ECoDS convex patch",
                      .use = "contact_patch(): all corners with points of both bodies, middle and gap, rounded once",
                      .is_ecods = true,
                      .set_up = makes<ConvexEcods>(ask_patch)});
    if (!is_depth) {
        makers.push_back({.name = "ECoDS convex closest",
                          .use = "closest(); distance and points rounded once, features by the rule",
                          .is_ecods = true,
                          .set_up = makes<ConvexEcods>(ask_solid_closest)});
    }
    return makers;
}

}  // namespace ecods::bench
