// Defines the table of calls. Each call of World that a trace holds is one row: a struct with the call's name in the
// text, its arguments, the function of World that it calls, and its fields in the order of the text. The writer, the
// reader, the replay, the fuzzer's scripts and their shrinking follow from these rows; src/README.md says how to add a
// row.
//
// A row is a template over Names, a type that says how bodies, shapes and lists are named: by ids and shape numbers
// while a trace is written, by the order of creation while it is read, and by meshes in place of shapes in a fuzzer's
// script.
//
// `fields` passes each field to a visitor, by the kind of the field:
//
//     created    a body that the call creates             pose, filter
//     destroyed  a body that the call destroys            flag       true or false
//     body       any other body                           data       64 bits of the caller's own
//     other_body the second, different body of a pair     clearance  a distance, or none
//     shape      a shape or mesh                          posed_bodies   as many bodies as poses
//
// If `fields` is given several calls of one row, it passes the same field of all calls to the visitor together. So a
// visitor can copy a call to a call with other names.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/shape.hpp"
#include "ecods/world_options.hpp"

namespace ecods::calls {

// Names a body by order: the number of bodies created before it.
using Label = std::size_t;

// The next three types say how a row names bodies, shapes and lists.

// Tracing is the naming while a trace is written: ids, and numbers of shapes.
struct Tracing {
    using Body = BodyId;
    using Shape = std::uint64_t;  // the shape's number in the text
    template <class Item>
    using List = std::span<const Item>;
};

// InOrder is the naming while a trace is read: bodies and shapes by their order of creation.
struct InOrder {
    using Body = Label;
    using Shape = std::size_t;  // number of meshes and shapes before this one in the text
    template <class Item>
    using List = std::vector<Item>;
};

// InWorld is the naming in a World: ids, and the shapes themselves.
struct InWorld {
    using Body = BodyId;
    using Shape = std::shared_ptr<const ecods::Shape>;
    template <class Item>
    using List = std::vector<Item>;
};

// The structs down to SetRelations are the rows of the table, one for each call of World.

template <class Names>
struct Create {
    static constexpr std::string_view name = "create";
    typename Names::Body body;  // the result
    typename Names::Shape shape;
    Pose pose;

    static void fields(auto&& each, auto&... call) {
        each.created(call.body...);
        each.shape(call.shape...);
        each.pose(call.pose...);
    }
    void make(auto& world) { body = world.create_body(shape, pose); }
};

template <class Names>
struct CreateWith {
    static constexpr std::string_view name = "create_with";
    typename Names::Body body;  // the result
    typename Names::Shape shape;
    Pose pose;
    CollisionFilter filter;
    std::uint64_t user_data;

    static void fields(auto&& each, auto&... call) {
        each.created(call.body...);
        each.shape(call.shape...);
        each.pose(call.pose...);
        each.filter(call.filter...);
        each.data(call.user_data...);
    }
    void make(auto& world) {
        body = world.create_body({.shape = shape, .pose = pose, .filter = filter, .user_data = user_data});
    }
};

template <class Names>
struct Destroy {
    static constexpr std::string_view name = "destroy";
    typename Names::Body body;

    static void fields(auto&& each, auto&... call) { each.destroyed(call.body...); }
    void make(auto& world) const { world.destroy_body(body); }
};

template <class Names>
struct SetPose {
    static constexpr std::string_view name = "set_pose";
    typename Names::Body body;
    Pose pose;

    static void fields(auto&& each, auto&... call) {
        each.body(call.body...);
        each.pose(call.pose...);
    }
    void make(auto& world) const { world.set_pose(body, pose); }
};

template <class Names>
struct SetPoses {
    static constexpr std::string_view name = "set_poses";
    typename Names::template List<typename Names::Body> bodies;
    typename Names::template List<Pose> poses;

    static void fields(auto&& each, auto&... call) { each.posed_bodies(call.bodies..., call.poses...); }
    void make(auto& world) const { world.set_poses(bodies, poses); }
};

template <class Names>
struct SetShape {
    static constexpr std::string_view name = "set_shape";
    typename Names::Body body;
    typename Names::Shape shape;

    static void fields(auto&& each, auto&... call) {
        each.body(call.body...);
        each.shape(call.shape...);
    }
    void make(auto& world) const { world.set_shape(body, shape); }
};

template <class Names>
struct SetFilter {
    static constexpr std::string_view name = "set_filter";
    typename Names::Body body;
    CollisionFilter filter;

    static void fields(auto&& each, auto&... call) {
        each.body(call.body...);
        each.filter(call.filter...);
    }
    void make(auto& world) const { world.set_filter(body, filter); }
};

template <class Names>
struct SetPairEnabled {
    static constexpr std::string_view name = "set_pair_enabled";
    typename Names::Body a;
    typename Names::Body b;
    bool is_enabled;

    static void fields(auto&& each, auto&... call) {
        each.body(call.a...);
        each.other_body(call.b...);
        each.flag(call.is_enabled...);
    }
    void make(auto& world) const { world.set_pair_enabled(a, b, is_enabled); }
};

template <class Names>
struct SetUserData {
    static constexpr std::string_view name = "set_user_data";
    typename Names::Body body;
    std::uint64_t data;

