#include "fuzz/script/scene.hpp"

#include <algorithm>
#include <optional>

#include "environment/instruction_sets.hpp"
#include "fuzz/checks/text.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/script/schedule.hpp"
#include "scenes/thread_executor.hpp"

namespace ecods::fuzz {
namespace {

std::shared_ptr<const Shape> user_shape(const Part& part) {
    return std::make_shared<UserShape>(part.mesh, part.kind);
}

bool is_same_mesh(const Mesh& a, const Mesh& b) {
    return &a == &b ||
           (std::ranges::equal(a.triangles(), b.triangles()) && std::ranges::equal(a.vertices(), b.vertices()));
}

void require(bool holds, const char* what, Label label) {
    if (!holds)
        throw CheckFailed("state", std::string("the ") + what + " that body " + std::to_string(label) + " was given",
                          "another");
}

}  // namespace

ScriptedWorld::ScriptedWorld(const WorldOptions& options) : world_(options) {
    tests_.add_to(world_);
}

void ScriptedWorld::apply(const Call& call) {
    std::visit(
        Overloaded{[&](const Create& c) {
                       ids_.resize(std::max(ids_.size(), c.body + 1));
                       ids_[c.body] = c.part.kind == ShapeKind::mesh() ? world_.create_body(c.part.mesh, c.pose)
                                                                       : world_.create_body(user_shape(c.part), c.pose);
                   },
                   [&](const Destroy& c) { world_.destroy_body(id(c.body)); },
                   [&](const SetPose& c) { world_.set_pose(id(c.body), c.pose); },
                   [&](const SetPoses& c) {
                       std::vector<BodyId> bodies;
                       for (const Label label : c.bodies) bodies.push_back(id(label));
                       world_.set_poses(bodies, c.poses);
                   },
                   [&](const SetShape& c) { set_shape(c); },
                   [&](const SetFilter& c) { world_.set_filter(id(c.body), c.filter); },
                   [&](const SetPairEnabled& c) { world_.set_pair_enabled(id(c.a), id(c.b), c.is_enabled); },
                   [&](const SetUserData& c) { world_.set_user_data(id(c.body), c.data); },
                   [&](const Reserve& c) { world_.reserve(c.count); }, [&](const SetTests&) { tests_.add_to(world_); },
                   [](const BadCall&) {}, [&](const Update&) { world_.update(); }},
        call);
}

void ScriptedWorld::set_shape(const SetShape& call) {
    const BodyId body = id(call.body);
    if (call.part.kind != ShapeKind::mesh()) return world_.set_shape(body, user_shape(call.part));
    const auto* old = dynamic_cast<const MeshShape*>(world_.shape(body).get());
    if (!call.refits || old == nullptr || !std::ranges::equal(old->mesh().triangles(), call.part.mesh->triangles())) {
        return world_.set_shape(body, call.part.mesh);
    }
    const auto vertices = call.part.mesh->vertices();
    world_.set_shape(body, std::static_pointer_cast<const Shape>(refit(*old, {vertices.begin(), vertices.end()})));
}

Scene::Scene()
    : worlds{
          ScriptedWorld({.broad_phase = BroadPhaseKind::brute_force}),
          ScriptedWorld(
              {.broad_phase = BroadPhaseKind::sweep_and_prune, .executor = std::make_shared<ThreadExecutor>(2)}),
          ScriptedWorld(
              {.broad_phase = BroadPhaseKind::kept_candidates, .executor = std::make_shared<ThreadExecutor>(3)}),
          ScriptedWorld({.broad_phase = BroadPhaseKind::automatic, .executor = std::make_shared<ThreadExecutor>(4)})} {}

void Scene::apply(const Call& call) {
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        const environment::InstructionSetLimit limit(instruction_set(i));
        worlds[i].apply(call);
    }
    if (std::holds_alternative<Update>(call)) ++round_;
    if (const auto* create = std::get_if<Create>(&call)) require_same_ids(create->body);
    model.apply(call);
}

InstructionSet Scene::instruction_set(std::size_t world) const {
    const auto sets = environment::supported_instruction_sets();
    return sets[scheduled_set(round_, world, sets.size())];
}

void Scene::require_same_ids(Label label) const {
    const BodyId expected = worlds[0].id(label);
    for (const ScriptedWorld& each : worlds) {
        if (each.id(label) != expected) throw CheckFailed("ids", text(expected), text(each.id(label)));
    }
}

bool Scene::update_failing(Counters& counters) {
    std::optional<bool> has_thrown;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        const environment::InstructionSetLimit limit(instruction_set(i));
        ScriptedWorld& each = worlds[i];
        const World& world = each.world();
        const std::vector<BodyPair> before(world.colliding_pairs().begin(), world.colliding_pairs().end());
        bool throws = false;
        each.tests().fail(true);
        try {
            each.world().update();
        } catch (const TestFailed&) {
            throws = true;
        }
        each.tests().fail(false);
        if (throws && !std::ranges::equal(before, world.colliding_pairs())) {
            throw CheckFailed("failed update", text(std::span<const BodyPair>(before)), text(world.colliding_pairs()));
        }
        if (has_thrown.value_or(throws) != throws) throw CheckFailed("failed update", "in all worlds", "in some");
        has_thrown = throws;
    }
    ++counters[*has_thrown ? "updates: thrown" : "updates: could throw"];
    return *has_thrown;
}

void check_state(const ScriptedWorld& scripted, const Model& model) {
    const World& world = scripted.world();
    if (world.statistics().body_count != model.bodies.size()) {
        throw CheckFailed("state", fmt::format("{} bodies", model.bodies.size()),
                          fmt::format("{}", world.statistics().body_count));
    }
    for (Label label = 0; label < model.next_label; ++label) {
        const BodyId id = scripted.id(label);
        const auto found = model.bodies.find(label);
        require(!id || world.is_alive(id) == (found != model.bodies.end()), "life", label);
        if (found == model.bodies.end()) continue;
        const ModelBody& body = found->second;
        require(world.pose(id) == body.pose, "pose", label);
        require(world.shape(id)->kind() == body.part.kind, "kind", label);
        require(is_same_mesh(*mesh_of(*world.shape(id)), *body.part.mesh), "shape", label);
        require(world.filter(id) == body.filter, "filter", label);
        require(world.user_data(id) == body.user_data, "user data", label);
    }
}

}  // namespace ecods::fuzz
