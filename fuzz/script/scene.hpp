// Worlds to which a script is applied, all at once, and their state as it must be.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/world.hpp"
#include "fuzz/base/counters.hpp"
#include "fuzz/base/user_shape.hpp"
#include "fuzz/script/script.hpp"
#include "simd/instruction_set.hpp"

namespace ecods::fuzz {

// BodyOptions with a part of a script in place of mesh and shape.
struct PartOptions {
    Part shape;
    Pose pose = {};
    CollisionFilter filter = {};
    std::uint64_t user_data = 0;
};

// A world that takes the parts of a script for shapes: each call of World with a shape is here with a part. A part that
// is a mesh goes to the world as a mesh, and one that is a solid as the same object each time, so that all bodies of
// one part have one shape, and to set it again is no change.
class PartWorld : public World {
  public:
    using World::create_body;
    using World::set_shape;
    using World::World;
    BodyId create_body(const Part& part, const Pose& pose);
    BodyId create_body(const PartOptions& options);
    void set_shape(BodyId body, const Part& part);
    void set_pose(BodyId body, const Pose& pose);
    void set_filter(BodyId body, const CollisionFilter& filter);

    // The other world takes the place of this one; the shapes of parts stay the same objects.
    void become(World&& other) noexcept { World::operator=(std::move(other)); }

    // Returns the options that make the body again. A shape that the world made of a mesh is made of it again: only
    // then is that mesh, set as the body's shape, the very object that the body has.
    BodyOptions options_of(BodyId body) const;

    // From now on, or no more, an argument that is also what the world answers of some body is that answer.
    void use_own_answers(bool uses) noexcept { uses_own_answers_ = uses; }

  private:
    template <class Is>
    BodyId find_body(Is is) const;
    BodyId body_at(const Pose& pose) const;
    BodyId body_of(const Part& part) const;
    std::shared_ptr<const Shape> shape_of(const Part& part);

    bool uses_own_answers_ = false;
    std::set<std::shared_ptr<const Mesh>> refitted_;
    // Solids and rounded shapes, by mesh, form and the bits of the radius.
    using Made = std::tuple<std::shared_ptr<const Mesh>, MeshForm, std::optional<std::uint64_t>>;
    std::map<Made, std::shared_ptr<const Shape>> shapes_;
};

// A world with the user-defined tests, and the ids of the bodies that it made.
class ScriptedWorld {
  public:
    explicit ScriptedWorld(const WorldOptions& options);

    // Makes one call, but for bad ones, which bad_calls.hpp makes. An exception of the world passes through.
    void apply(const Call& call);

    PartWorld& world() noexcept { return world_; }
    const World& world() const noexcept { return world_; }
    const UserTests& tests() const noexcept { return tests_; }

    // The id of a body, even of a destroyed one. Null if none was created.
    BodyId id(Label label) const { return label < ids_.size() ? ids_[label] : BodyId{}; }

  private:
    template <template <class> class Row>
    void make(const Row<InScript>& scripted);
    void make_again();

    WorldOptions options_;
    UserTests tests_;
    PartWorld world_;
    std::vector<BodyId> ids_;  // by label
};

// A world for each broad phase, with no, two, three and four workers. All use every instruction set that the processor
// supports, by turns (schedule.hpp).
class Scene {
  public:
    Scene();

    // Every call goes to all worlds, which must answer alike. An update ends a round. `make` makes it in one of them.
    void apply(const Call& call);
    void apply(const Call& call, const std::function<void(ScriptedWorld&)>& make);

    // The instruction set with which a world's calls are made in this round.
    InstructionSet instruction_set(std::size_t world) const;

    // Makes an update in which every user-defined test throws. True if one was needed and so the update threw, in all
    // worlds; the lists then stay as they were.
    bool update_failing(Counters& counters);

    std::array<ScriptedWorld, 4> worlds;
    Model model;

  private:
    void require_same_ids(Label label) const;
    static void require_coming_ids(const ScriptedWorld& scripted, Label label, const std::vector<BodyId>& coming);

    std::size_t round_ = 0;
};

// Checks that poses, shapes, filters and data are those that were set last, and that destroyed bodies are gone. Throws
// CheckFailed.
void check_state(const ScriptedWorld& scripted, const Model& model);

}  // namespace ecods::fuzz
