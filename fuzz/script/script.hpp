// The calls that a world is given, as plain data: made by the generator, played with checks, shrunk, written as a trace
// and read from one.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "ecods/collision_filter.hpp"
#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"

namespace ecods::fuzz {

// A body by the number of bodies that were created before it. A script knows no ids, so that calls can be dropped.
using Label = std::size_t;

// What a body is made of. Kinds other than that of meshes are user_shape.hpp's.
struct Part {
    std::shared_ptr<const Mesh> mesh;
    ShapeKind kind = ShapeKind::mesh();
};

struct Create {
    Label body;
    Part part;
    Pose pose;
};
struct Destroy {
    Label body;
};
struct SetPose {
    Label body;
    Pose pose;
};
struct SetPoses {
    std::vector<Label> bodies;  // as many as poses
    std::vector<Pose> poses;
};
struct SetShape {
    Label body;
    Part part;
    bool refits = false;  // if the body is a mesh of the same triangles, by refit()
};
struct SetFilter {
    Label body;
    CollisionFilter filter;
};
struct SetPairEnabled {
    Label a;
    Label b;
    bool is_enabled;
};
struct SetUserData {
    Label body;
    std::uint64_t data;
};
struct Reserve {
    std::size_t count;
};
struct SetTests {};  // the tests of all user-defined shapes are registered again

// A call that must be refused (bad_calls.hpp): which one, and where it may choose, what.
struct BadCall {
    std::string name;
    Label body;
    std::uint32_t choice = 0;
};

struct Update {
    bool fails = false;                        // tests of user-defined shapes throw
    bool is_quiet = false;                     // nobody reads the lists, which is a check left out
    std::optional<std::uint64_t> digest = {};  // as a trace has it
};

using Call = std::variant<Create, Destroy, SetPose, SetPoses, SetShape, SetFilter, SetPairEnabled, SetUserData, Reserve,
                          SetTests, BadCall, Update>;
using Script = std::vector<Call>;

// As World has it: "set_pose".
const char* name_of(const Call& call);

// For std::visit.
template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

// The calls so far: the bodies as they must be.
struct ModelBody {
    Part part;
    Pose pose;
    CollisionFilter filter = {};
    std::uint64_t user_data = 0;
};
struct Model {
    std::map<Label, ModelBody> bodies = {};
    Label next_label = 0;

    // Nothing happens to bodies that are not there.
    void apply(const Call& call);
};

// Without calls for bodies that are not there, as they are left when calls are dropped; labels counted anew.
Script repaired(const Script& script);

}  // namespace ecods::fuzz
