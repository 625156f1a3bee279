#include "fuzz/motion/changes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/base/user_shape.hpp"
#include "fuzz/motion/calm.hpp"
#include "fuzz/motion/meshes.hpp"
#include "fuzz/motion/numbers.hpp"
#include "fuzz/motion/poses.hpp"
#include "fuzz/script/any_call.hpp"
#include "fuzz/script/bad_calls.hpp"

namespace ecods::fuzz {
namespace {

void destroy_and_create(Writing& w) {
    // Its slot is used again at once, often at the same place.
    const Label body = w.any_body();
    const ModelBody old = w.model.bodies.at(body);
    w.make(Destroy{body});
    w.create(w.random.below(2) == 0 ? old.part : w.any_part(), old.pose);
}

void remove_many(Writing& w, bool in_order_of_insertion) {
    std::vector<Label> bodies;
    for (const auto& [label, body] : w.model.bodies) {
        if (w.random.below(3) == 0) bodies.push_back(label);
    }
    if (!in_order_of_insertion) std::reverse(bodies.begin(), bodies.end());
    for (const Label body : bodies) w.make(Destroy{body});
    const bool comes_between = w.random.below(2) == 0;
    if (comes_between) w.make(Update{});
    for (std::size_t i = 0; i < bodies.size(); ++i) w.create(w.any_part(), any_pose(w.setting, w.random));
}

// An ebb: few are left, sometimes none, and then as many as before come.
void remove_most(Writing& w) {
    std::vector<Label> bodies;
    for (const auto& [label, body] : w.model.bodies) {
        if (w.random.below(10) != 0) bodies.push_back(label);
    }
    for (const Label body : bodies) w.make(Destroy{body});
    w.make(Update{});
    w.make(Update{});
    for (std::size_t i = 0; i < bodies.size(); ++i) w.create(w.any_part(), any_pose(w.setting, w.random));
}

void shape_and_back(Writing& w) {
    const Label body = w.any_body();
    const Part old = w.model.bodies.at(body).part;
    w.make(SetShape{body, w.any_part()});
    if (w.random.below(3) == 0) w.make(Update{});
    w.make(SetShape{body, old});
}

void refit_body(Writing& w) {
    const Label body = w.any_body();
    const Part& old = w.model.bodies.at(body).part;
    if (old.kind != ShapeKind::mesh()) return;
    w.make(SetShape{body, {.mesh = deformed(*old.mesh, w.setting.unit, w.random), .refits = true}});
}

void there_and_back(Writing& w) {
    const Label body = w.any_body();
    const Pose pose = w.model.bodies.at(body).pose;
    w.make(SetPose{body, any_pose(w.setting, w.random)});
    w.make(SetPose{body, pose});
}

void bulk(Writing& w, std::uint32_t Weights::*group, std::uint32_t one_in) {
    SetPoses call;
    for (const auto& [label, body] : w.model.bodies) {
        if (w.random.below(one_in) != 0) continue;
        // Now and then a body twice: the later pose holds.
        for (std::uint32_t i = 0, count = w.random.below(8) == 0 ? 2 : 1; i < count; ++i) {
            call.bodies.push_back(label);
            call.poses.push_back(w.next_pose(label, group));
        }
    }
    w.make(std::move(call));
}

void common_shift(Writing& w) {
    SetPoses call;
    const Pose shift = any_pose(w.setting, w.random);
    for (const auto& [label, body] : w.model.bodies) {
        call.bodies.push_back(label);
        call.poses.push_back({body.pose.R, body.pose.t + (shift.t - w.setting.origin)});
    }
    w.make(std::move(call));
}

// A third of them the default, lest all end up filtered out.
CollisionFilter any_filter(scenes::Random& random) {
    constexpr std::array<CollisionFilter, 7> filters = {{{},
                                                         {.groups = 1, .mask = 1},
                                                         {.groups = 1, .mask = 2},
                                                         {.groups = 2, .mask = 2},
                                                         {.groups = 2, .mask = 3},
                                                         {.groups = 3, .mask = 0},
                                                         {.groups = std::uint64_t{1} << 63}}};
    return filters[random.below(3) == 0 ? 0 : random.below(7)];
}

void set_filter(Writing& w) {
    const Label body = w.any_body();
    w.make(SetFilter{body, any_filter(w.random)});
}

// Mostly as large as gaps between bodies are; in powers of two, so that some are exactly the clearance.
std::optional<double> any_clearance(Writing& w) {
    switch (w.random.below(8)) {
        case 0:
            return std::nullopt;
        case 1:
            return 0;
        case 2:
            return w.setting.unit * w.random.uniform(0, 2);
        default:
            return std::ldexp(w.setting.unit, 1 - static_cast<int>(w.random.below(6)));
    }
}

// Several pairs of one body are switched off, and one of them on again.
void set_pairs_of_a_body(Writing& w) {
    const Label body = w.any_body();
    std::vector<Label> partners;
    for (std::uint32_t i = 0; i < 4; ++i) {
        const Label partner = w.any_body();
        if (partner == body) continue;
        w.make(SetPairEnabled{partner, body, false});
        partners.push_back(partner);
    }
    if (!partners.empty()) w.make(SetPairEnabled{body, partners.front(), true});
}

// A surface, a solid or a convex solid of the same mesh.
void other_form(Writing& w) {
    const Label body = w.any_body();
    Part part = w.model.bodies.at(body).part;
    part.form = static_cast<MeshForm>(w.random.below(3));
    if (part.kind == ShapeKind::mesh() && has_form(part.mesh, part.form)) w.make(SetShape{body, part});
}

// Gives a body the same core with another radius, or without one.
void other_radius(Writing& w) {
    const Label body = w.any_body();
    Part part = w.model.bodies.at(body).part;
    if (part.kind == first_user_kind || part.kind == second_user_kind) return;
    if (part.radius && w.random.below(4) == 0) {
        part.radius.reset();
        part.kind = ShapeKind::mesh();
    } else {
        part = rounded_part(part, any_radius(w.setting.unit, w.random));
    }
    part.refits = false;
    w.make(SetShape{body, part});
}

// What a body gets is what another has.
void clone(Writing& w) {
    const Part part = w.model.bodies.at(w.any_body()).part;
    w.create(part, w.model.bodies.at(w.any_body()).pose);
}

void poses_in_turn(Writing& w) {
    SetPoses call;
    for (const auto& [label, body] : w.model.bodies) {
        call.bodies.push_back(label);
        call.poses.push_back(body.pose);
    }
    std::rotate(call.poses.begin(), std::next(call.poses.begin()), call.poses.end());
    w.make(std::move(call));
}

void set_pair(Writing& w) {
    const Label a = w.any_body();
    const Label b = w.any_body();
    if (a == b) return;
    w.make(SetPairEnabled{a, b, w.random.below(2) == 0});
    if (w.random.below(6) == 0) w.make(SetPairEnabled{b, a, true});
}

void bad_call(Writing& w) {
    static const std::vector<std::string> names = bad_call_names();
    const std::string& name = names[w.random.below(static_cast<std::uint32_t>(names.size()))];
    const Label body = w.any_body();
    w.make(BadCall{body, w.random.below(1000), name});
}

// The source that any call draws from.
struct DrawnFrom {
    Writing& w;

