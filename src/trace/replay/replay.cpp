#include "ecods/replay.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "trace/trace_lines.hpp"
#include "trace/trace_text.hpp"

namespace ecods {
namespace {

constexpr std::uint64_t max_32 = ~std::uint32_t{0};
constexpr std::uint64_t max_64 = ~std::uint64_t{0};

using Pairs = std::vector<BodyPair>;

bool is_difference(std::span<const BodyPair> difference, const Pairs& of, const Pairs& without) {
    Pairs expected;
    std::ranges::set_difference(of, without, std::back_inserter(expected));
    return std::ranges::equal(difference, expected);
}

std::string hex_text(std::uint64_t number) {
    std::string text;
    append_hex(text, number);
    return text;
}

class Replayer {
  public:
    Replayer(std::istream& in, const ReplayOptions& options) : lines_(in), options_(options), world_(read_head()) {
        if (options_.set_up) options_.set_up(world_);
    }
    ReplayReport run();

  private:
    WorldOptions read_head();
    void run_line();
    void run_call(std::string_view name);

    void read_mesh();
    void read_shape();
    void create();
    void set_poses();
    void set_pair_enabled();
    void update();
    void compare_events(const Pairs& before, const Pairs& after);

    const std::shared_ptr<const Shape>& shape();
    BodyId body();
    void differ(std::string what);

