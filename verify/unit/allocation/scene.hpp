// A small scene in which everything is there that a call may meet: bodies that collide, of meshes and of another kind,
// slots that are free, filters, pairs that are switched off, and changes that no update has seen.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

#include "allocation/each_allocation.hpp"
#include "allocation/world_state.hpp"
#include "ecods/world.hpp"
#include "scenes/pose_at.hpp"

namespace ecods::allocation {

inline constexpr ShapeKind ball_kind{5};

// Of the caller's own.
class Ball final : public Shape {
  public:
    explicit Ball(double radius) : radius_(radius) {}
    ShapeKind kind() const noexcept override { return ball_kind; }
    Aabb box(const Pose& pose) const override {
        return {.min = pose.t - Vec3::Constant(radius_), .max = pose.t + Vec3::Constant(radius_)};
    }
    std::uint64_t digest() const noexcept override { return static_cast<std::uint64_t>(radius_ * 1024); }

    // Every segment meets its center, half-way.
    bool answers(Question question) const noexcept override { return question == Question::hits; }
    std::vector<Hit> all_hits(const Segment& /*segment*/, const Pose& pose, const Ask& /*ask*/) const override {
        Hit hit;
        hit.parameter = hit.leave_parameter = 0.5;
        hit.point = hit.leave_point = pose.t;
        return {hit};
    }
    std::vector<Hit> all_hits(const Ray& ray, const Pose& pose, const Ask& ask) const override {
        return all_hits(Segment{ray.origin, ray.origin}, pose, ask);
    }

  private:
    double radius_;
};

// Boxes are all that it looks at, and of gaps the largest one.
class BoxTest final : public TwoBodyTest {
  public:
    bool answers(Question question) const noexcept override {
        return question == Question::relation || question == Question::within || question == Question::distance ||
               question == Question::cast || question == Question::cast_moving || question == Question::cast_any_motion;
    }
    // At the start or not at all.
    std::optional<FirstContact> cast(const Posed<Shape>& a, const Vec3& /*motion*/, const Posed<Shape>& b,
                                     double /*max_time*/, const Ask& ask) const override {
        return intersects(a, b, ask) ? std::optional(FirstContact{}) : std::nullopt;
    }
    std::optional<FirstContact> cast_moving(const Moving<Shape>& a, const Moving<Shape>& b, double max_time,
                                            const Ask& ask) const override {
        return cast({*a.what, a.from}, Vec3(0, 0, 0), {*b.what, b.from}, max_time, ask);
    }
    std::optional<FirstContact> cast_any_motion(const Posed<Shape>& a, const Motion&, const Posed<Shape>& b,
                                                const Motion&, double max_time, const Ask& ask) const override {
        return cast(a, Vec3(0, 0, 0), b, max_time, ask);
    }
    double distance(const Posed<Shape>& a, const Posed<Shape>& b, const Ask&) const override {
        const Aabb x = a.what->box(a.pose);
        const Aabb y = b.what->box(b.pose);
        return std::max({0.0, (x.min - y.max).maxCoeff(), (y.min - x.max).maxCoeff()});
    }
    bool within(const Posed<Shape>& a, const Posed<Shape>& b, double d, const Ask& ask) const override {
        return distance(a, b, ask) <= d;
    }
    bool intersects(const Posed<Shape>& a, const Posed<Shape>& b, const Ask&) const override {
        const Aabb x = a.what->box(a.pose);
        const Aabb y = b.what->box(b.pose);
        return (x.min.array() <= y.max.array()).all() && (y.min.array() <= x.max.array()).all();
    }
    Relation relation(const Posed<Shape>& a, const Posed<Shape>& b, const Ask& ask) const override {
        return intersects(a, b, ask) ? Relation::crossing : Relation::apart;
    }
};

inline std::shared_ptr<const Mesh> tetrahedron() {
    return Mesh::create({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)},
                        {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}});
}

// How far a scene has come.
enum class Stage {
    fresh,    // no update yet
    running,  // updates, and changes since the last of them
    ebb,      // most bodies gone since the last update, some new in their slots
    batches,  // bodies came eight at a time, and as many have changed: lists of changes are full
};
inline constexpr Stage stages[] = {Stage::fresh, Stage::running, Stage::ebb, Stage::batches};

