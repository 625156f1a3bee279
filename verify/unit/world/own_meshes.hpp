// Meshes of a kind of the caller's own, and the test of two of them.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "ecods/cast.hpp"
#include "ecods/intersection.hpp"
#include "ecods/shape.hpp"
#include "ecods/turn.hpp"

namespace ecods {

inline constexpr ShapeKind own_kind{9};

// A mesh of a kind of the caller's own, and the test of two such, or of a mesh that comes second.
class OwnShape final : public Shape {
  public:
    explicit OwnShape(std::shared_ptr<const Mesh> mesh) : mesh_(std::move(mesh)) {}
    ShapeKind kind() const noexcept override { return own_kind; }
    Aabb box(const Pose& pose) const override { return mesh_.box(pose); }
    std::uint64_t digest() const noexcept override { return mesh_.digest() + 1; }
    const MeshShape& as_mesh() const { return mesh_; }

  private:
    MeshShape mesh_;
};

inline Posed<MeshShape> mesh_at(const Posed<Shape>& posed) {
    const auto* const own = dynamic_cast<const OwnShape*>(posed.what);
    return {own != nullptr ? own->as_mesh() : dynamic_cast<const MeshShape&>(*posed.what), posed.pose};
}

class OwnTest final : public TwoBodyTest {
  public:
    explicit OwnTest(bool answers_any_motion) : answers_any_motion_(answers_any_motion) {}
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return ecods::intersects(mesh_at(a), mesh_at(b), ask);
    }
    bool answers(Question question) const noexcept override {
        return question == Question::cast_moving || question == Question::cast ||
               (question == Question::cast_any_motion && answers_any_motion_);
    }
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& motion, const Posed<Shape>& b, double max_time,
                                     const Ask& ask) const override {
        return ecods::cast(mesh_at(a), motion, mesh_at(b), max_time, ask);
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        const auto moving = [](const Moving<Shape>& body) {
            return Moving<MeshShape>(*mesh_at({*body.what, body.from}).what, body.from, body.to);
        };
        return ecods::cast(moving(a), moving(b), max_time, ask);
    }
    std::optional<FirstContact> cast_any_motion(const Posed<Shape>& a, const Motion& motion_of_a, const Posed<Shape>& b,
                                                const Motion& motion_of_b, double max_time,
                                                const Ask& ask) const override {
        if (a.what->kind() != own_kind) throw std::logic_error("the kinds are in the wrong order");
        return ecods::cast(mesh_at(a), motion_of_a, mesh_at(b), motion_of_b, max_time, ask);
    }

  private:
    bool answers_any_motion_;
};

}  // namespace ecods
