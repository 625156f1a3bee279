// Casts and moves in a world, beside the same put together from questions about two bodies.
#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "ecods/broad_phase.hpp"
#include "ecods/cast.hpp"
#include "engines/world_bodies.hpp"
#include "harness/statistics.hpp"
#include "harness/stopwatch.hpp"
#include "scenes/random.hpp"
#include "scenes/room.hpp"
#include "suites/comparison.hpp"
#include "suites/parts.hpp"

namespace ecods::bench {

namespace {

// Reaches so far beyond as rounding might.
Aabb swept(const Aabb& box, const Vec3& motion) {
    const Vec3 margin = 0x1p-40 * (box.max.cwiseAbs() + box.min.cwiseAbs() + motion.cwiseAbs());
    const Aabb hull = merge(box, {box.min + motion, box.max + motion});
    return {hull.min - margin, hull.max + margin};
}

// Ships of the report's room in a world, and its next frames.
class Ships {
  public:
    Ships(std::size_t count, std::size_t frames)
        : scene_(scenes::room({.ship_count = count,
                               .frame_count = frames,
                               .side = scenes::calibrated_side_by_density(count),
                               .seed = 10})),
          shape_(scene_.meshes.front().mesh),
          bodies_(scene_) {
        for (const scenes::SceneBody& body : scene_.bodies) poses_.push_back(body.pose);
        bodies_.world.update();
    }

    struct Answer {
        std::size_t a = 0, b = 0;
        FirstContact contact;
        friend bool operator==(const Answer&, const Answer&) = default;
    };
    using Answers = std::vector<Answer>;

    std::size_t frame_count() const { return scene_.frames.size(); }
    std::size_t count() const { return poses_.size(); }

    // Of the first contact of each of some bodies: by the world, and by two-body questions.
    Answers casts(std::span<const Vec3> motions) {
        Answers answers;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            const auto met = bodies_.world.cast(bodies_[i], motions[i], 1, memory_);
            if (met) answers.push_back({i, bodies_.index_of(met->body), met->contact});
        }
        return answers;
    }
    Answers casts_by_pairs(std::span<const Vec3> motions) {
        Answers answers;
        for (std::size_t i = 0; i < motions.size(); ++i) {
            std::optional<Answer> first;
            for (const BodyId id : bodies_.world.overlapping_bodies(swept(bodies_.world.box(bodies_[i]), motions[i]))) {
                const std::size_t other = bodies_.index_of(id);
                if (other == i) continue;
                const auto contact = cast({shape_, poses_[i]}, motions[i], {shape_, poses_[other]}, 1, memory_);
                if (contact && (!first || contact->time < first->contact.time)) first = {i, other, *contact};
            }
            if (first) answers.push_back(*first);
        }
        return answers;
    }

    // Of all pairs that meet on the way to the poses of a frame.
    Answers meetings(std::size_t frame) {
        Answers answers;
        const std::vector<Pose> to = poses_at(frame);
        for (const Meeting& meeting : bodies_.world.meetings(bodies_.ids(), to, memory_))
            answers.push_back(
                {bodies_.index_of(meeting.bodies.a), bodies_.index_of(meeting.bodies.b), meeting.contact});
        return answers;
    }
    Answers meetings_by_pairs(std::size_t frame) {
        const std::vector<Pose> to = poses_at(frame);
        const std::unique_ptr<BroadPhase> broad_phase = make_broad_phase(BroadPhaseKind::automatic);
        for (std::size_t i = 0; i < poses_.size(); ++i)
            broad_phase->add(static_cast<ProxyIndex>(i),
                             swept(merge(shape_.box(poses_[i]), shape_.box(to[i])), {0, 0, 0}));
        broad_phase->update();
        Answers answers;
        for (const ProxyPair& pair : broad_phase->pairs()) {
            const auto contact = cast(Moving<MeshShape>(shape_, poses_[pair.a], to[pair.a]),
                                      Moving<MeshShape>(shape_, poses_[pair.b], to[pair.b]), 1, memory_);
            if (contact) answers.push_back({pair.a, pair.b, *contact});
        }
        std::ranges::sort(answers, {},
                          [](const Answer& answer) { return std::tuple(answer.contact.time, answer.a, answer.b); });
        return answers;
    }

    // Brings the world to the poses of a frame; what that takes is what collisions there cost.
    void go_to(std::size_t frame) {
        poses_ = poses_at(frame);
        bodies_.world.set_poses(bodies_.ids(), poses_);
        bodies_.world.update();
    }

