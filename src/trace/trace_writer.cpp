#include "trace/trace_writer.hpp"

#include <utility>

#include "ecods/error.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "trace/trace_text.hpp"

namespace ecods {

TraceWriter::TraceWriter(std::ostream& out, TraceOptions options) : out_(&out), options_(std::move(options)) {}

void TraceWriter::put_text() {
    write_text(*out_, text_);
    text_.clear();
}

void TraceWriter::end_line() {
    ecods::end_line(text_);
    put_text();
}

// Writes the line of each item to the stream as soon as it is complete, so that a long list takes no memory.
void TraceWriter::FieldWriter::posed_bodies(std::span<const BodyId> bodies, std::span<const Pose> poses) const {
    put(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        writer.end_line();
        put("p", bodies[i], poses[i]);
    }
}

void TraceWriter::FieldWriter::moved_bodies(std::span<const BodyId> bodies, std::span<const Motion> motions) const {
    put(bodies.size());
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        writer.end_line();
        put("m", bodies[i]);
        motion(motions[i]);
    }
}

void TraceWriter::FieldWriter::motion(const Motion& motion) const {
    if (const auto* const translation = std::get_if<Translation>(&motion)) return put("translated", translation->by);
    if (const auto* const straight = std::get_if<Straight>(&motion)) return put("straight", straight->to);
    if (const auto* const along = std::get_if<Along>(&motion)) {
        put("along", along->nodes.size());
        for (const auto& [q, pivot] : along->nodes) put(q.w, q.x, q.y, q.z, pivot);
        return;
    }
    const auto& [q, from, to] = std::get<Turn>(motion);
    put("turned", q.w, q.x, q.y, q.z, from, to);
}

void TraceWriter::begin(BroadPhaseKind kind, std::size_t slot_count) noexcept {
    put_line(trace_header);
    put_line("world", name_of(kind), slot_count);
}

void TraceWriter::note(std::string_view text) noexcept {
    put_line("note", text);
}

void TraceWriter::begin_update() noexcept {
    guarded([&] {
        append(text_, "update");
        put_text();
        out_->flush();
    });
}

void TraceWriter::end_update(std::uint64_t digest, std::size_t colliding_count) noexcept {
    put_line("", Hex{digest}, colliding_count);
}

void TraceWriter::end_failed_update() noexcept {
    put_line("", "failed");
}

void TraceWriter::flush() noexcept {
    guarded([&] { out_->flush(); });
}

std::uint64_t TraceWriter::number_of(const std::shared_ptr<const Shape>& shape) {
    const auto* mesh_shape = dynamic_cast<const MeshShape*>(shape.get());
    const MeshForm form = mesh_shape != nullptr ? mesh_shape->form() : MeshForm::surface;
    const std::shared_ptr<const void> object = mesh_shape != nullptr && form == MeshForm::surface
                                                   ? std::shared_ptr<const void>(mesh_shape->mesh_ptr())
                                                   : shape;
    if (numbers_.size() >= numbers_max_) {
        std::erase_if(numbers_, [](const auto& entry) { return entry.second.object.expired(); });
        numbers_max_ = 2 * numbers_.size() + 64;
    }
    const auto known = numbers_.find(object.get());
    if (known != numbers_.end() && known->second.object.lock() == object) return known->second.number;

    const auto* half_space = dynamic_cast<const HalfSpace*>(shape.get());
    const auto* rounded = dynamic_cast<const Rounded*>(shape.get());
    const std::uint64_t core = rounded != nullptr ? number_of(rounded->core_ptr()) : 0;
    const bool is_own = mesh_shape != nullptr || half_space != nullptr || rounded != nullptr;
    const std::string text = is_own ? std::string() : text_of(*shape);
    const std::uint64_t number = last_number_ + 1;
    numbers_[object.get()] = {object, number};
    last_number_ = number;
    if (mesh_shape != nullptr) {
        put_mesh(form, mesh_shape->mesh(), number);
    } else if (half_space != nullptr) {
        put_line("half_space", number, half_space->normal(), half_space->offset());
    } else if (rounded != nullptr) {
        put_line("rounded", number, core, rounded->radius());
    } else {
        put_line("shape", number, shape->kind().value, std::string_view(text));
    }
    return number;
}

void TraceWriter::put_mesh(MeshForm form, const Mesh& mesh, std::uint64_t number) noexcept {
    put_line(mesh_form_names[static_cast<std::size_t>(form)], number, mesh.vertices().size(), mesh.triangles().size());
    for (const Vec3& v : mesh.vertices()) put_line("v", v);
    for (const Triangle& t : mesh.triangles()) put_line("t", t[0], t[1], t[2]);
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
