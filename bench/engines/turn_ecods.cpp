// ECoDS without a world: the questions of turn.hpp, and those of cast.hpp about the same poses.
#include <limits>

#include "engines/own_turns.hpp"
#include "engines/turn_engine.hpp"

namespace ecods::bench {

namespace {

double time_of(const std::optional<FirstContact>& contact) {
    return contact ? contact->time : std::numeric_limits<double>::quiet_NaN();
}

class TurnEcods final : public Turns::Engine {
  public:
    explicit TurnEcods(const scenes::TurnWorkload& workload) : turns_(workload) {}

    double ask(const scenes::TurnQuery& query, std::size_t /*index*/) override { return time_of(turns_.turn(query)); }

  private:
    OwnTurns turns_;
};

class StraightEcods final : public Turns::Engine {
  public:
    explicit StraightEcods(const scenes::TurnWorkload& workload) : turns_(workload) {}

    double ask(const scenes::TurnQuery& query, std::size_t /*index*/) override {
        return time_of(turns_.go_straight(query));
    }

  private:
    OwnTurns turns_;
};

}  // namespace

std::vector<TurnMaker> ecods_turns() {
    return {{.name = "ECoDS",
             .use = "cast() of a turning body, one QueryMemory; exact, rounded once",
             .is_ecods = true,
             .set_up = makes<TurnEcods>()},
            {.name = own_straight_cast,
             .use = "cast() between the poses at the start and at the end: each point goes straight, which is another "
                    "motion",
             .is_ecods = true,
             .traits = {.answer = TurnAnswer::straight},
             .set_up = makes<StraightEcods>()}};
}

}  // namespace ecods::bench
