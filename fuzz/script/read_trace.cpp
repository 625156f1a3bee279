#include <map>
#include <string>
#include <utility>
#include <vector>

#include "ecods/error.hpp"
#include "fuzz/script/trace.hpp"
#include "fuzz/base/user_shape.hpp"
#include "trace/trace_lines.hpp"
#include "trace/trace_text.hpp"

namespace ecods::fuzz {
namespace {

constexpr std::uint64_t max_32 = ~std::uint32_t{0};
constexpr std::uint64_t max_64 = ~std::uint64_t{0};

class Reader {
  public:
    explicit Reader(std::istream& in) : lines_(in) {}
    Script read();

  private:
    void read_line();
    void read_mesh();
    void read_shape();
    void read_note();
    void read_update();
    Call read_call(std::string_view name);
    SetPoses read_poses();
    Label body();
    const Part& part();

    TraceLines lines_;
    Script script_;
    std::map<std::uint64_t, Part> parts_;
    std::map<BodyId, Label> labels_;  // of bodies that are there
    Label next_label_ = 0;
    bool refits_ = false;    // the next shape is a refit
    bool fails_ = false;     // of the next update, tests throw
    bool is_quiet_ = false;  // the next update is
};

Script Reader::read() {
    if (!lines_.next() || lines_.rest() != trace_header) throw InvalidTrace(1, "this is no trace");
    lines_.require_next("world");
    while (lines_.next()) {
        try {
            read_line();
        } catch (const InvalidTrace&) {
            throw;
        } catch (const Error& error) {
            lines_.fail(error.what());
        }
    }
    return std::move(script_);
}

void Reader::read_line() {
    const std::string name(lines_.word("a call"));
    if (name == "mesh") return read_mesh();
    if (name == "shape") return read_shape();
    if (name == "note") return read_note();
    if (name == "update") return read_update();
    script_.push_back(read_call(name));
    lines_.require_end();
}

void Reader::read_mesh() {
    const std::uint64_t number = lines_.decimal("a number", max_64);
    const std::uint64_t vertex_count = lines_.decimal("a number of vertices", max_32);
    const std::uint64_t triangle_count = lines_.decimal("a number of triangles", max_32);
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
    for (std::uint64_t i = 0; i < vertex_count; ++i) {
        lines_.require_next("v");
        vertices.push_back(lines_.point());
    }
    for (std::uint64_t i = 0; i < triangle_count; ++i) {
        lines_.require_next("t");
        Triangle& triangle = triangles.emplace_back();
        for (std::uint32_t& corner : triangle) corner = static_cast<std::uint32_t>(lines_.decimal("a vertex", max_32));
    }
    parts_[number] = {Mesh::create(std::move(vertices), std::move(triangles))};
}

void Reader::read_shape() {
    const std::uint64_t number = lines_.decimal("a number", max_64);
    const ShapeKind kind{static_cast<std::uint32_t>(lines_.decimal("a kind", max_32))};
    if (kind != first_user_kind && kind != second_user_kind) lines_.fail("there is no such kind of shape here");
    parts_[number] = {read_user_mesh(lines_.rest()), kind};
}

// Other notes are for people.
void Reader::read_note() {
    if (lines_.rest_is("refit")) {
        refits_ = true;
    } else if (lines_.rest_is("failing")) {
        fails_ = true;
    } else if (lines_.rest_is("quiet")) {
        is_quiet_ = true;
    } else if (lines_.rest_is("tests")) {
        script_.emplace_back(SetTests{});
    } else if (!lines_.at_end()) {
        const std::string kind(lines_.word("a note"));
        if (kind == "reserve") {
            script_.emplace_back(Reserve{lines_.decimal("a number of bodies", max_32)});
        } else if (kind == "bad") {
            const Label of = body();
            const auto choice = static_cast<std::uint32_t>(lines_.decimal("a choice", max_32));
            script_.emplace_back(BadCall{std::string(lines_.rest()), of, choice});
        }
    }
}

// An update that failed because tests threw is a part of the one that follows; of any other, and of a crash, what it
// should have given is not known.
void Reader::read_update() {
    Update update{.fails = fails_, .is_quiet = is_quiet_};
    if (lines_.rest_is("failed")) {
        if (!fails_) script_.emplace_back(update);
        return;
    }
    if (!lines_.at_end()) {
        update.digest = lines_.hex("a digest");
        lines_.decimal("a number of pairs", max_64);
        lines_.require_end();
    }
    fails_ = is_quiet_ = false;
    script_.emplace_back(update);
}

Call Reader::read_call(std::string_view name) {
    if (name == "create") {
        const BodyId made = lines_.body();
        if (!labels_.emplace(made, next_label_).second) lines_.fail("this body is here already");
        const Part& of = part();
        return Create{next_label_++, of, lines_.pose()};
    }
    if (name == "set_poses") return read_poses();
    const BodyId id = lines_.body();
    const auto found = labels_.find(id);
    if (found == labels_.end()) lines_.fail("there is no such body");
    const Label of = found->second;
    if (name == "destroy") {
        labels_.erase(found);
        return Destroy{of};
    }
    if (name == "set_pose") return SetPose{of, lines_.pose()};
    if (name == "set_shape") return SetShape{of, part(), std::exchange(refits_, false)};
    if (name == "set_user_data") return SetUserData{of, lines_.hex("user data")};
    if (name == "set_filter") {
        const std::uint64_t groups = lines_.hex("groups");
        return SetFilter{of, {.groups = groups, .mask = lines_.hex("a mask")}};
    }
    if (name == "set_pair_enabled") {
        const Label other = body();
        return SetPairEnabled{of, other, lines_.decimal("0 or 1", 1) == 1};
    }
    lines_.fail("there is no such call");
}

SetPoses Reader::read_poses() {
    SetPoses call;
    const std::uint64_t count = lines_.decimal("a number of poses", max_64);
    for (std::uint64_t i = 0; i < count; ++i) {
        lines_.require_next("p");
        call.bodies.push_back(body());
        call.poses.push_back(lines_.pose());
    }
    return call;
}

Label Reader::body() {
    const auto found = labels_.find(lines_.body());
    if (found == labels_.end()) lines_.fail("there is no such body");
    return found->second;
}

const Part& Reader::part() {
    const auto found = parts_.find(lines_.decimal("a mesh or shape", max_64));
    if (found == parts_.end()) lines_.fail("there is no such mesh or shape");
    return found->second;
}

}  // namespace

Script read_trace(std::istream& in) {
    return Reader(in).read();
}

}  // namespace ecods::fuzz