  private:
    std::vector<Pose> poses_at(std::size_t frame) const {
        std::vector<Pose> poses = poses_;
        for (const scenes::Move& move : scene_.frames[frame].moves) poses[move.body_index] = move.pose;
        return poses;
    }

    scenes::Scene scene_;
    MeshShape shape_;
    WorldBodies bodies_;
    std::vector<Pose> poses_;
    QueryMemory memory_;
};

template <class Call>
double us_of(const Call& call) {
    const Stopwatch watch;
    call();
    return watch.nanoseconds() / 1000;
}

Table world_cast_table(Ships& ships, std::size_t repetition_count, bool& is_right) {
    Table table{
        .title = fmt::format("A world of {} ships: one is translated, which does it meet first?", ships.count()),
        .header = {"motion in ships", "us/cast", "by pairs", "times as fast", "meet"}};
    table.notes = {
        "By pairs: the bodies whose boxes meet the box of the way, each asked by cast() of two bodies. Both answer the "
        "same bits, or the run fails. Motions in random directions, of the first thousand ships; medians."};
    for (const double ship_lengths : {0.05, 1.0, 10.0}) {
        scenes::Random random(31);
        std::vector<Vec3> motions;
        while (motions.size() < std::min<std::size_t>(ships.count(), 1000))
            motions.push_back(2 * ship_lengths * random.direction());
        std::vector<double> us, us_by_pairs;
        Ships::Answers answers, by_pairs;
        for (std::size_t repetition = 0; repetition <= repetition_count; ++repetition) {
            const double own = us_of([&] { answers = ships.casts(motions); });
            const double other = us_of([&] { by_pairs = ships.casts_by_pairs(motions); });
            is_right &= answers == by_pairs;
            if (repetition == 0) continue;
            us.push_back(own / static_cast<double>(motions.size()));
            us_by_pairs.push_back(other / static_cast<double>(motions.size()));
        }
        table.rows.push_back({fmt::format("{}", ship_lengths), fmt::format("{:.2f}", median(us)),
                              fmt::format("{:.2f}", median(us_by_pairs)),
                              fmt::format("{:.2f}", times_as_fast(us, us_by_pairs)),
                              fmt::format("{} of {}", answers.size(), motions.size())});
    }
    return table;
}

Table meeting_table(Ships& ships, bool& is_right) {
    Table table;
    table.title = fmt::format("A world of {} ships: which meet on the way to the next frame?", ships.count());
    table.header = {"frames", "ms/frame", "by pairs", "times as fast", "update", "of an update", "meetings a frame"};
    table.notes = {
        "By pairs: a broad phase of the boxes of all ways, and cast() of two moving bodies for each pair of boxes that "
        "overlap. Both answer the same bits, or the run fails. Update: set_poses() and update(), which finds those "
        "that collide at the end. Medians over the frames."};
    std::vector<double> us, us_by_pairs, us_of_update;
    std::size_t meeting_count = 0;
    for (std::size_t frame = 0; frame < ships.frame_count(); ++frame) {
        Ships::Answers answers, by_pairs;
        us.push_back(us_of([&] { answers = ships.meetings(frame); }));
        us_by_pairs.push_back(us_of([&] { by_pairs = ships.meetings_by_pairs(frame); }));
        us_of_update.push_back(us_of([&] { ships.go_to(frame); }));
        is_right &= answers == by_pairs;
        meeting_count += answers.size();
    }
    table.rows.push_back(
        {fmt::format("{}", ships.frame_count()), fmt::format("{:.2f}", median(us) / 1000),
         fmt::format("{:.2f}", median(us_by_pairs) / 1000), fmt::format("{:.2f}", times_as_fast(us, us_by_pairs)),
         fmt::format("{:.2f}", median(us_of_update) / 1000), fmt::format("{:.2f}", times_as_fast(us_of_update, us)),
         fmt::format("{:.1f}", static_cast<double>(meeting_count) / static_cast<double>(ships.frame_count()))});
    return table;
}

}  // namespace

SuiteResult run_world_casts(const SuiteOptions& options) {
    SuiteResult result;
    Ships ships(options.is_quick() ? 100 : 10000, options.is_quick() ? 2 : 10);
    const Table casts = world_cast_table(ships, options.repetition_count, result.is_right);
    print(casts);
    const Table meetings = meeting_table(ships, result.is_right);
    print(meetings);
    result.sections.push_back({"Casts and moves in a world", {}, {casts, meetings}, {}});
    return result;
}

}  // namespace ecods::bench
