#include "fuzz/script/play.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdlib>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "environment/float_mode.hpp"
#include "environment/instruction_sets.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/box_questions.hpp"
#include "fuzz/checks/checks.hpp"
#include "fuzz/checks/contact_questions.hpp"
#include "fuzz/checks/convex_questions.hpp"
#include "fuzz/checks/distance_questions.hpp"
#include "fuzz/checks/solid_questions.hpp"
#include "fuzz/checks/way_questions.hpp"
#include "fuzz/script/bad_calls.hpp"
#include "fuzz/script/manners.hpp"
#include "fuzz/script/schedule.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/thread_executor.hpp"

namespace ecods::fuzz {
namespace {

using environment::float_modes;
using environment::FloatMode;
using environment::InFloatMode;

constexpr std::array broad_phases = {BroadPhaseKind::brute_force, BroadPhaseKind::sweep_and_prune,
                                     BroadPhaseKind::kept_candidates, BroadPhaseKind::automatic};

class Player {
  public:
    Player(const PlayOptions& options, Counters& counters)
        : options_(options),
          counters_(counters),
          certificates_(options.certificates, options.canary == Canary::proof) {}

    void make(const Call& call);
    void finish();
    std::size_t update_count() const noexcept { return update_count_; }

  private:
    void apply(const Call& call);
    void update(const Update& call);
    void pass_over();
    void check();
    void check_rest() const;
    void check_fresh(const World& world);
    void check_fresh_in(const FloatMode& mode, const World& world);
    void check_ways();
    void check_tampering(const World& world);
    void check_replay();
    void count_work();
    void count_instruction_sets();
    void plant_canary(std::vector<BodyPair>& expected) const;

