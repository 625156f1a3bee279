#include <algorithm>
#include <iterator>
#include <optional>
#include <sstream>
#include <utility>
#include <vector>

#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "environment/float_mode.hpp"
#include "fuzz/pairs/campaigns.hpp"
#include "judge/mixed_bodies.hpp"
#include "judge/wrong.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::fuzz {
namespace {

using judge::MixedBody;
using ShapePtr = std::shared_ptr<const Shape>;
using BodyPairs = std::vector<BodyPair>;

constexpr int world_count = 6, frame_count = 8;
constexpr std::size_t body_count = 9;
constexpr double clearance = 0.5;

struct JudgedPair {
    double distance;  // rounded
    bool collides, is_close;
    BodyPair bodies;
    std::uint64_t groups_a, groups_b;
};

// One world, and what it must say.
class KindsWorld {
  public:
    KindsWorld(scenes::Random& random, std::ostream& trace)
        : random_(random), world_({.broad_phase = static_cast<BroadPhaseKind>(random.below(4))}) {
        world_.trace_to(trace);
        world_.set_clearance(clearance);
        for (std::size_t i = 0; i < body_count; ++i) create();
    }

    void change() {
        for (int i = 0; i < 3; ++i) change_one();
        world_.update();
    }

    // Returns the first list that is wrong.
    std::optional<judge::Wrong> check(bool lie) {
        std::vector<JudgedPair> pairs = judged_pairs();
        if (lie && !pairs.empty()) pairs.front().distance += 1;
        BodyPairs colliding, close;
        for (const JudgedPair& pair : pairs) {
            if (pair.collides) colliding.push_back(pair.bodies);
            if (pair.is_close) close.push_back(pair.bodies);
        }
        std::ranges::sort(colliding);
        std::ranges::sort(close);
        auto wrong = differ("colliding pairs", colliding, world_.colliding_pairs());
        if (!wrong) wrong = differ("close pairs", close, world_.close_pairs());
        if (!wrong) wrong = differ("pairs that began", without(colliding, last_colliding_), world_.began());
        if (!wrong) wrong = differ("pairs that ended", without(last_colliding_, colliding), world_.ended());
        if (!wrong) wrong = differ("close pairs that began", without(close, last_close_), world_.close_began());
        if (!wrong) wrong = differ("close pairs that ended", without(last_close_, close), world_.close_ended());
        if (!wrong) wrong = check_distances(pairs);
        if (!wrong) wrong = check_nearest(pairs);
        if (!wrong) wrong = check_fresh();
        last_colliding_ = colliding;
        last_close_ = close;
        return wrong;
    }
    void end_trace() { world_.end_trace(); }

  private:
    double eighths(std::uint32_t count) { return 0.125 * random_.below(count); }
    Vec3 point() { return {eighths(9) - 0.5, eighths(9) - 0.5, eighths(9) - 0.5}; }
    // Radii that differ by 2^1000 and more, also none.
    double radius() {
        constexpr double tiny[] = {0, 0x1p-60, 0x1p-1000, 0x1p-1074};
        return random_.below(3) == 0 ? tiny[random_.below(4)] : eighths(7);
    }
    std::shared_ptr<const MeshShape> any_core() {
        switch (random_.below(4)) {
            case 0:
                return std::make_shared<MeshShape>(scenes::cube(0.5 + eighths(4)));
            case 1:
                return std::make_shared<Solid>(scenes::torus(4, 3, 0.5));
            case 2:
                return std::make_shared<MeshShape>(scenes::one_triangle({point(), point(), point()}));
            default:
                return std::make_shared<ConvexSolid>(scenes::cube(0.25 + eighths(5)));
        }
    }
    ShapePtr any_shape() {
        switch (random_.below(8)) {
            case 0:
            case 1:
                return rounded(any_core(), radius());
            case 2:
                return sphere(radius(), point());
            case 3:
                return std::make_shared<HalfSpace>(Vec3(random_.below(3) - 1.0, random_.below(3) - 1.0, 2),
                                                   -3 - eighths(9));
            case 4:
                return std::make_shared<ConvexSolid>(scenes::cube(0.25 + eighths(5)));
            default:
                return any_core();
        }
    }
    // Some are on a lattice, where bodies touch; a jump may be into another body.
    Pose any_pose() {
        Pose pose = random_.below(2) == 0 ? random_.turned() : Pose();
        if (random_.below(4) == 0) pose.R.col(0) *= -0.5;
        if (random_.below(6) == 0) pose.R(0, 1) += 1;
        pose.t = 5 * point();
        if (random_.below(4) == 0 && !bodies_.empty()) {
            pose.t = bodies_[random_.below(static_cast<std::uint32_t>(bodies_.size()))].pose.t + 0.25 * point();
        }
        // Beside the lattice by so little that distances are below 2^-1074.
        if (random_.below(6) == 0) pose.t[static_cast<Eigen::Index>(random_.below(3))] = 0x1p-600;
        return pose;
    }
    CollisionFilter any_filter() {
        return {1 + std::uint64_t{random_.below(7)}, random_.below(8) == 0 ? 6 : ~std::uint64_t{0}};
    }

