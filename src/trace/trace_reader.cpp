#include "trace/trace_reader.hpp"

#include <utility>

#include "ecods/error.hpp"

namespace ecods {
namespace {

constexpr std::uint64_t max_32 = ~std::uint32_t{0};
constexpr std::uint64_t max_64 = ~std::uint64_t{0};

}  // namespace

// The functions of FieldReader read fields. They reserve no memory for a count that the text announces: only items that
// are present take memory.

decltype(TracedNames::bodies)::iterator FieldReader::known_body() {
    const auto found = names_.bodies.find(lines_.body());
    if (found == names_.bodies.end()) lines_.fail("there is no such body");
    return found;
}

void FieldReader::created(calls::Label& body) {
    body = names_.created.size();
    const TracedBody name = lines_.body();
    if (!names_.bodies.emplace(name, body).second) lines_.fail("this body is here already");
    names_.created.push_back(name);
}

void FieldReader::destroyed(calls::Label& body) {
    const auto found = known_body();
    body = found->second;
    names_.bodies.erase(found);
}

void FieldReader::other_body(calls::Label& body) {
    body = known_body()->second;
    if (body == last_body_) lines_.fail("a pair is two bodies");
}

void FieldReader::shape(std::size_t& shape) {
    const auto found = names_.shapes.find(lines_.decimal("a mesh or shape", max_64));
    if (found == names_.shapes.end()) lines_.fail("there is no such mesh or shape");
    shape = found->second;
}

void FieldReader::line(Segment& segment) {
    segment.a = lines_.point();
    segment.b = lines_.point();
}

void FieldReader::line(Ray& ray) {
    ray.origin = lines_.point();
    ray.direction = lines_.point();
    ray.max_parameter = lines_.number();
}

void FieldReader::posed_bodies(std::vector<calls::Label>& bodies, std::vector<Pose>& poses) {
    const std::uint64_t count = lines_.decimal("a number of poses", max_64);
    lines_.require_end();
    for (std::uint64_t i = 0; i < count; ++i) {
        lines_.require_next("p");
        bodies.push_back(known_body()->second);
        poses.push_back(lines_.pose());
        lines_.require_end();
    }
}

Quaternion FieldReader::quaternion() {
    Quaternion q;
    for (double* const part : {&q.w, &q.x, &q.y, &q.z}) *part = lines_.coordinate();
    return q;
}

void FieldReader::motion(Motion& motion) {
    const std::string_view name = lines_.word("a motion");
    if (name == "translated") {
        motion = Translation{lines_.point()};
    } else if (name == "straight") {
        motion = Straight{lines_.pose()};
    } else if (name == "turned") {
        Turn turn;
        turn.q = quaternion();
        turn.pivot_from = lines_.point();
        turn.pivot_to = lines_.point();
        motion = turn;
    } else if (name == "along") {
        Along along;
        for (std::uint64_t left = lines_.decimal("a number of nodes", max_64); left > 0; --left) {
            const Quaternion q = quaternion();
            along.nodes.push_back({q, lines_.point()});
        }
        motion = std::move(along);
    } else {
        lines_.fail("there is no such motion");
    }
}

void FieldReader::moved_bodies(std::vector<calls::Label>& bodies, std::vector<Motion>& motions) {
    const std::uint64_t count = lines_.decimal("a number of motions", max_64);
    lines_.require_end();
    for (std::uint64_t i = 0; i < count; ++i) {
        lines_.require_next("m");
        bodies.push_back(known_body()->second);
        motion(motions.emplace_back());
        lines_.require_end();
    }
}

// The functions of TraceReader read the lines of a trace.

TraceReader::TraceReader(std::istream& in) : lines_(in) {
    const std::string_view header = lines_.next_header();
    is_of_version_1_ = header == old_trace_header;
    if (header != trace_header && !is_of_version_1_) {
        throw InvalidTrace(1, "a trace begins with '" + std::string(trace_header) + "'");
    }
    lines_.require_next("world");
    const auto kind = parse_broad_phase(lines_.word("a broad phase"));
    if (!kind) lines_.fail("there is no such broad phase");
    broad_phase_ = *kind;
    begins_empty_ = lines_.decimal("a number of bodies", max_64) == 0;
    lines_.require_end();
}

std::optional<TraceItem> TraceReader::next() {
    if (!lines_.next()) return std::nullopt;
    try {
        TraceItem item = read_item();
        lines_.require_end();
        return item;
    } catch (const InvalidTrace&) {
        throw;
    } catch (const Error& error) {
        lines_.fail(error.what());
    }
}

TraceItem TraceReader::read_item() {
    const std::string_view name = lines_.word("a call");
    if (name == "note") return TracedNote{std::string(lines_.rest())};
    if (name == "update") return read_update();
    if (const auto form = parse_mesh_form(name)) return read_mesh(*form);
    if (name == "half_space") return read_half_space();
    if (name == "shape") return read_shape();
    if (name == "rounded") return read_rounded();
    const auto read_fields = [&](auto& row) { row.fields(FieldReader(lines_, names_), row); };
    if (TracedQuestion question; calls::emplace_row(question, name)) {
        std::visit(read_fields, question);
        return question;
    }
    TracedCall call;
    using SetRelations = calls::SetRelations<calls::InOrder>;
    const bool is_old_name = is_of_version_1_ && name == SetRelations::old_name;
    if (!calls::emplace_row(call, is_old_name ? SetRelations::name : name)) lines_.fail("there is no such call");
    std::visit(read_fields, call);
    return call;
}

TracedUpdate TraceReader::read_update() {
    TracedUpdate update;
    if (lines_.rest_is("failed")) {
        lines_.rest();
        update.has_failed = true;
    } else if (!lines_.at_end()) {
        const std::uint64_t digest = lines_.hex("a digest");
        update.result = {digest, lines_.decimal("a number of pairs", max_64)};
    }
    return update;
}

TracedMesh TraceReader::read_mesh(MeshForm form) {
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
    auto mesh = Mesh::create(std::move(vertices), std::move(triangles));
    number_next_shape(number, "mesh");
    return {std::move(mesh), form};
}

TracedHalfSpace TraceReader::read_half_space() {
    const std::uint64_t number = lines_.decimal("a number", max_64);
    const Vec3 normal = lines_.point();
    const double offset = lines_.coordinate();
    number_next_shape(number, "half space");
    return {normal, offset};
}

TracedShape TraceReader::read_shape() {
    const std::uint64_t number = lines_.decimal("a number", max_64);
    const ShapeKind kind{static_cast<std::uint32_t>(lines_.decimal("a kind", max_32))};
    std::string text(lines_.rest());
    number_next_shape(number, "shape");
    return {kind, std::move(text)};
}

TracedRounded TraceReader::read_rounded() {
    const std::uint64_t number = lines_.decimal("a number", max_64);
    TracedRounded rounded;
    FieldReader(lines_, names_).shape(rounded.core);
    rounded.radius = lines_.number();
    number_next_shape(number, "rounded shape");
    return rounded;
}

void TraceReader::number_next_shape(std::uint64_t number, const char* kind) {
    if (!names_.shapes.emplace(number, names_.shapes.size()).second) {
        lines_.fail(std::string("the number of this ") + kind + " is taken");
    }
}

}  // namespace ecods
