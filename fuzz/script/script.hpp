// The calls that a world is given, as plain data: made by the generator, played with checks, shrunk, written as a trace
// and read from one. They are the rows of trace/calls.hpp, where bodies are labels and shapes are parts, and a few
// more.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/mesh.hpp"
#include "ecods/pose.hpp"
#include "ecods/world_options.hpp"
#include "fuzz/base/mesh_form.hpp"
#include "trace/calls.hpp"

namespace ecods::fuzz {

// A script knows no ids, so that calls can be dropped.
using calls::Label;

// The shape of a body. Kinds other than those of meshes and rounded shapes are user_shape.hpp's, and surfaces.
struct Part {
    std::shared_ptr<const Mesh> mesh;  // of the core, if it is rounded
    ShapeKind kind = ShapeKind::mesh();
    MeshForm form = MeshForm::surface;
    bool refits = false;  // by refit() of the shape that the body has, if that is a mesh of the same triangles
    std::optional<double> radius = {};  // of a rounded shape
};

// The part with this radius.
Part rounded_part(Part part, double radius);

struct InScript {
    using Body = Label;
    using Shape = Part;
    template <class Item>
    using List = std::vector<Item>;
};
using Create = calls::Create<InScript>;
using Destroy = calls::Destroy<InScript>;
using SetPose = calls::SetPose<InScript>;
using SetPoses = calls::SetPoses<InScript>;
using SetShape = calls::SetShape<InScript>;
using SetFilter = calls::SetFilter<InScript>;
using SetPairEnabled = calls::SetPairEnabled<InScript>;
using SetUserData = calls::SetUserData<InScript>;
using SetClearance = calls::SetClearance<InScript>;
using SetRelations = calls::SetRelations<InScript>;

// ---- calls that a trace does not hold. They stand in its notes, which ecods_replay passes over.

struct Reserve {
    static constexpr std::string_view name = "reserve";
    std::uint32_t count;
    static void fields(auto&& each, auto&... call) { each.number(call.count...); }
};

// The tests of all user-defined shapes are registered again.
struct SetTests {
    static constexpr std::string_view name = "tests";
    static void fields(auto&&, auto&...) {}
};

// The world is made again, its bodies under the ids that they have (WorldOptions::ids). It has no lists before its next
// update.
struct MakeAgain {
    static constexpr std::string_view name = "make_again";
    static void fields(auto&&, auto&...) {}
};

// A call that must be refused (bad_calls.hpp): its kind, and a number from which it draws where it may choose.
struct BadCall {
    static constexpr std::string_view name = "bad";
    Label body;
    std::uint32_t choice;
    std::string kind;
    static void fields(auto&& each, auto&... call) {
        each.body(call.body...);
        each.number(call.choice...);
        each.text(call.kind...);
    }
};
// How the call that follows is made (manners.hpp).
struct Manner {
    static constexpr std::string_view name = "manner";
    std::uint32_t choice;
    std::string kind;
    static void fields(auto&& each, auto&... call) {
        each.number(call.choice...);
        each.text(call.kind...);
    }
};
using NoteCall = std::variant<Reserve, SetTests, MakeAgain, BadCall, Manner>;

struct Update {
    static constexpr std::string_view name = "update";
    bool fails = false;                        // tests of user-defined shapes throw
    bool is_quiet = false;                     // nobody reads the lists, which is a check left out
    std::optional<std::uint64_t> digest = {};  // as a trace has it
    static void fields(auto&& each, auto&... call) {
        each.option(call.fails...);
        each.option(call.is_quiet...);
    }
};

using Call = calls::Call<InScript, Reserve, SetTests, MakeAgain, BadCall, Manner, Update>;
using Script = std::vector<Call>;

// Visits no field of any of them.
struct NoField : calls::NoField {
    void number(auto&...) const noexcept {}
    void text(auto&...) const noexcept {}
    void option(auto&...) const noexcept {}
};

// "set_pose"
std::string_view name_of(const Call& call);

// The body that the call makes, if it makes one.
std::optional<Label> created_body(const Call& call);

// For std::visit.
template <class... Functions>
struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

// The bodies as they must be after the calls so far.
struct ModelBody {
    Part part;
    Pose pose;
    CollisionFilter filter = {};
    std::uint64_t user_data = 0;
};
struct Model {
    std::map<Label, ModelBody> bodies = {};
    Label next_label = 0;
    std::set<std::pair<Label, Label>> switched_off = {};  // the smaller label first
    std::optional<double> clearance = {};
    bool relations = false;

    // Nothing happens to bodies that are not there.
    void apply(const Call& call);
};

// Without calls for bodies that are not there, which remain when calls are dropped; labels are counted again.
Script repaired(const Script& script);

}  // namespace ecods::fuzz