    void create() {
        MixedBody body{{}, any_shape(), any_pose(), any_filter()};
        body.id = world_.create_body({.shape = body.shape, .pose = body.pose, .filter = body.filter});
        bodies_.push_back(std::move(body));
    }
    void change_one() {
        const std::size_t at = random_.below(static_cast<std::uint32_t>(bodies_.size()));
        MixedBody& body = bodies_[at];
        switch (random_.below(8)) {
            case 0:
                world_.destroy_body(body.id);
                bodies_.erase(bodies_.begin() + static_cast<std::ptrdiff_t>(at));
                return create();
            case 1:
                return world_.set_shape(body.id, body.shape = any_shape());
            case 2:  // the same core with another radius
                if (body.is_half_space()) break;
                body.shape =
                    std::make_shared<Rounded>(std::shared_ptr<const MeshShape>(body.shape, &body.core()), radius());
                return world_.set_shape(body.id, body.shape);
            case 3:
                return world_.set_filter(body.id, body.filter = any_filter());
            case 4:
                body.pose.t += 0.125 * point();
                return world_.set_pose(body.id, body.pose);
            default:
                return world_.set_pose(body.id, body.pose = any_pose());
        }
    }

    // All pairs that are not filtered out, ascending by distance, then by ids.
    std::vector<JudgedPair> judged_pairs() const {
        std::vector<JudgedPair> pairs;
        for (std::size_t i = 0; i < bodies_.size(); ++i) {
            for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
                const bool is_turned = bodies_[j].id < bodies_[i].id;
                const MixedBody &a = bodies_[is_turned ? j : i], &b = bodies_[is_turned ? i : j];
                if (!may_meet(a.filter, b.filter)) continue;
                const judge::MixedDistance truth(a, b);
                pairs.push_back({truth.nearest(),
                                 truth.compare(0) <= 0,
                                 truth.compare(clearance) <= 0,
                                 {a.id, b.id},
                                 a.filter.groups,
                                 b.filter.groups});
            }
        }
        std::ranges::sort(pairs, {}, [](const JudgedPair& pair) { return std::pair(pair.distance, pair.bodies); });
        return pairs;
    }

    std::optional<judge::Wrong> check_distances(const std::vector<JudgedPair>& pairs) {
        const std::vector<std::pair<std::uint64_t, std::uint64_t>> groups = {
            {~std::uint64_t{0}, ~std::uint64_t{0}}, {1, 2}, {6, 3}};
        for (const auto& [x, y] : groups) {
            std::vector<JudgedPair> expected = pairs;
            std::erase_if(expected, [&](const JudgedPair& pair) {
                return !((pair.groups_a & x) != 0 && (pair.groups_b & y) != 0) &&
                       !((pair.groups_a & y) != 0 && (pair.groups_b & x) != 0);
            });
            const std::vector<ClosestPair> got = world_.closest_pairs(World::no_limit, x, y, memory_);
            if (auto wrong = differ("closest pairs", expected, got)) return wrong;
            const auto first = world_.closest_pair(World::no_limit, y, x, memory_);
            if (first != (got.empty() ? std::nullopt : std::optional(got.front()))) {
                return judge::Wrong{"closest pair", "the first of closest_pairs()", "another"};
            }
        }
        std::vector<JudgedPair> close = pairs;
        std::erase_if(close, [](const JudgedPair& pair) { return !pair.is_close; });
        if (auto wrong = differ("closest pairs within the clearance", close, world_.closest_pairs(clearance)))
            return wrong;
        std::ranges::sort(close, {}, &JudgedPair::bodies);
        return differ("signed distances", close, world_.signed_distances(clearance, memory_));
    }