struct Scene {
    // A power of two: the next body makes every list grow.
    explicit Scene(const WorldOptions& options, Stage stage, std::size_t body_count = 32, double spacing = 0.45)
        : world(options) {
        ids.reserve(2 * body_count);  // lest this list run out of memory
        world.set_test(ball_kind, ball_kind, std::make_shared<BoxTest>());
        world.set_test(ball_kind, ShapeKind::mesh(), std::make_shared<BoxTest>());
        for (std::size_t i = 0; i < body_count; ++i) {
            const auto x = static_cast<double>(i);
            const Pose pose = at(spacing * x, x / 64, i % 2 == 0 ? 0 : 0.25);
            ids.push_back(i % 6 == 5   ? world.create_body(std::make_shared<Ball>(0.5), pose)
                          : i % 2 == 0 ? world.create_body(solid, pose)
                                       : world.create_body(other_mesh, pose));
            world.set_user_data(ids.back(), i);
            if (stage == Stage::batches && i % 8 == 7) world.update();
        }
        world.set_clearance(0.25);
        world.set_relations(stage == Stage::running);
        world.set_filter(ids[3], {.groups = 2, .mask = 3});
        world.set_filter(ids[4], {.groups = 1, .mask = 1});
        for (const int i : {7, 8, 10}) world.set_pair_enabled(ids[9], ids[i], false);
        if (stage == Stage::fresh) return;
        world.update();
        if (stage == Stage::batches) {
            fill_lists();
            return;
        }
        for (std::size_t i = 1; i < ids.size(); i += 3) move(i, 0.3);
        world.update();
        stage == Stage::running ? run() : ebb();
    }

    // As a program would, with every kind of call.
    void go_on() {
        world.update();
        world.check_invariants();
        world.destroy_body(ids[0]);
        ids.push_back(world.create_body(other_mesh, at(1.5)));
        move(1, 0.4);
        world.set_pair_enabled(ids[1], ids[9], false);
        world.update();
        world.check_invariants();
        world.set_pair_enabled(ids[1], ids[9], true);
        move(9, -0.7);
        world.set_clearance(0.125);
        world.set_relations(false);
        world.update();
        world.check_invariants();
        world.set_clearance({});
        world.set_relations(true);
        world.update();
        world.check_invariants();
    }

    void move(std::size_t body, double step) {
        Pose pose = world.pose(ids[body]);
        pose.t[0] += step;
        world.set_pose(ids[body], pose);
    }

    std::shared_ptr<const Mesh> mesh = tetrahedron();
    std::shared_ptr<const Solid> solid = std::make_shared<const ConvexSolid>(mesh);
    std::shared_ptr<const Mesh> other_mesh =
        Mesh::create({Vec3(0, 0, 0), Vec3(1, 0.5, 0), Vec3(0, 1, 0.5)}, {{0, 1, 2}});
    World world;
    QueryMemory memory;  // so that each question finds one that has not grown
    std::vector<BodyId> ids;
    std::string answer = {};  // of a question, as text
    std::unique_ptr<std::ostringstream> trace = std::make_unique<std::ostringstream>();

  private:
    void run() {
        for (std::size_t i = 0; i < ids.size(); i += 4) move(i, -0.2);
        world.set_pair_enabled(ids[9], ids[8], true);
        world.set_filter(ids[3], {});
        world.destroy_body(ids[6]);
        world.set_clearance(0.375);
    }
    void ebb() {
        for (std::size_t i = 2; i + 2 < ids.size(); ++i) {
            if (i != 9 && i != 10) world.destroy_body(ids[i]);
        }
        for (int i = 0; i < 5; ++i) ids.push_back(world.create_body(mesh, at(0.3 * i)));
    }
    void fill_lists() {
        for (const std::size_t i : {12, 13, 14, 15, 16, 17, 18, 30}) {
            move(i, -0.2);
            world.set_pair_enabled(ids[i], ids[i + 1], false);
        }
    }
};

inline std::string difference(Scene& expected, Scene& got) {
    if (expected.answer != got.answer) return "the answer " + got.answer + " in place of " + expected.answer;
    return difference(state_of(expected.world), state_of(got.world));
}

inline void expect_none(const Failures& failures, const std::string& what, std::uint64_t allocations_min = 0) {
    EXPECT_EQ(failures.defects, 0u) << what << ", " << failures.allocations << " failures; first: " << failures.first;
    EXPECT_GE(failures.allocations, allocations_min) << what;
}

}  // namespace ecods::allocation
