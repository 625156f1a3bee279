#include "fuzz/script/bad_calls.hpp"

#include <algorithm>
#include <array>
#include <limits>
#include <tuple>

#include "fuzz/base/failure.hpp"
#include "fuzz/checks/text.hpp"
#include "scenes/is_about.hpp"

namespace ecods::fuzz {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

// A shape that has no box.
class BoxlessShape final : public Shape {
  public:
    ShapeKind kind() const noexcept override { return first_user_kind; }
    Aabb box(const Pose&) const override { return {Vec3(0, 1, 0), Vec3(1, 0, 1)}; }
    std::uint64_t digest() const noexcept override { return 1; }
};

// What a bad call has at hand.
struct Hand {
    ScriptedWorld& scripted;
    World& world;
    BodyId body;   // alive
    BodyId stale;  // destroyed, or null
    const ModelBody& model;
    std::uint32_t choice;

    Pose bad_pose() const {
        constexpr std::array<double, 3> values = {nan, infinity, -infinity};
        Pose pose = model.pose;
        const std::uint32_t entry = choice % 12;
        (entry < 9 ? pose.R(entry / 3, entry % 3) : pose.t[entry - 9]) = values[choice / 12 % 3];
        return pose;
    }
    const std::shared_ptr<const Mesh>& mesh() const { return model.part.mesh; }
};

template <class Expected>
bool is_a(const std::exception& error) {
    return dynamic_cast<const Expected*>(&error) != nullptr;
}

template <auto why>
bool is_about(const std::exception& error) {
    return scenes::is_about(error, why);
}

struct BadCallKind {
    const char* name;
    bool (*is_expected)(const std::exception& error);
    void (*call)(const Hand&);