    // The body nearest to one of them.
    std::optional<judge::Wrong> check_nearest(const std::vector<JudgedPair>& pairs) {
        const BodyId subject = bodies_[random_.below(static_cast<std::uint32_t>(bodies_.size()))].id;
        std::vector<NearestBody> expected, got;
        for (const JudgedPair& pair : pairs) {
            if (pair.bodies.a != subject && pair.bodies.b != subject) continue;
            const BodyId other = pair.bodies.a == subject ? pair.bodies.b : pair.bodies.a;
            const NearestBody next{other, std::max(pair.distance, 0.0)};
            const auto key = [](const NearestBody& body) { return std::pair(body.distance, body.body); };
            if (expected.empty() || key(next) < key(expected.front())) expected = {next};
        }
        if (const auto found = world_.nearest(subject, World::no_limit, memory_)) got.push_back(*found);
        return differ("nearest body", expected, got);
    }

    // A world in which all bodies are new has the same lists, whatever radii and shapes were before.
    std::optional<judge::Wrong> check_fresh() const {
        World fresh;
        fresh.set_clearance(clearance);
        for (const MixedBody& body : bodies_) {
            fresh.create_body({.shape = body.shape, .pose = body.pose, .filter = body.filter});
        }
        fresh.update();
        if (fresh.digest() == world_.digest()) return std::nullopt;
        return judge::Wrong{"digest", "that of a fresh world", "another"};
    }

    static std::string text_of(const NearestBody& body) {
        return (std::ostringstream() << body.body << " " << std::hexfloat << body.distance).str();
    }
    static std::string text_of(const BodyPair& pair) { return (std::ostringstream() << pair).str(); }
    template <class Listed>
    static std::string text_of(const Listed& pair) {
        return (std::ostringstream() << pair.bodies << " " << std::hexfloat << pair.distance).str();
    }
    template <class List>
    static std::string list_text(const List& list) {
        std::string text;
        for (const auto& each : list) text += text_of(each) + " ";
        return text;
    }
    template <class Expected, class Got>
    static std::optional<judge::Wrong> differ(const char* what, const Expected& expected, const Got& got) {
        std::string should_be = list_text(expected), is = list_text(got);
        if (should_be == is) return std::nullopt;
        return judge::Wrong{what, std::move(should_be), std::move(is)};
    }
    static BodyPairs without(const BodyPairs& all, const BodyPairs& some) {
        BodyPairs rest;
        std::ranges::set_difference(all, some, std::back_inserter(rest));
        return rest;
    }

    scenes::Random& random_;
    World world_;
    std::vector<MixedBody> bodies_;
    QueryMemory memory_;
    BodyPairs last_colliding_, last_close_;
};

}  // namespace

void run_kinds(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    scenes::Random random(seed);
    for (int index = 0; index < world_count; ++index) {
        std::ostringstream trace;
        KindsWorld world(random, trace);
        const auto& mode = environment::float_modes[random.below(environment::float_modes.size())];
        for (int frame = 0; frame < frame_count; ++frame) {
            const auto wrong = [&] {
                {
                    const environment::InFloatMode in_mode(mode);
                    world.change();
                }
                return world.check(lie != Lie::none);
            }();
            ++counts.checks[mode.name];
            if (!wrong) continue;
            world.end_trace();
            throw Disagreement{.seed = seed,
                               .index = static_cast<std::uint64_t>(index),
                               .family = "kinds",
                               .path = wrong->question,
                               .expected = wrong->expected,
                               .got = wrong->got,
                               .text = trace.str()};
        }
        ++counts.cases;
        ++counts.kinds["kinds"]["worlds"];
    }
}

}  // namespace ecods::fuzz