    static void fields(auto&& each, auto&... call) {
        each.body(call.body...);
        each.data(call.data...);
    }
    void make(auto& world) const { world.set_user_data(body, data); }
};

template <class Names>
struct SetClearance {
    static constexpr std::string_view name = "set_clearance";
    std::optional<double> clearance;

    static void fields(auto&& each, auto&... call) { each.clearance(call.clearance...); }
    void make(auto& world) const { world.set_clearance(clearance); }
};

template <class Names>
struct SetRelations {
    static constexpr std::string_view name = "set_relations";
    static constexpr std::string_view old_name = "set_solids";  // in version 1
    bool are_listed;

    static void fields(auto&& each, auto&... call) { each.flag(call.are_listed...); }
    void make(auto& world) const { world.set_relations(are_listed); }
};

// A Call is one row of the table: one of the calls above, or a row in `Others`.

template <class Names, class... Others>
using Call = std::variant<Create<Names>, CreateWith<Names>, Destroy<Names>, SetPose<Names>, SetPoses<Names>,
                          SetShape<Names>, SetFilter<Names>, SetPairEnabled<Names>, SetUserData<Names>,
                          SetClearance<Names>, SetRelations<Names>, Others...>;

// Lists the names of the rows of a Call, by index.
template <class AnyCall>
inline constexpr int row_names = 0;
template <class... Rows>
inline constexpr std::array<std::string_view, sizeof...(Rows)> row_names<std::variant<Rows...>> = {Rows::name...};

// Sets `call` to the row with this index, with empty arguments.
template <class AnyCall, std::size_t... indices>
void emplace_row(AnyCall& call, std::size_t index, std::index_sequence<indices...>) {
    ((indices == index ? void(call.template emplace<indices>()) : void()), ...);
}
template <class AnyCall>
void emplace_row(AnyCall& call, std::size_t index) {
    emplace_row(call, index, std::make_index_sequence<std::variant_size_v<AnyCall>>());
}

// Sets `call` to the row with this name, with empty arguments, and returns true. Returns false, and leaves `call`
// unchanged, if no row has this name.
template <class AnyCall>
bool emplace_row(AnyCall& call, std::string_view name) {
    const auto& names = row_names<AnyCall>;
    const auto found = std::ranges::find(names, name);
    if (found == names.end()) return false;
    emplace_row(call, static_cast<std::size_t>(found - names.begin()));
    return true;
}

// The classes below are visitors of the fields of rows.

// NoField ignores every field. The struct is a base class for visitors that need only some kinds of fields.
struct NoField {
    void created(auto&...) const noexcept {}
    void destroyed(auto&...) const noexcept {}
    void body(auto&...) const noexcept {}
    void other_body(auto&...) const noexcept {}
    void shape(auto&...) const noexcept {}
    void pose(auto&...) const noexcept {}
    void posed_bodies(auto&...) const noexcept {}
    void filter(auto&...) const noexcept {}
    void flag(auto&...) const noexcept {}
    void data(auto&...) const noexcept {}
    void clearance(auto&...) const noexcept {}
};

// Copies fields from one call to another. `body_of` and `shape_of` translate the names of bodies and shapes. A created
// body is copied only if both names are labels: an id is known only after the call is made.
template <class BodyOf, class ShapeOf>
struct CopyFields {
    BodyOf body_of;
    ShapeOf shape_of;

    void created(const auto&, auto&) const noexcept {}
    void created(const Label& from, Label& to) const noexcept { to = from; }
    void destroyed(const auto& from, auto& to) const { to = body_of(from); }
    void body(const auto& from, auto& to) const { to = body_of(from); }
    void other_body(const auto& from, auto& to) const { to = body_of(from); }
    void shape(const auto& from, auto& to) const { to = shape_of(from); }
    void posed_bodies(const auto& from, auto& to, const auto& from_poses, auto& to_poses) const {
        for (const auto& each : from) to.push_back(body_of(each));
        to_poses = from_poses;
    }
    void pose(const auto& from, auto& to) const { to = from; }
    void filter(const auto& from, auto& to) const { to = from; }
    void flag(const auto& from, auto& to) const { to = from; }
    void data(const auto& from, auto& to) const { to = from; }
    void clearance(const auto& from, auto& to) const { to = from; }

    // The following kinds of fields occur in questions only (questions.hpp).
    void answer(const auto& from, auto& to) const { to = from; }
    void line(const auto& from, auto& to) const { to = from; }
    void motion(const auto& from, auto& to) const { to = from; }
    void moved_bodies(const auto& from, auto& to, const auto& from_motions, auto& to_motions) const {
        posed_bodies(from, to, from_motions, to_motions);
    }
    void point(const auto& from, auto& to) const { to = from; }
    void number(const auto& from, auto& to) const { to = from; }
    void optional_filter(const auto& from, auto& to) const { to = from; }
    void groups(const auto& from, auto& to) const { to = from; }
};

// Returns the same call with other names. `body_of` and `shape_of` translate the names of bodies and shapes.
template <class To, template <class> class Row, class From, class BodyOf, class ShapeOf>
Row<To> renamed(const Row<From>& call, BodyOf body_of, ShapeOf shape_of) {
    Row<To> result{};
    Row<To>::fields(CopyFields<BodyOf, ShapeOf>{body_of, shape_of}, call, result);
    return result;
}

}  // namespace ecods::calls
