#include "trace/trace_writer.hpp"

#include <utility>

#include "ecods/error.hpp"
#include "trace/trace_text.hpp"

namespace ecods {
namespace {

void append(std::string& text, std::string_view word) {
    text.append(word);
}

struct Hex {
    std::uint64_t value;
};

void append(std::string& text, Hex hex) {
    append_hex(text, hex.value);
}

}  // namespace

TraceWriter::TraceWriter(std::ostream& out, TraceOptions options) : out_(&out), options_(std::move(options)) {}

template <class Act>
void TraceWriter::guarded(Act act) noexcept {
    if (has_failed_) return;
    try {
        act();
        has_failed_ |= !out_->good();  // which a call within this one may have set, though the stream is good
    } catch (...) {
        has_failed_ = true;
    }
}

template <class... Words>
void TraceWriter::put_line(const Words&... words) noexcept {
    guarded([&] {
        text_.clear();
        ((append(text_, words), text_.push_back(' ')), ...);
        text_.back() = '\n';
        out_->write(text_.data(), static_cast<std::streamsize>(text_.size()));
    });
}

void TraceWriter::begin(BroadPhaseKind kind, std::size_t slot_count) noexcept {
    put_line(trace_header);
    guarded([&] { put_line(std::string_view("world"), std::string_view(name_of(kind)), slot_count); });
}

void TraceWriter::create(BodyId body, std::uint64_t number, const Pose& pose) noexcept {
    put_line(std::string_view("create"), body, number, pose);
}

void TraceWriter::destroy(BodyId body) noexcept {
    put_line(std::string_view("destroy"), body);
}

void TraceWriter::set_pose(BodyId body, const Pose& pose) noexcept {
    put_line(std::string_view("set_pose"), body, pose);
}

void TraceWriter::set_poses(std::span<const BodyId> bodies, std::span<const Pose> poses) noexcept {
    put_line(std::string_view("set_poses"), bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) put_line(std::string_view("p"), bodies[i], poses[i]);
}

void TraceWriter::set_shape(BodyId body, std::uint64_t number) noexcept {
    put_line(std::string_view("set_shape"), body, number);
}

void TraceWriter::set_filter(BodyId body, const CollisionFilter& filter) noexcept {
    put_line(std::string_view("set_filter"), body, Hex{filter.groups}, Hex{filter.mask});
}

void TraceWriter::set_pair_enabled(BodyId a, BodyId b, bool is_enabled) noexcept {
    put_line(std::string_view("set_pair_enabled"), a, b, std::uint64_t{is_enabled});
}

void TraceWriter::set_user_data(BodyId body, std::uint64_t data) noexcept {
    put_line(std::string_view("set_user_data"), body, Hex{data});
}

void TraceWriter::note(std::string_view text) noexcept {
    put_line(std::string_view("note"), text);
}

void TraceWriter::begin_update() noexcept {
    guarded([&] { *out_ << "update" << std::flush; });
}

void TraceWriter::end_update(std::uint64_t digest, std::size_t colliding_count) noexcept {
    put_line(std::string_view(), Hex{digest}, colliding_count);
}

void TraceWriter::end_failed_update() noexcept {
    put_line(std::string_view(), std::string_view("failed"));
}

void TraceWriter::flush() noexcept {
    guarded([&] { out_->flush(); });
}

std::uint64_t TraceWriter::number_of(const std::shared_ptr<const Shape>& shape) {
    const auto* mesh_shape = dynamic_cast<const MeshShape*>(shape.get());
    const std::shared_ptr<const void> what =
        mesh_shape != nullptr ? std::shared_ptr<const void>(mesh_shape->mesh_ptr()) : shape;
    if (numbers_.size() >= numbers_max_) {
        std::erase_if(numbers_, [](const auto& entry) { return entry.second.what.expired(); });
        numbers_max_ = 2 * numbers_.size() + 64;
    }
    const auto known = numbers_.find(what.get());
    if (known != numbers_.end() && known->second.what.lock() == what) return known->second.number;

    const std::string text = mesh_shape != nullptr ? std::string() : text_of(*shape);
    const std::uint64_t number = last_number_ + 1;
    numbers_[what.get()] = {what, number};
    last_number_ = number;
    if (mesh_shape != nullptr) {
        put_mesh(mesh_shape->mesh(), number);
    } else {
        put_line(std::string_view("shape"), number, std::uint64_t{shape->kind().value}, std::string_view(text));
    }
    return number;
}

void TraceWriter::put_mesh(const Mesh& mesh, std::uint64_t number) noexcept {
    put_line(std::string_view("mesh"), number, mesh.vertices().size(), mesh.triangles().size());
    for (const Vec3& v : mesh.vertices()) put_line(std::string_view("v"), v);
    for (const Triangle& t : mesh.triangles()) {
        put_line(std::string_view("t"), std::uint64_t{t[0]}, std::uint64_t{t[1]}, std::uint64_t{t[2]});
    }
}

std::string TraceWriter::text_of(const Shape& shape) const {
    const std::string kind = "shape of kind " + std::to_string(shape.kind().value);
    if (!options_.write_shape) throw NotSupported(kind + " cannot be traced: TraceOptions::write_shape is not set");
    std::string text = options_.write_shape(shape);
    if (text.find_first_of("\r\n") != std::string::npos) {
        throw NotSupported(kind + " cannot be traced: its text is more than a line");
    }
    return text;
}

}  // namespace ecods