    std::uint32_t below(std::uint32_t count) const { return w.random.below(count); }
    Label next_label() const { return w.model.next_label; }
    Label any_body() const { return w.any_body(); }
    Part any_part() const { return w.any_part(); }
    Pose any_pose() const { return fuzz::any_pose(w.setting, w.random); }
    CollisionFilter any_filter() const { return fuzz::any_filter(w.random); }
    std::optional<double> any_clearance() const { return fuzz::any_clearance(w); }
};

void make_any_call(Writing& w) {
    DrawnFrom source{w};
    if (auto call = any_call(source)) w.make(std::move(*call));
}

const std::array change_table = {
    Change{"create", &Weights::life, [](Writing& w) { w.create(w.any_part(), any_pose(w.setting, w.random)); }},
    Change{"destroy", &Weights::life, [](Writing& w) { w.make(Destroy{w.any_body()}); }},
    Change{"destroy and create", &Weights::life, destroy_and_create},
    Change{"removal in order of insertion", &Weights::life, [](Writing& w) { remove_many(w, true); }},
    Change{"removal in reverse order", &Weights::life, [](Writing& w) { remove_many(w, false); }},
    Change{"removal of most", &Weights::life, remove_most},
    Change{"there and back", &Weights::jump, there_and_back},
    Change{"shape change", &Weights::shape,
           [](Writing& w) {
               w.make(SetShape{w.any_body(), w.any_part()});
           }},
    Change{"shape change and back", &Weights::shape, shape_and_back},
    Change{"refit", &Weights::shape, refit_body},
    Change{"many poses: steps", &Weights::bulk, [](Writing& w) { bulk(w, &Weights::step, 2); }},
    Change{"many poses: all step", &Weights::bulk, [](Writing& w) { bulk(w, &Weights::step, 1); }},
    Change{"many poses: all jump", &Weights::bulk, [](Writing& w) { bulk(w, &Weights::jump, 1); }},
    Change{"many poses: common shift", &Weights::bulk, common_shift},
    Change{"room reserved", &Weights::bulk, [](Writing& w) { w.make(Reserve{w.random.below(200)}); }},
    Change{"filter", &Weights::filter, set_filter},
    Change{"pair switched", &Weights::filter, set_pair},
    Change{"pairs of a body switched", &Weights::filter, set_pairs_of_a_body},
    Change{"clearance", &Weights::filter, [](Writing& w) { w.make(SetClearance{any_clearance(w)}); }},
    Change{"user data", &Weights::filter,
           [](Writing& w) {
               w.make(SetUserData{w.any_body(), w.random.below(100) * 0x100000001u});
           }},
    Change{"clone", &Weights::own, clone},
    Change{"pose of another", &Weights::own,
           [](Writing& w) {
               w.make(SetPose{w.any_body(), w.model.bodies.at(w.any_body()).pose});
           }},
    Change{"poses in turn", &Weights::own, poses_in_turn},
    Change{"shape of another", &Weights::own,
           [](Writing& w) {
               w.make(SetShape{w.any_body(), w.model.bodies.at(w.any_body()).part});
           }},
    Change{"filter of another", &Weights::own,
           [](Writing& w) {
               w.make(SetFilter{w.any_body(), w.model.bodies.at(w.any_body()).filter});
           }},
    Change{"tests registered again", &Weights::tests, [](Writing& w) { w.make(SetTests{}); }},
    Change{"update that may throw", &Weights::tests, [](Writing& w) { w.make(Update{.fails = true}); }},
    Change{"bad input", &Weights::misuse, bad_call},
    Change{"relations listed", &Weights::solids, [](Writing& w) { w.make(SetRelations{w.random.below(3) != 0}); }},
    Change{"another form", &Weights::solids, other_form},
    Change{"another radius", &Weights::radius, other_radius},
    Change{"any call", &Weights::any, make_any_call},
    Change{"calm motion", &Weights::calm, calm_motion},
};

}  // namespace

std::span<const Change> changes() {
    return change_table;
}

}  // namespace ecods::fuzz