    TraceLines lines_;
    const ReplayOptions& options_;
    bool ids_must_repeat_ = false;  // before world_, whose options set it
    World world_;
    std::map<std::uint64_t, std::shared_ptr<const Shape>> shapes_;  // by number
    std::map<BodyId, BodyId> ids_;                                  // of the trace, to those here
    ReplayReport report_;
};

WorldOptions Replayer::read_head() {
    if (!lines_.next() || lines_.rest() != trace_header) {
        throw InvalidTrace(1, "a trace begins with '" + std::string(trace_header) + "'");
    }
    lines_.require_next("world");
    const auto kind = parse_broad_phase(lines_.word("a broad phase"));
    if (!kind) lines_.fail("there is no such broad phase");
    ids_must_repeat_ = lines_.decimal("a number of bodies", max_64) == 0;
    lines_.require_end();
    return {.broad_phase = options_.broad_phase.value_or(*kind), .executor = options_.executor};
}

ReplayReport Replayer::run() {
    while (!report_.difference && lines_.next()) {
        try {
            run_line();
        } catch (const InvalidTrace&) {
            throw;
        } catch (const NotSupported&) {
            throw;
        } catch (const ExecutorFailed&) {
            throw;
        } catch (const Error& error) {
            lines_.fail(error.what());
        }
    }
    report_.body_count = ids_.size();
    report_.colliding_count = world_.colliding_pairs().size();
    return std::move(report_);
}

void Replayer::run_line() {
    const std::string_view name = lines_.word("a call");
    if (name == "mesh") {
        read_mesh();
    } else if (name == "shape") {
        read_shape();
    } else if (name == "note") {
        lines_.rest();
    } else {
        run_call(name);
        lines_.require_end();
        ++report_.call_count;
    }
}

void Replayer::run_call(std::string_view name) {
    if (name == "create") return create();
    if (name == "set_poses") return set_poses();
    if (name == "set_pair_enabled") return set_pair_enabled();
    if (name == "update") return update();
    if (name == "destroy") {
        const BodyId traced = lines_.body();
        const auto found = ids_.find(traced);
        if (found == ids_.end()) lines_.fail("there is no such body");
        world_.destroy_body(found->second);
        ids_.erase(found);
    } else if (name == "set_pose") {
        const BodyId moved = body();
        world_.set_pose(moved, lines_.pose());
    } else if (name == "set_shape") {
        const BodyId changed = body();
        world_.set_shape(changed, shape());
    } else if (name == "set_filter") {
        const BodyId filtered = body();
        const std::uint64_t groups = lines_.hex("groups");
        world_.set_filter(filtered, {.groups = groups, .mask = lines_.hex("a mask")});
    } else if (name == "set_user_data") {
        const BodyId named = body();
        world_.set_user_data(named, lines_.hex("user data"));
    } else {
        lines_.fail("there is no such call");
    }
}

// ---- what bodies are made of. Nothing is reserved for what is announced: only what is there takes memory.

void Replayer::read_mesh() {
    const std::uint64_t number = lines_.decimal("a number", max_64);
    const std::uint64_t vertex_count = lines_.decimal("a number of vertices", max_32);
    const std::uint64_t triangle_count = lines_.decimal("a number of triangles", max_32);
    lines_.require_end();
    std::vector<Vec3> vertices;
    for (std::uint64_t i = 0; i < vertex_count; ++i) {
        lines_.require_next("v");
        vertices.push_back(lines_.point());
        lines_.require_end();
    }
    std::vector<Triangle> triangles;
    for (std::uint64_t i = 0; i < triangle_count; ++i) {
        lines_.require_next("t");
        Triangle triangle;
        for (std::uint32_t& vertex : triangle) vertex = static_cast<std::uint32_t>(lines_.decimal("a vertex", max_32));
        triangles.push_back(triangle);
        lines_.require_end();
    }
    auto mesh = std::make_shared<const MeshShape>(Mesh::create(std::move(vertices), std::move(triangles)));
    if (!shapes_.emplace(number, std::move(mesh)).second) lines_.fail("the number of this mesh is taken");
}

void Replayer::read_shape() {
    const std::uint64_t number = lines_.decimal("a number", max_64);
    const ShapeKind kind{static_cast<std::uint32_t>(lines_.decimal("a kind", max_32))};
    if (!options_.read_shape) {
        throw NotSupported("line " + std::to_string(lines_.number()) + ": a shape of kind " +
                           std::to_string(kind.value) + " cannot be read: ReplayOptions::read_shape is not set");
    }
    auto shape = options_.read_shape(kind, lines_.rest());
    if (!shape || shape->kind() != kind) lines_.fail("ReplayOptions::read_shape gave no shape of this kind");
    if (!shapes_.emplace(number, std::move(shape)).second) lines_.fail("the number of this shape is taken");
}

const std::shared_ptr<const Shape>& Replayer::shape() {
    const auto found = shapes_.find(lines_.decimal("a mesh or shape", max_64));
    if (found == shapes_.end()) lines_.fail("there is no such mesh or shape");
    return found->second;
}

// ---- calls

BodyId Replayer::body() {
    const auto found = ids_.find(lines_.body());
    if (found == ids_.end()) lines_.fail("there is no such body");
    return found->second;
}

void Replayer::create() {
    const BodyId traced = lines_.body();
    if (ids_.contains(traced)) lines_.fail("this body is here already");
    const auto& of = shape();
    const BodyId made = world_.create_body(of, lines_.pose());
    ids_.emplace(traced, made);
    if (ids_must_repeat_ && made != traced) {
        std::string text = "the new body is ";
        append(text, made);
        differ(text);
    }
}

void Replayer::set_poses() {
    const std::uint64_t count = lines_.decimal("a number of poses", max_64);
    lines_.require_end();
    std::vector<BodyId> bodies;
    std::vector<Pose> poses;
    for (std::uint64_t i = 0; i < count; ++i) {
        lines_.require_next("p");
        bodies.push_back(body());
        poses.push_back(lines_.pose());
        lines_.require_end();
    }
    world_.set_poses(bodies, poses);
}

void Replayer::set_pair_enabled() {
    const BodyId a = body();
    const BodyId b = body();
    if (a == b) lines_.fail("a pair is two bodies");
    world_.set_pair_enabled(a, b, lines_.decimal("0 or 1", 1) == 1);
}

void Replayer::update() {
    std::optional<std::pair<std::uint64_t, std::uint64_t>> expected;
    if (!lines_.at_end()) {
        if (lines_.rest_is("failed")) {
            lines_.rest();
        } else {
            const std::uint64_t digest = lines_.hex("a digest");
            expected.emplace(digest, lines_.decimal("a number of pairs", max_64));
        }
    }
    lines_.require_end();
    const Pairs before(world_.colliding_pairs().begin(), world_.colliding_pairs().end());
    world_.update();
    const Pairs after(world_.colliding_pairs().begin(), world_.colliding_pairs().end());
    if (expected && world_.digest() != expected->first) {
        differ("the digest is " + hex_text(world_.digest()) + " and was " + hex_text(expected->first) + "; " +
               std::to_string(after.size()) + " pairs collide and " + std::to_string(expected->second) + " did");
    } else if (expected && after.size() != expected->second) {
        differ(std::to_string(after.size()) + " pairs collide and " + std::to_string(expected->second) + " did");
    }
    compare_events(before, after);
    if (options_.validates) {
        try {
            world_.validate();
        } catch (const Error& error) {
            differ(error.what());
        }
    }
    if (!report_.difference) ++report_.update_count;
}

void Replayer::compare_events(const Pairs& before, const Pairs& after) {
    if (!is_difference(world_.began(), after, before)) differ("the pairs that began are not those that are new");
    if (!is_difference(world_.ended(), before, after)) differ("the pairs that ended are not those that are gone");
}

void Replayer::differ(std::string what) {
    if (report_.difference) return;
    report_.difference = {
        .update = report_.update_count, .call = report_.call_count, .line = lines_.number(), .what = std::move(what)};
}

}  // namespace

ReplayReport replay(std::istream& trace, const ReplayOptions& options) {
    return Replayer(trace, options).run();
}

}  // namespace ecods
