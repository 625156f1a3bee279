// ECoDS without a world: the questions of rounded.hpp about two posed bodies.
#include <memory>

#include "ecods/builders.hpp"
#include "ecods/rounded.hpp"
#include "engines/rounded_engine.hpp"

namespace ecods::bench {

namespace {

RoundAnswer to_answer(double distance, const Vec3& a, const Vec3& b) {
    return {distance, {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}};
}

template <class A, class B>
RoundAnswer ask_own(RoundQuestion question, const Posed<A>& a, const Posed<B>& b, const Ask& ask) {
    switch (question) {
        case RoundQuestion::intersects:
            return {intersects(a, b, ask) ? 1.0 : 0.0};
        case RoundQuestion::distance:
            return {distance(a, b, ask)};
        case RoundQuestion::signed_distance:
            return {signed_distance(a, b, ask).distance};
        default:
            const ClosestPoints found = closest(a, b, ask);
            return to_answer(found.distance, found.point_a, found.point_b);
    }
}

class RoundEcods final : public Round::Engine {
  public:
    explicit RoundEcods(const RoundWorkload& workload) : question_(workload.question) {
        for (const RoundBody& body : workload.bodies) {
            const Vec3 end(0, 0, body.size);
            balls_.push_back(body.kind == RoundKind::sphere    ? sphere(body.radius)
                             : body.kind == RoundKind::capsule ? capsule(-end, end, body.radius)
                                                               : nullptr);
            boxes_.push_back(body.kind == RoundKind::box ? box(Vec3::Constant(2 * body.size)) : nullptr);
        }
    }

    RoundAnswer ask(const RoundQuery& query, std::size_t /*index*/) override {
        const Posed<Rounded> a(*balls_[query.a.body_index], query.a.pose);
        if (const ConvexSolid* const solid = boxes_[query.b.body_index].get()) {
            return ask_own(question_, a, Posed<MeshShape>(*solid, query.b.pose), memory_);
        }
        return ask_own(question_, a, Posed<Rounded>(*balls_[query.b.body_index], query.b.pose), memory_);
    }

  private:
    RoundQuestion question_;
    std::vector<std::shared_ptr<const Rounded>> balls_;
    std::vector<std::shared_ptr<const ConvexSolid>> boxes_;
    QueryMemory memory_;
};

}  // namespace

std::vector<RoundMaker> ecods_round() {
    return {{.name = "ECoDS rounded",
             .use =
                 "sphere(), capsule(), box(); intersects(), distance(), signed_distance(), which has points, too, or "
                 "closest(), with one QueryMemory; rounded once",
             .is_ecods = true,
             .set_up = makes<RoundEcods>()}};
}

}  // namespace ecods::bench
