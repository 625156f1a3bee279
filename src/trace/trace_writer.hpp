// The writing end of a trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>

#include "ecods/broad_phase.hpp"
#include "ecods/collision_filter.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/trace.hpp"

namespace ecods {

// Calls are written after they succeeded, so writing them must not throw: a failure ends the writing, and is told by
// has_failed().
class TraceWriter {
  public:
    TraceWriter(std::ostream& out, TraceOptions options);

    // The number of a mesh or shape, whose text is written if it has not been yet: before the call that brings it in.
    // Throws NotSupported.
    std::uint64_t number_of(const std::shared_ptr<const Shape>& shape);

    void begin(BroadPhaseKind kind, std::size_t slot_count) noexcept;
    void create(BodyId body, std::uint64_t number, const Pose& pose) noexcept;
    void destroy(BodyId body) noexcept;
    void set_pose(BodyId body, const Pose& pose) noexcept;
    void set_poses(std::span<const BodyId> bodies, std::span<const Pose> poses) noexcept;
    void set_shape(BodyId body, std::uint64_t number) noexcept;
    void set_filter(BodyId body, const CollisionFilter& filter) noexcept;
    void set_pair_enabled(BodyId a, BodyId b, bool is_enabled) noexcept;
    void set_user_data(BodyId body, std::uint64_t data) noexcept;
    void note(std::string_view text) noexcept;

    // An update is announced before it runs: the file is complete up to there, should the program not be there after.
    void begin_update() noexcept;
    void end_update(std::uint64_t digest, std::size_t colliding_count) noexcept;
    void end_failed_update() noexcept;

    void flush() noexcept;
    bool has_failed() const noexcept { return has_failed_; }

  private:
    template <class Act>
    void guarded(Act act) noexcept;
    template <class... Words>
    void put_line(const Words&... words) noexcept;
    void put_mesh(const Mesh& mesh, std::uint64_t number) noexcept;
    std::string text_of(const Shape& shape) const;

    // What has a number, by its address; which may be used again once what was there is gone.
    struct Numbered {
        std::weak_ptr<const void> what;
        std::uint64_t number = 0;
    };
    std::ostream* out_;
    TraceOptions options_;
    std::unordered_map<const void*, Numbered> numbers_;
    std::size_t numbers_max_ = 64;  // when that many are known, forget what is gone
    std::uint64_t last_number_ = 0;
    std::string text_;  // working memory
    bool has_failed_ = false;
};

}  // namespace ecods