    // Returns what came instead of the expected error; empty if that came.
    std::string wrong(const Hand& hand) const {
        try {
            call(hand);
        } catch (const std::exception& error) {
            return is_expected(error) ? std::string() : std::string("another error: ") + error.what();
        }
        return "no error";
    }
};

const std::array kinds = {
    BadCallKind{"set_pose, not finite", is_about<Argument::pose>,
                [](const Hand& h) { h.world.set_pose(h.body, h.bad_pose()); }},
    BadCallKind{"create_body, pose not finite", is_about<Argument::pose>,
                [](const Hand& h) { h.world.create_body(h.mesh(), h.bad_pose()); }},
    BadCallKind{"create_body, null", is_about<Argument::null>,
                [](const Hand& h) { h.world.create_body(std::shared_ptr<const Mesh>(), h.model.pose); }},
    BadCallKind{"create_body, kind without tests", is_about<Question::intersects>,
                [](const Hand& h) {
                    h.world.create_body(std::make_shared<UserShape>(h.mesh(), kind_without_tests), h.model.pose);
                }},
    BadCallKind{"create_body, no box", is_about<Argument::box>,
                [](const Hand& h) { h.world.create_body(std::make_shared<BoxlessShape>(), h.model.pose); }},
    BadCallKind{"create_body, bad vertex", is_about<InvalidMesh::Reason::vertex>,
                [](const Hand& h) {
                    h.world.create_body(Mesh::create({Vec3(0, 0, 0), Vec3(0, nan, 0)}, {{0, 1, 1}}), h.model.pose);
                }},
    BadCallKind{"create_body, bad index", is_about<InvalidMesh::Reason::index>,
                [](const Hand& h) {
                    h.world.create_body(Mesh::create({Vec3(0, 0, 0)}, {{0, 1, 0}}), h.model.pose);
                }},
    BadCallKind{"create_body, empty mesh", is_about<InvalidMesh::Reason::empty>,
                [](const Hand& h) { h.world.create_body(Mesh::create({Vec3(0, 0, 0)}, {}), h.model.pose); }},
    BadCallKind{"set_pose, stale body", is_a<StaleBody>,
                [](const Hand& h) { h.world.set_pose(h.stale, h.model.pose); }},
    BadCallKind{"destroy_body, stale body", is_a<StaleBody>, [](const Hand& h) { h.world.destroy_body(h.stale); }},
    BadCallKind{"set_filter, stale body", is_a<StaleBody>,
                [](const Hand& h) { h.world.set_filter(h.stale, {.groups = 0, .mask = 0}); }},
    BadCallKind{"relation, stale body", is_a<StaleBody>,
                [](const Hand& h) { std::ignore = h.world.relation(h.body, h.stale); }},
    BadCallKind{"relation, same body", is_a<SameBody>,
                [](const Hand& h) { std::ignore = h.world.relation(h.body, h.body); }},
    BadCallKind{"set_pair_enabled, same body", is_a<SameBody>,
                [](const Hand& h) { h.world.set_pair_enabled(h.body, h.body, false); }},
    BadCallKind{"set_shape, null", is_about<Argument::null>,
                [](const Hand& h) { h.world.set_shape(h.body, std::shared_ptr<const Mesh>()); }},
    BadCallKind{"set_shape, kind without tests", is_about<Question::intersects>,
                [](const Hand& h) {
                    // Of the only body there is, any kind will do.
                    if (h.world.statistics().body_count < 2) {
                        throw NotSupported(Question::intersects, kind_without_tests, kind_without_tests);
                    }
                    h.world.set_shape(h.body, std::make_shared<UserShape>(h.mesh(), kind_without_tests));
                }},
    BadCallKind{"set_shape, no box", is_about<Argument::box>,
                [](const Hand& h) { h.world.set_shape(h.body, std::make_shared<BoxlessShape>()); }},
    BadCallKind{"set_poses, lengths", is_about<Argument::list_length>,
                [](const Hand& h) {
                    const Pose poses[] = {Pose(), Pose()};
                    h.world.set_poses({&h.body, 1}, poses);
                }},
    BadCallKind{"set_poses, second not finite", is_about<Argument::pose>,
                [](const Hand& h) {
                    const BodyId bodies[] = {h.body, h.body};
                    const Pose poses[] = {Pose(), h.bad_pose()};
                    h.world.set_poses(bodies, poses);
                }},
    BadCallKind{"set_poses, second stale", is_a<StaleBody>,
                [](const Hand& h) {
                    const BodyId bodies[] = {h.body, h.stale};
                    const Pose poses[] = {Pose(), Pose()};
                    h.world.set_poses(bodies, poses);
                }},
    BadCallKind{"set_test, null", is_about<Argument::null>,
                [](const Hand& h) { h.world.set_test(first_user_kind, first_user_kind, nullptr); }},
    BadCallKind{"set_clearance, no clearance", is_about<Argument::distance>,
                [](const Hand& h) {
                    constexpr std::array<double, 3> values = {nan, infinity, -1};
                    h.world.set_clearance(values[h.choice % 3]);
                }},
    BadCallKind{"nearest, no limit", is_about<Argument::distance>,
                [](const Hand& h) { std::ignore = h.world.nearest(h.body, h.choice % 2 == 0 ? nan : -1); }},
    BadCallKind{"overlapping_bodies, no box", is_about<Argument::box>,
                [](const Hand& h) {
                    std::ignore = h.world.overlapping_bodies({Vec3(0, 0, nan), Vec3(0, 0, nan)});
                }},
    BadCallKind{"relation, pose of a shape not finite", is_about<Argument::pose>,
                [](const Hand& h) {
                    std::ignore = h.world.relation({h.world.shape(h.body), h.bad_pose()}, h.body);
                }},
    BadCallKind{"nearest, pose of a mesh not finite", is_about<Argument::pose>,
                [](const Hand& h) {
                    std::ignore = h.world.nearest({h.mesh(), h.bad_pose()});
                }},
    BadCallKind{"cast, null", is_about<Argument::null>,
                [](const Hand& h) {
                    std::ignore = h.world.cast({std::shared_ptr<const Mesh>(), h.model.pose}, Vec3(0, 0, 1));
                }},
};

// What must stay.
struct Kept {
    explicit Kept(const World& world)
        : digest(world.digest()),
          bodies(world.bodies()),
          colliding(world.colliding_pairs().begin(), world.colliding_pairs().end()) {
        for (const BodyId body : bodies) boxes.push_back(world.box(body));
    }
    friend bool operator==(const Kept&, const Kept&) = default;

    std::uint64_t digest;
    std::vector<BodyId> bodies;
    std::vector<BodyPair> colliding;
    std::vector<Aabb> boxes = {};
};

}  // namespace

std::vector<std::string> bad_call_names() {
    std::vector<std::string> names;
    for (const BadCallKind& kind : kinds) names.emplace_back(kind.name);
    return names;
}

void make_bad_call(const BadCall& call, Scene& scene, Counters& counters) {
    const auto kind = std::ranges::find(kinds, call.kind, &BadCallKind::name);
    if (kind == kinds.end()) throw Error("there is no bad call of the kind " + call.kind);
    const auto body = scene.model.bodies.find(call.body);
    if (body == scene.model.bodies.end()) return;
    for (ScriptedWorld& scripted : scene.worlds) {
        // Some body that is gone, if one is.
        Label gone = scene.model.next_label == 0 ? 0 : call.choice % scene.model.next_label;
        const BodyId stale = scene.model.bodies.contains(gone) ? BodyId{} : scripted.id(gone);
        const Hand hand{scripted, scripted.world(), scripted.id(call.body), stale, body->second, call.choice};
        const Kept before(scripted.world());
        const std::string wrong = kind->wrong(hand);
        if (!wrong.empty()) throw CheckFailed("bad call", call.kind + " is refused", wrong);
        if (!(before == Kept(scripted.world())))
            throw CheckFailed("bad call", "nothing has changed", call.kind + " changed the world");
    }
    ++counters["bad calls: " + call.kind];
}

}  // namespace ecods::fuzz
