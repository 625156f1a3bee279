// ECoDS without a world: the questions of distance.hpp about two posed meshes.
#include "ecods/distance.hpp"

#include <limits>

#include "engines/distance_engine.hpp"
#include "engines/own_shapes.hpp"

namespace ecods::bench {

namespace {

// A question has the two bodies, and how it is asked. `d` is the distance times the engine's factor, for questions
// about it.
struct DistanceAsked {
    const Posed<MeshShape> a, b;
    const double d;
    const Ask ask;
};
using AskDistance = double (*)(const DistanceAsked& asked);

class DistanceEcods final : public Distance::Engine {
  public:
    // A factor above 0 has the distances found here, untimed.
    DistanceEcods(const scenes::DistanceWorkload& workload, AskDistance question, double factor,
                  bool has_witness = false)
        : posed_(workload.meshes), question_(question), numbers_(workload.queries.size()) {
        if (has_witness) ask_.witness = &witness_;
        for (std::size_t i = 0; i < numbers_.size() && factor > 0; ++i) {
            const auto& [a, b] = workload.queries[i];
            numbers_[i] = factor * distance(posed_(a), posed_(b), memory_);
        }
    }

    double ask(const scenes::MeshQuery& query, std::size_t index) override {
        return question_({posed_(query.a), posed_(query.b), numbers_[index], ask_});
    }

  private:
    OwnShapes<MeshShape> posed_;
    AskDistance question_;
    std::vector<double> numbers_;
    QueryMemory memory_;
    PairWitness witness_;
    Ask ask_{memory_};
};

double ask_distance(const DistanceAsked& asked) {
    return distance(asked.a, asked.b, asked.ask);
}
double ask_bounds(const DistanceAsked& asked) {
    const DistanceBounds bounds = distance_bounds(asked.a, asked.b, {.relative = 1e-6}, asked.ask);
    const bool is_inside = bounds.lower <= asked.d && asked.d <= bounds.upper;
    return is_inside ? bounds.upper : std::numeric_limits<double>::quiet_NaN();
}
double ask_closest(const DistanceAsked& asked) {
    return closest(asked.a, asked.b, asked.ask).distance;
}
double ask_point(const DistanceAsked& asked) {
    return signed_distance(asked.a.pose.t, asked.b, asked.ask);
}
double ask_closest_point(const DistanceAsked& asked) {
    return closest(asked.a.pose.t, asked.b, asked.ask).distance;
}
double ask_within(const DistanceAsked& asked) {
    return within(asked.a, asked.b, asked.d, asked.ask) ? 1 : 0;
}

}  // namespace

std::vector<DistanceMaker> ecods_distance() {
    return {{.name = own_distance,
             .use = "distance(), one QueryMemory; rounded once",
             .is_ecods = true,
             .set_up = makes<DistanceEcods>(ask_distance, 0.0)},
            {.name = "ECoDS, witness",
             .use = "distance() with one PairWitness for all of a path; rounded once",
             .is_ecods = true,
             .traits = {.is_for_paths = true},
             .set_up = makes<DistanceEcods>(ask_distance, 0.0, true)},
            {.name = "ECoDS bounds",
             .use = "distance_bounds(), relative 1e-6; an interval that contains the distance",
             .is_ecods = true,
             .traits = {.answer = DistanceAnswer::bounds},
             .set_up = makes<DistanceEcods>(ask_bounds, 1.0)},
            {.name = "ECoDS closest",
             .use = "closest(); distance and points rounded once, features by the rule",
             .is_ecods = true,
             .set_up = makes<DistanceEcods>(ask_closest, 0.0)},
            {.name = "ECoDS point",
             .use = "signed_distance() of a point; rounded once",
             .is_ecods = true,
             .traits = {.is_for_points = true},
             .set_up = makes<DistanceEcods>(ask_point, 0.0)},
            {.name = "ECoDS closest point",
             .use = "closest() of a point; distance and point rounded once, feature by the rule",
             .is_ecods = true,
             .traits = {.is_for_points = true},
             .set_up = makes<DistanceEcods>(ask_closest_point, 0.0)}};
}

std::vector<DistanceMaker> ecods_within() {
    std::vector<DistanceMaker> makers;
    for (const auto& [factor, name] : {std::pair(0.5, "ECoDS within 0.5"), std::pair(0.99, "ECoDS within 0.99"),
                                       std::pair(1.01, "ECoDS within 1.01"), std::pair(2.0, "ECoDS within 2")}) {
        makers.push_back({.name = name,
                          .use = "within() of the distance times that; decided for the real number",
                          .is_ecods = true,
                          .traits = {.answer = DistanceAnswer::within, .factor = factor},
                          .set_up = makes<DistanceEcods>(ask_within, factor)});
    }
    return makers;
}

}  // namespace ecods::bench
