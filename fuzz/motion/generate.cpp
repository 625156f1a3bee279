#include "fuzz/motion/generate.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "fuzz/base/user_shape.hpp"
#include "fuzz/motion/calm.hpp"
#include "fuzz/motion/changes.hpp"
#include "fuzz/motion/extremes.hpp"
#include "fuzz/motion/meshes.hpp"
#include "fuzz/motion/numbers.hpp"
#include "fuzz/motion/poses.hpp"
#include "fuzz/script/manners.hpp"

namespace ecods::fuzz {
namespace {

using Group = std::uint32_t Weights::*;

constexpr Group groups[] = {&Weights::step,   &Weights::contact, &Weights::ulp,     &Weights::size,   &Weights::jump,
                            &Weights::matrix, &Weights::life,    &Weights::shape,   &Weights::filter, &Weights::bulk,
                            &Weights::tests,  &Weights::misuse,  &Weights::extreme, &Weights::own,    &Weights::solids,
                            &Weights::any,    &Weights::calm,    &Weights::radius};

Group any_group(const Weights& weights, scenes::Random& random) {
    std::uint32_t sum = 0;
    for (const Group group : groups) sum += weights.*group;
    std::uint32_t drawn = random.below(sum);
    for (const Group group : groups) {
        if (drawn < weights.*group) return group;
        drawn -= weights.*group;
    }
    return groups[0];
}

template <class Item>
const Item& any_of(std::span<const Item> items, Group group, scenes::Random& random) {
    std::uint32_t count = 0;
    for (const Item& item : items) count += item.group == group ? 1 : 0;
    std::uint32_t drawn = random.below(count);
    for (const Item& item : items) {
        if (item.group == group && drawn-- == 0) return item;
    }
    return items.front();
}

template <class Item>
std::uint32_t count_of(std::span<const Item> items, Group group) {
    std::uint32_t count = 0;
    for (const Item& item : items) count += item.group == group ? 1 : 0;
    return count;
}

// A move or a change of some group.
void make_change(Writing& w) {
    if (w.model.bodies.empty()) return w.create(w.any_part(), any_pose(w.setting, w.random));
    const Group group = any_group(w.setting.profile.weights, w.random);
    const std::uint32_t move_count = count_of(moves(), group);
    if (w.random.below(move_count + count_of(changes(), group)) < move_count) {
        const Label body = w.any_body();
        w.make(SetPose{body, w.next_pose(body, group)});
        return;
    }
    const Change& change = any_of(changes(), group, w.random);
    // About as many as at the beginning.
    const bool is_full = w.model.bodies.size() > w.setting.body_count + 2;
    if (is_full && change.name == std::string_view("create")) return w.make(Destroy{w.any_body()});
    ++w.counters["changes: " + std::string(change.name)];
    change.make(w);
}

}  // namespace

void Writing::make(Call call) {
    const std::uint32_t one_in = setting.profile.manner_one_in;
    if (one_in != 0 && random.below(one_in) == 0) {
        static const std::vector<std::string> manners = manner_names();
        const std::string& manner = manners[random.below(static_cast<std::uint32_t>(manners.size()))];
        script.push_back(Manner{random.below(10000), manner});
    }
    model.apply(call);
    if (const auto body = created_body(call)) homes[*body] = model.bodies.at(*body).pose;
    script.push_back(std::move(call));
}

void Writing::create(const Part& part, const Pose& pose) {
    make(Create{model.next_label, part, pose});
}

Label Writing::any_body() {
    const auto index = random.below(static_cast<std::uint32_t>(model.bodies.size()));
    return std::next(model.bodies.begin(), index)->first;
}

const Part& Writing::any_part() {
    return setting.parts[random.below(static_cast<std::uint32_t>(setting.parts.size()))];
}

Pose Writing::next_pose(Label body, Group group) {
    const Move& move = any_of(moves(), group, random);
    ++counters["motions: " + std::string(move.name)];
    const Pose pose = move.next({model.bodies.at(body), model.bodies.at(any_body()), homes.at(body), setting, random});
    // Where huge numbers met, it may have overflown.
    return pose.R.allFinite() && pose.t.allFinite() ? pose : homes.at(body);
}

namespace {

// Most are solids, and those that can be convex solids, as what is scaled into subnormal numbers may not; one is a
// surface, of the mesh of another or of its own.
void take_forms(std::vector<Part>& parts, scenes::Random& random) {
    for (Part& part : parts) {
        for (const MeshForm form : {MeshForm::solid, MeshForm::convex}) {
            if (random.below(4) != 0 && has_form(part.mesh, form)) part.form = form;
        }
    }
    Part& surface = parts.back();
    surface.form = MeshForm::surface;
    if (random.below(2) == 0) surface.mesh = parts.front().mesh;
}

Pose first_pose(const Writing& w, std::uint32_t i) {
    switch (w.setting.profile.layout) {
        case Layout::stacked:
            return stacked_pose(w.setting, i);
        case Layout::crowded:
            return calm_pose(w.setting, w.model, i, w.random);
        case Layout::scattered:
            break;
    }
    return any_pose(w.setting, w.random);
}

// Allocations fail meanwhile where any may.
void make_again(Writing& w, scenes::Random& random) {
    if (w.setting.profile.manner_one_in != 0) {
        w.script.push_back(Manner{random.below(10000), "failing allocations"});
    }
    w.script.push_back(MakeAgain{});
}

}  // namespace

Setting make_setting(const Profile& profile, scenes::Random& random, Counters& counters) {
    Setting setting{profile};
    const std::uint32_t drawn = random.below(8);
    if (profile.scale == Scale::far || (profile.scale == Scale::any && drawn == 0)) {
        ++counters["scenes: far from the origin"];
        for (double& x : setting.origin) {
            x = (random.below(2) == 0 ? 1.5 : -1) * std::ldexp(1.0, static_cast<int>(random.below(56)));
        }
    } else if (profile.scale == Scale::any && drawn == 1) {
        // The smallest coordinates are multiples of the smallest subnormal.
        ++counters["scenes: subnormal"];
        setting.unit = 0x1p-1060;
    } else if (profile.scale == Scale::any && drawn == 2) {
        ++counters["scenes: huge"];
        setting.unit = 0x1p900;
    } else if (profile.scale == Scale::extreme) {
        ++counters["scenes: of extremes"];
        setting.unit = std::min(extreme_unit(random), 0x1p900);
    } else {
        ++counters["scenes: of unit size"];
    }
    const std::uint32_t lattice = random.below(3);
    if (lattice == 1) setting.lattice = any_rotation(random);
    if (lattice == 2) setting.lattice = signed_permutation(random);
    for (int i = 0; i < 5; ++i) {
        const double unit = profile.scale == Scale::extreme ? extreme_unit(random) : setting.unit;
        setting.parts.push_back({make_mesh(profile.meshes, unit, random, counters)});
    }
    if (profile.meshes == Meshes::solids) take_forms(setting.parts, random);
    if (profile.has_user_shapes) {
        setting.parts[1].kind = first_user_kind;
        setting.parts[3].kind = second_user_kind;
    }
    if (profile.has_radii) {
        for (std::size_t i = 0; i < setting.parts.size(); ++i) {
            const Part& core = setting.parts[i == 0 ? 1 : i];
            if (i != 2) setting.parts[i] = rounded_part(core, any_radius(setting.unit, random));
        }
    }
    setting.body_count = profile.bodies_min + random.below(profile.bodies_max - profile.bodies_min + 1);
    return setting;
}

Script generate(const Profile& profile, std::uint32_t seed, Counters& counters) {
    scenes::Random random(seed);
    const Setting setting = make_setting(profile, random, counters);
    Writing writing{setting, random, counters};
    for (std::uint32_t i = 0; i < setting.body_count; ++i) {
        const Part& part = writing.any_part();
        writing.create(part, first_pose(writing, i));
    }
    if (profile.weights.solids > 0 && random.below(4) != 0) writing.make(SetRelations{true});
    writing.make(Update{});
    // A generator of its own draws when the worlds are made again: all else that a seed stands for stays as it is.
    scenes::Random of_copies(~seed);
    for (std::uint32_t frame = 1; frame < profile.frames; ++frame) {
        // Every eighth frame rests.
        const std::uint32_t count = random.below(8) == 0 ? 0 : 1 + random.below(profile.changes_max);
        for (std::uint32_t i = 0; i < count; ++i) make_change(writing);
        if (of_copies.below(profile.again_one_in) == 0) make_again(writing, of_copies);
        // The last is looked at.
        const bool is_quiet = random.below(5) == 0 && frame + 1 < profile.frames;
        writing.make(Update{.is_quiet = is_quiet});
    }
    for (const Call& call : writing.script) ++counters["calls: " + std::string(name_of(call))];
    return std::move(writing.script);
}

}  // namespace ecods::fuzz