    PlayOptions options_;
    Counters& counters_;
    Scene scene_;
    Truth truth_{mesh_of};
    BoxQuestions questions_;
    DistanceQuestions distances_;
    SolidQuestions solids_;
    Certificates certificates_;
    std::optional<Manner> manner_;     // of the next call
    std::vector<BodyPair> colliding_;  // at the last update
    std::vector<BodyPair> close_;
    std::uint64_t tests_ = 0;  // two-body tests up to then
    bool is_resting_ = false;  // no call since
    std::size_t update_count_ = 0;
    std::size_t check_count_ = 0;  // updates whose lists were read
};

void Player::make(const Call& call) {
    if (const auto* bad = std::get_if<BadCall>(&call)) {
        make_bad_call(*bad, scene_, counters_);
    } else if (const auto* manner = std::get_if<Manner>(&call)) {
        manner_ = *manner;
    } else if (const auto* of_update = std::get_if<Update>(&call)) {
        update(*of_update);
    } else {
        apply(call);
        if (std::holds_alternative<MakeAgain>(call)) colliding_ = close_ = {};
        is_resting_ = false;
    }
}

void Player::apply(const Call& call) {
    if (!manner_) return scene_.apply(call);
    make_in_manner(*std::exchange(manner_, std::nullopt), call, scene_, counters_);
}

void Player::update(const Update& call) {
    // One that did not throw was an update like any other.
    const bool is_done = call.fails && !scene_.update_failing(counters_);
    if (!is_done) {
        count_instruction_sets();
        apply(call);
    }
    if (is_resting_ && !call.fails) check_rest();
    if (call.is_quiet) {
        pass_over();
    } else {
        check();
    }
    if (call.digest && *call.digest != scene_.worlds[0].world().digest()) {
        throw CheckFailed("digest of the trace", fmt::format("{:x}", *call.digest),
                          fmt::format("{:x}", scene_.worlds[0].world().digest()));
    }
    is_resting_ = true;
    ++update_count_;
}

// Lists that are made when they are read have more to catch up with next time.
void Player::pass_over() {
    ++counters_["frames whose lists nobody reads"];
    const World& world = scene_.worlds[0].world();
    colliding_ = numbers_of(world.colliding_pairs());
    close_ = numbers_of(world.close_pairs());
    tests_ = world.statistics().two_body_tests;
}

void Player::check_rest() const {
    for (const ScriptedWorld& scripted : scene_.worlds) {
        const std::uint64_t tests = scripted.world().statistics().two_body_tests;
        if (tests != tests_) {
            throw CheckFailed("rest", fmt::format("{} two-body tests", tests_), fmt::format("{}", tests));
        }
    }
}

void Player::check() {
    ++counters_["frames"];
    if (is_resting_) ++counters_["frames at rest"];
    World& first = scene_.worlds[0].world();
    // Questions are the same code in all worlds: one is asked at a time.
    const auto sets = environment::supported_instruction_sets();
    const Turn turn = scheduled_turn(check_count_++, scene_.worlds.size(), sets.size(), float_modes.size());
    World& asked = scene_.worlds[turn.world].world();
    for (const ScriptedWorld& scripted : scene_.worlds) check_state(scripted, scene_.model);
    truth_.look_at(first);
    check_boxes(first, truth_, counters_);
    const FloatMode& mode = float_modes[turn.mode];
    distances_.choose(asked, truth_, static_cast<std::uint32_t>(update_count_));
    solids_.choose(asked, truth_, static_cast<std::uint32_t>(update_count_));
    {
        const environment::InstructionSetLimit limit(sets[turn.set]);
        const InFloatMode in_mode(mode);
        check_answers(asked, truth_, counters_);
        distances_.check(counters_);
        solids_.check(counters_);
        certificates_.ask(asked, truth_, static_cast<std::uint32_t>(update_count_), counters_);
    }
    ++counters_[std::string("checked: answers with instructions of ") + environment::name(sets[turn.set])];
    ++counters_[std::string("checked: answers, ") + mode.name];
    auto expected = true_collisions(first, truth_);
    plant_canary(expected);
    for (ScriptedWorld& scripted : scene_.worlds) {
        World& world = scripted.world();
        check_candidates(world, counters_);
        check_collisions(world, expected, truth_);
        check_events(world, colliding_);
        check_invariants(world);
        if (&world != &first) check_same(first, world, counters_);
        tests_ = world.statistics().two_body_tests;
    }
    check_close_pairs(asked, close_, truth_, static_cast<std::uint32_t>(update_count_), counters_);
    check_fresh(asked);
    const auto bodies = asked.bodies();
    if (!bodies.empty()) {
        check_queries(asked, truth_, bodies[update_count_ % bodies.size()], counters_);
        check_nearest(asked, bodies[update_count_ % bodies.size()], counters_);
    }
    check_ways();
    questions_.follow(first);
    questions_.check(static_cast<std::uint32_t>(update_count_), counters_);
    check_tampering(asked);
    colliding_ = std::move(expected);
    close_ = numbers_of(first.close_pairs());
}

// Every world is asked: the broad phases have their part in the answers. Not all at every frame, as all bodies are
// asked one by one beside it.
void Player::check_ways() {
    std::array<World*, 4> worlds;
    for (std::size_t i = 0; i < worlds.size(); ++i) worlds[i] = &scene_.worlds[i].world();
    const auto seed = static_cast<std::uint32_t>(update_count_);
    check_hits(worlds, seed, counters_);
    check_solids(worlds, seed, counters_);
    check_convex(worlds, seed, counters_);
    if (check_count_ % 2 == 0) check_casts(worlds, seed, counters_);
    if (check_count_ % 2 == 1) check_contacts(worlds, seed, counters_);
    // Rounded bodies between poses, or turning, are refused (rounded.hpp).
    if (truth_.has_rounded()) return;
    if (check_count_ % 2 == 1) check_meetings(worlds, seed, counters_);
    if (check_count_ % 3 == 1) check_turns(worlds, seed, counters_);
}

// In the environment of every program as it starts, and in another one: by turns where worlds are large.
void Player::check_fresh(const World& world) {
    constexpr std::size_t large_min = 100;
    const bool is_large = world.statistics().body_count >= large_min;
    if (!is_large || update_count_ % 2 == 0) check_fresh_in(float_modes[0], world);
    if (!is_large) check_fresh_in(float_modes[1 + update_count_ % (float_modes.size() - 1)], world);
    if (is_large && update_count_ % 2 == 1) check_fresh_in(float_modes[update_count_ / 2 % float_modes.size()], world);
}

// With another broad phase and another number of workers each time.
void Player::check_fresh_in(const FloatMode& mode, const World& world) {
    const auto order = static_cast<std::uint32_t>(update_count_ + 1);
    ++counters_[std::string("checked: against a fresh world, ") + mode.name];
    const InFloatMode in_mode(mode);
    check_fresh_world(world, {.options = {.broad_phase = broad_phases[order / 4 % 4],
                                          .executor = std::make_shared<ThreadExecutor>(1 + order % 4)},
                              .order = order,
                              .has_own_environment = &mode != float_modes.data(),
                              .set_up = [](World& made) { UserTests().add_to(made); }});
}

// A shape of the caller's own that changes under its body is found.
void Player::check_tampering(const World& world) {
    for (const BodyId body : world.bodies()) {
        const auto* shape = dynamic_cast<const UserShape*>(world.shape(body).get());
        if (shape == nullptr) continue;
        bool is_found = false;
        shape->tamper(update_count_ % 2 == 0 ? UserShape::Tampering::digest : UserShape::Tampering::box);
        try {
            world.check_invariants();
        } catch (const ShapeChanged& error) {
            is_found = error.body == body && error.kind == shape->kind();
        }
        shape->tamper(UserShape::Tampering::none);
        if (!is_found) throw CheckFailed("unreported change of a shape", "ShapeChanged of its body", "nothing");
        ++counters_["checked: unreported change of a shape"];
        return;
    }
}

void Player::plant_canary(std::vector<BodyPair>& expected) const {
    if (options_.canary == Canary::none || options_.canary == Canary::proof || expected.empty()) return;
    if (options_.canary == Canary::crash) std::abort();
    for (volatile bool goes_on = true; options_.canary == Canary::hang && goes_on;) {
    }
    expected.erase(expected.begin());
}

void Player::finish() {
    count_work();
    check_replay();
    certificates_.check(counters_);
}

// In another world than it was traced in.
void Player::check_replay() {
    ReplayOptions reading;
    reading.broad_phase = broad_phases[(update_count_ + 1) % broad_phases.size()];
    reading.checks_invariants = true;
    reading.set_up = [](World& world) { UserTests().add_to(world); };
    reading.read_shape = [](ShapeKind kind, std::string_view text) {
        return std::make_shared<UserShape>(read_user_mesh(text), kind);
    };
    World& world = scene_.worlds[update_count_ % scene_.worlds.size()].world();
    check_trace(world, {.write_shape = write_user_shape, .questions = true}, reading);
    ++counters_["checked: trace and replay"];
}

// A world that was updated with narrow instructions is compared with one that was updated with wide ones (check_same).
void Player::count_instruction_sets() {
    for (std::size_t i = 0; i < scene_.worlds.size(); ++i) {
        ++counters_[std::string("updates with instructions of ") + environment::name(scene_.instruction_set(i))];
    }
}

void Player::count_work() {
    const StageCounts counts = scene_.worlds[0].world().statistics().queries.stages;
    counters_["stages: triangle tests"] += counts.triangle_tests;
    for (const Stage& stage : stages) counters_[std::string("stages: ") + stage.name] += counts.*stage.count;
    // What the broad phases went through, each in the world that it has to itself.
    const auto of = [&](std::size_t i) { return scene_.worlds[i].world().statistics().broad_phase; };
    counters_["broad phases: swaps of sweep and prune"] += of(1).swaps;
    counters_["broad phases: boxes that left their margin"] += of(2).escaped;
    counters_["broad phases: rebuilds"] += of(2).rebuilds;
    counters_["broad phases: switches of the automatic one"] += of(3).switches;
}

}  // namespace

void play(const Script& script, const PlayOptions& options, Counters& counters) {
    Player player(options, counters);
    try {
        for (const Call& call : script) player.make(call);
        player.finish();
    } catch (const CheckFailed& error) {
        throw Failure{player.update_count(), error.check, error.expected, error.got};
    } catch (const std::exception& error) {
        throw Failure{player.update_count(), "unexpected error", "none", error.what()};
    }
}

}  // namespace ecods::fuzz
