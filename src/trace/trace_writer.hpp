// Writes the calls, updates and questions of a world to a trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "ecods/broad_phase.hpp"
#include "ecods/pose.hpp"
#include "ecods/world_options.hpp"
#include "trace/mesh_form.hpp"
#include "trace/questions.hpp"
#include "trace/trace_text.hpp"

namespace ecods {

// A TraceWriter writes a trace to a stream. A call is written after it has succeeded, so writing must not throw: if
// writing fails, the writer stops and has_failed() becomes true. Text is written unformatted: flags, width and locale
// of the stream have no effect.
class TraceWriter {
  public:
    TraceWriter(std::ostream& out, TraceOptions options);

    // Returns the number of a shape in the trace. If the trace does not have the shape yet, first writes the shape, so
    // that it precedes the call that uses it. Throws NotSupported if the shape cannot be written.
    std::uint64_t number_of(const std::shared_ptr<const Shape>& shape);

    void begin(BroadPhaseKind kind, std::size_t slot_count) noexcept;

    // Returns true if the trace includes questions.
    bool writes_questions() const noexcept { return options_.questions; }

    // Writes a call or a question, given by its row in calls.hpp or questions.hpp: write<calls::SetPose>(body, pose).
    template <template <class> class Row, class... Arguments>
    void write(const Arguments&... arguments) noexcept {
        guarded([&] {
            const Row<calls::Tracing> call{arguments...};  // a motion has a copy of its nodes
            append_words(text_, call.name);
            call.fields(FieldWriter{*this}, call);
            end_line();
        });
    }
    void note(std::string_view text) noexcept;

    // Writes and flushes the word `update`. Call it before an update runs, so that the file is complete up to this word
    // even if the program crashes in the update.
    void begin_update() noexcept;
    void end_update(std::uint64_t digest, std::size_t colliding_count) noexcept;
    void end_failed_update() noexcept;

    void flush() noexcept;
    bool has_failed() const noexcept { return has_failed_; }

  private:
    // A FieldWriter writes the fields of a call or a question. The rows of calls.hpp and questions.hpp pass their
    // fields to the FieldWriter.
    struct FieldWriter {
        TraceWriter& writer;

        void created(BodyId body) const { put(body); }
        void destroyed(BodyId body) const { put(body); }
        void body(BodyId body) const { put(body); }
        void other_body(BodyId body) const { put(body); }
        void shape(std::uint64_t number) const { put(number); }
        void pose(const Pose& pose) const { put(pose); }
        void posed_bodies(std::span<const BodyId> bodies, std::span<const Pose> poses) const;
        void filter(const CollisionFilter& filter) const { put(filter); }
        void flag(bool flag) const { put(std::uint64_t{flag}); }
        void data(std::uint64_t data) const { put(Hex{data}); }
        void clearance(const std::optional<double>& clearance) const { put(clearance); }
        void answer(std::uint64_t digest) const { put(Hex{digest}); }
        void line(const Segment& segment) const { put(segment.a, segment.b); }
        void line(const Ray& ray) const { put(ray.origin, ray.direction, ray.max_parameter); }
        void motion(const Vec3& motion) const { put(motion); }
        void motion(const Motion& motion) const;
        void moved_bodies(std::span<const BodyId> bodies, std::span<const Pose> poses) const {
            posed_bodies(bodies, poses);
        }
        void moved_bodies(std::span<const BodyId> bodies, std::span<const Motion> motions) const;
        void point(const Vec3& point) const { put(point); }
        void number(double number) const { put(number); }
        void optional_filter(const std::optional<CollisionFilter>& filter) const { put(filter); }
        void groups(std::uint64_t groups) const { put(Hex{groups}); }

        template <class... Words>
        void put(const Words&... words) const {
            append_words(writer.text_, words...);
        }
    };

    // Calls `act`, unless writing failed before. An exception that `act` throws counts as a failure.
    template <class Act>
    void guarded(Act act) noexcept {
        if (has_failed_) return;
        try {
            text_.clear();
            act();
            has_failed_ = !out_->good();
        } catch (...) {
            has_failed_ = true;
        }
    }
    template <class... Words>
    void put_line(const Words&... words) noexcept {
        guarded([&] {
            append_words(text_, words...);
            end_line();
        });
    }
    void end_line();  // also writes the line to the stream
    void put_text();
    void put_mesh(MeshForm form, const Mesh& mesh, std::uint64_t number) noexcept;
    std::string text_of(const Shape& shape) const;

    // A Numbered is a mesh or shape that has a number. numbers_ finds it by its address. Another object may have the
    // same address once this one is destroyed; the weak pointer distinguishes the two.
    struct Numbered {
        std::weak_ptr<const void> object;
        std::uint64_t number = 0;
    };
    std::ostream* out_;
    TraceOptions options_;
    std::unordered_map<const void*, Numbered> numbers_;
    std::size_t numbers_max_ = 64;  // number of entries at which entries of destroyed objects are removed
    std::uint64_t last_number_ = 0;
    std::string text_;  // text of the line being written
    bool has_failed_ = false;
};

}  // namespace ecods
