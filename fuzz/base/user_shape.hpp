// Shapes of the caller's own, for the fuzzer: meshes in disguise, so that the oracle knows them.
#pragma once

#include <atomic>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ecods/world.hpp"

namespace ecods::fuzz {

inline constexpr ShapeKind first_user_kind{3};
inline constexpr ShapeKind second_user_kind{7};
inline constexpr ShapeKind kind_without_tests{9};

// Immutable, but for what must never happen: a change that nobody reports. Then its digest is another, or its box.
class UserShape final : public Shape {
  public:
    enum class Tampering : int { none, digest, box };

    UserShape(std::shared_ptr<const Mesh> mesh, ShapeKind kind) : mesh_(std::move(mesh)), kind_(kind) {}

    ShapeKind kind() const noexcept override { return kind_; }
    Aabb box(const Pose& pose) const override;
    std::uint64_t digest() const noexcept override;
    bool answers(Question question) const noexcept override { return question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& segment, const Pose& pose, const Ask& ask) const override;
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const override;

    const std::shared_ptr<const Mesh>& mesh() const noexcept { return mesh_.mesh_ptr(); }
    const MeshShape& as_mesh_shape() const noexcept { return mesh_; }
    void tamper(Tampering how) const noexcept { tampering_ = how; }

  private:
    MeshShape mesh_;
    ShapeKind kind_;
    mutable std::atomic<Tampering> tampering_ = Tampering::none;
};

// The mesh that a shape is, disguised or not; of a rounded shape that of its core.
std::shared_ptr<const Mesh> mesh_of(const Shape& shape);

// The tests for the user-defined kinds, with meshes and with one another, to be registered with a world. They insist on
// the order of kinds that they were registered with. Those of the second kind give no triangles.
class UserTests {
  public:
    void add_to(World& world) const;

    // From now on, or no more, every test throws TestFailed.
    void fail(bool is_failing) const noexcept { *is_failing_ = is_failing; }

  private:
    std::shared_ptr<std::atomic<bool>> is_failing_ = std::make_shared<std::atomic<bool>>(false);
};

class TestFailed : public std::runtime_error {
  public:
    TestFailed() : std::runtime_error("a test failed on purpose") {}
};

// As a trace has them: one line, and back. Reading throws Error where the text is something else.
std::string write_user_shape(const Shape& shape);
std::shared_ptr<const Mesh> read_user_mesh(std::string_view text);

}  // namespace ecods::fuzz
