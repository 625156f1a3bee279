#include "fuzz/script/scene.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <optional>

#include "ecods/rounded.hpp"
#include "environment/instruction_sets.hpp"
#include "fuzz/base/failure.hpp"
#include "fuzz/checks/text.hpp"
#include "fuzz/script/schedule.hpp"
#include "scenes/numbers_of.hpp"
#include "scenes/thread_executor.hpp"

namespace ecods::fuzz {
namespace {

// Whether the world makes the shape of a mesh that it is given.
bool is_surface(const Part& part) {
    return part.kind == ShapeKind::mesh() && part.form == MeshForm::surface && !part.radius;
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

// Null if there is none, or if own answers are not to be used.
template <class Is>
BodyId PartWorld::find_body(Is is) const {
    if (!uses_own_answers_) return {};
    const auto all = bodies();
    const auto found = std::ranges::find_if(all, is);
    return found == all.end() ? BodyId{} : *found;
}

BodyId PartWorld::body_at(const Pose& at) const {
    return find_body([&](BodyId body) { return pose(body) == at; });
}

// Only of shapes that the world makes itself: others would be new ones without own answers.
BodyId PartWorld::body_of(const Part& part) const {
    if (part.kind != ShapeKind::mesh() || refitted_.contains(part.mesh)) return {};
    return find_body([&](BodyId body) {
        const auto other = shape(body);
        return other->kind() == part.kind && mesh_of(*other) == part.mesh && form_of(*other) == part.form;
    });
}

// Of a part that is no surface.
std::shared_ptr<const Shape> PartWorld::shape_of(const Part& part) {
    if (part.kind != ShapeKind::mesh() && !part.radius) {
        return std::make_shared<const UserShape>(part.mesh, part.kind);
    }
    const auto radius = part.radius ? std::optional(std::bit_cast<std::uint64_t>(*part.radius)) : std::nullopt;
    auto& shape = shapes_[{part.mesh, part.form, radius}];
    if (shape) return shape;
    const auto core = make_shape(part.mesh, part.form);
    shape = part.radius ? std::shared_ptr<const Shape>(std::make_shared<const Rounded>(core, *part.radius)) : core;
    return shape;
}

BodyOptions PartWorld::options_of(BodyId body) const {
    BodyOptions options{.pose = pose(body), .filter = filter(body), .user_data = user_data(body)};
    const auto of = shape(body);
    const auto mesh = mesh_of(*of);
    const bool is_made = of->kind() == ShapeKind::mesh() && form_of(*of) == MeshForm::surface;
    (is_made && !refitted_.contains(mesh)) ? void(options.mesh = mesh) : void(options.shape = of);
    return options;
}

void PartWorld::set_pose(BodyId body, const Pose& to) {
    const BodyId there = body_at(to);
    there ? World::set_pose(body, pose(there)) : World::set_pose(body, to);
}

void PartWorld::set_filter(BodyId body, const CollisionFilter& to) {
    const BodyId with = find_body([&](BodyId other) { return filter(other) == to; });
    with ? World::set_filter(body, filter(with)) : World::set_filter(body, to);
}

BodyId PartWorld::create_body(const Part& part, const Pose& at) {
    const BodyId alike = body_of(part), there = body_at(at);
    if (alike && there) return create_body(shape(alike), pose(there));
    const Pose own = there ? pose(there) : at;
    return is_surface(part) ? create_body(part.mesh, own) : create_body(shape_of(part), own);
}

BodyId PartWorld::create_body(const PartOptions& options) {
    const BodyId alike = body_of(options.shape), there = body_at(options.pose);
    BodyOptions own{
        .pose = there ? pose(there) : options.pose, .filter = options.filter, .user_data = options.user_data};
    if (alike) {
        own.shape = shape(alike);
    } else if (is_surface(options.shape)) {
        own.mesh = options.shape.mesh;
    } else {
        own.shape = shape_of(options.shape);
    }
    return create_body(own);
}

void PartWorld::set_shape(BodyId body, const Part& part) {
    if (const BodyId alike = body_of(part)) return set_shape(body, shape(alike));
    if (!is_surface(part)) return set_shape(body, shape_of(part));
    const auto old = std::dynamic_pointer_cast<const MeshShape>(shape(body));
    if (!part.refits || !old || !std::ranges::equal(old->mesh().triangles(), part.mesh->triangles())) {
        return set_shape(body, part.mesh);
    }
    const auto vertices = part.mesh->vertices();
    refitted_.insert(part.mesh);
    set_shape(body, std::static_pointer_cast<const Shape>(refit(*old, {vertices.begin(), vertices.end()})));
}

ScriptedWorld::ScriptedWorld(const WorldOptions& options) : options_(options), world_(options) {
    tests_.add_to(world_);
}

void ScriptedWorld::apply(const Call& call) {
    if (const auto body = created_body(call)) ids_.resize(std::max(ids_.size(), *body + 1));
    std::visit(Overloaded{[&](const Reserve& c) { world_.reserve(c.count); },
                          [&](const SetTests&) { tests_.add_to(world_); }, [&](const MakeAgain&) { make_again(); },
                          [](const BadCall&) {}, [](const Manner&) {}, [&](const Update&) { world_.update(); },
                          [&]<template <class> class Row>(const Row<InScript>& row) { make(row); }},
               call);
}

// All that the calls so far have set, in a new world. Every id of a body is what it was, and so are those to come.
void ScriptedWorld::make_again() {
    const auto bodies = world_.bodies(), coming = world_.next_ids();
    WorldOptions options = options_;
    options.ids = bodies;
    options.ids.insert(options.ids.end(), coming.begin(), coming.end());
    World made(options);
    tests_.add_to(made);
    for (const BodyId body : bodies) {
        const BodyId id = made.create_body(world_.options_of(body));
        if (id != body) throw CheckFailed("ids of a world made again", text(body), text(id));
    }
    if (made.next_ids() != coming) {
        throw CheckFailed("ids to come of a world made again", text(std::span<const BodyId>(coming)),
                          text(std::span<const BodyId>(made.next_ids())));
    }
    for (const BodyPair& pair : world_.disabled_pairs()) made.set_pair_enabled(pair.a, pair.b, false);
    made.set_clearance(world_.clearance());
    made.set_relations(world_.are_relations_listed());
    world_.become(std::move(made));
}

namespace {

struct InPartWorld {
    using Body = BodyId;
    using Shape = Part;
    template <class Item>
    using List = std::vector<Item>;
};

}  // namespace

template <template <class> class Row>
void ScriptedWorld::make(const Row<InScript>& scripted) {
    auto call = calls::renamed<InPartWorld>(
        scripted, [&](Label label) { return id(label); }, [](const Part& part) { return part; });
    call.make(world_);

    struct KeepIds : calls::NoField {
        std::vector<BodyId>& ids;
        void created(const Label& label, const BodyId& made) const { ids[label] = made; }
    };
    Row<InScript>::fields(KeepIds{{}, ids_}, scripted, call);
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
    apply(call, [&](ScriptedWorld& scripted) { scripted.apply(call); });
}

void Scene::apply(const Call& call, const std::function<void(ScriptedWorld&)>& make) {
    const auto created = created_body(call);
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        const environment::InstructionSetLimit limit(instruction_set(i));
        const std::vector<BodyId> coming = created ? worlds[i].world().next_ids() : std::vector<BodyId>();
        make(worlds[i]);
        if (created) require_coming_ids(worlds[i], *created, coming);
    }
    if (std::holds_alternative<Update>(call)) ++round_;
    if (created) require_same_ids(*created);
    model.apply(call);
}

InstructionSet Scene::instruction_set(std::size_t world) const {
    const auto sets = environment::supported_instruction_sets();
    return sets[scheduled_set(round_, world, sets.size())];
}

void Scene::require_same_ids(Label label) const {
    const BodyId expected = numbers_of(worlds[0].id(label));
    for (const ScriptedWorld& each : worlds) {
        if (numbers_of(each.id(label)) != expected) throw CheckFailed("ids", text(expected), text(each.id(label)));
    }
}

// The ids that were to come are: the first one of the body, and the others of the next ones.
void Scene::require_coming_ids(const ScriptedWorld& scripted, Label label, const std::vector<BodyId>& coming) {
    std::vector<BodyId> got = scripted.world().next_ids();
    got.insert(got.begin(), scripted.id(label));
    got.resize(std::min(got.size(), coming.size()));
    if (got == coming) return;
    throw CheckFailed("ids to come", text(std::span<const BodyId>(coming)), text(std::span<const BodyId>(got)));
}

bool Scene::update_failing(Counters& counters) {
    std::optional<bool> has_thrown;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        const environment::InstructionSetLimit limit(instruction_set(i));
        ScriptedWorld& each = worlds[i];
        const World& world = each.world();
        const std::vector<BodyPair> before(world.colliding_pairs().begin(), world.colliding_pairs().end());
        const std::vector<BodyPair> close_before(world.close_pairs().begin(), world.close_pairs().end());
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
        if (throws && !std::ranges::equal(close_before, world.close_pairs())) {
            throw CheckFailed("failed update, close pairs", text(std::span<const BodyPair>(close_before)),
                              text(world.close_pairs()));
        }
        if (has_thrown.value_or(throws) != throws) throw CheckFailed("failed update", "in all worlds", "in some");
        has_thrown = throws;
    }
    ++counters[*has_thrown ? "updates: thrown" : "updates: could throw"];
    return *has_thrown;
}

namespace {

// Of few bodies all pairs are looked at one by one, of many those that are off.
void check_switches(const ScriptedWorld& scripted, const Model& model) {
    std::vector<BodyPair> off;
    for (const auto& [a, b] : model.switched_off) {
        const auto [first, second] = std::minmax({scripted.id(a), scripted.id(b)});
        off.push_back({first, second});
    }
    std::ranges::sort(off);
    if (const auto got = scripted.world().disabled_pairs(); got != off) {
        throw CheckFailed("disabled pairs", text(std::span<const BodyPair>(off)), text(std::span<const BodyPair>(got)));
    }
    constexpr std::size_t few = 40;
    const auto check = [&](Label a, Label b) {
        const bool is_enabled = !model.switched_off.contains({a, b});
        if (scripted.world().is_pair_enabled(scripted.id(b), scripted.id(a)) == is_enabled) return;
        throw CheckFailed("state", fmt::format("the pair {}-{} switched {}", a, b, is_enabled ? "on" : "off"), "not");
    };
    for (const auto& [a, b] : model.switched_off) check(a, b);
    if (model.bodies.size() > few) return;
    for (auto a = model.bodies.begin(); a != model.bodies.end(); ++a) {
        for (auto b = std::next(a); b != model.bodies.end(); ++b) check(a->first, b->first);
    }
}

}  // namespace

void check_state(const ScriptedWorld& scripted, const Model& model) {
    const World& world = scripted.world();
    if (world.statistics().body_count != model.bodies.size()) {
        throw CheckFailed("state", fmt::format("{} bodies", model.bodies.size()),
                          fmt::format("{}", world.statistics().body_count));
    }
    if (world.are_relations_listed() != model.relations) {
        throw CheckFailed("state", "whether relations are listed, as set", "otherwise");
    }
    if (world.clearance() != model.clearance) {
        throw CheckFailed("state", "the clearance that was set", "another");
    }
    for (Label label = 0; label < model.next_label; ++label) {
        const BodyId id = scripted.id(label);
        const auto found = model.bodies.find(label);
        require(!id || world.is_alive(id) == (found != model.bodies.end()), "life", label);
        if (found == model.bodies.end()) continue;
        const ModelBody& body = found->second;
        require(world.pose(id) == body.pose, "pose", label);
        require(world.shape(id)->kind() == body.part.kind, "kind", label);
        require(form_of(*world.shape(id)) == body.part.form, "form", label);
        require(radius_of(*world.shape(id)) == body.part.radius.value_or(0), "radius", label);
        require(is_same_mesh(*mesh_of(*world.shape(id)), *body.part.mesh), "shape", label);
        require(world.filter(id) == body.filter, "filter", label);
        require(world.user_data(id) == body.user_data, "user data", label);
    }
    check_switches(scripted, model);
}

}  // namespace ecods::fuzz
