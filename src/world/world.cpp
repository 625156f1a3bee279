#include "base/make_error.hpp"
#include "base/misuse.hpp"
#include "ecods/rounded.hpp"
#include "ecods/solid.hpp"
#include "world/half_space_tests.hpp"
#include "world/mesh_mesh_test.hpp"
#include "world/rounded_test.hpp"
#include "world/world_access.hpp"
#include "world/world_impl.hpp"

namespace ecods {

void refuse_invalid(const Pose& pose, BodyId body, const ListIndex& index) {
    const InvalidEntry bad = find_invalid(pose).value();
    throw invalid_pose(bad.row, bad.column, bad.value).at(body, index);
}

namespace {

Aabb box_naming_the_body(const Shape& shape, const Pose& pose, BodyId body) {
    try {
        return shape.box(pose);
    } catch (const SingularPose& error) {
        throw SingularPose(error.argument, body);
    }
}

}  // namespace

Aabb box_for(const Shape& shape, const Pose& pose, BodyId body, const ListIndex& index) {
    const Aabb box = box_naming_the_body(shape, pose, body);
    for (int axis = 0; axis < 3; ++axis) {
        if (box.min[axis] <= box.max[axis]) continue;
        throw invalid_box(shape.kind(), axis, box.min[axis], box.max[axis]).at(body, index);
    }
    return box;
}

void require_usable(const std::shared_ptr<const Shape>& shape) {
    if (!shape) throw null_argument("shape");
    require_own_kind(*shape);
}

void require_own_kind(const Shape& shape) {
    if (shape.kind() == ShapeKind::mesh() && dynamic_cast<const MeshShape*>(&shape) == nullptr) {
        throw NotSupported("shape kind 0 is taken by MeshShape; a shape of one's own needs another kind");
    }
    const bool is_half_space = shape.kind() == ShapeKind::half_space();
    if ((is_rounded(shape.kind()) && dynamic_cast<const Rounded*>(&shape) == nullptr) ||
        (is_half_space && dynamic_cast<const HalfSpace*>(&shape) == nullptr)) {
        throw NotSupported(
            "the three greatest shape kinds are taken by Rounded and HalfSpace; a shape of one's own needs another "
            "kind");
    }
}

World::Impl::Impl(const WorldOptions& options)
    : bodies(options.ids), broad_phase(options.broad_phase), closeness(options.broad_phase), workers(options.executor) {
    tests.set_with_signs(ShapeKind::mesh(), ShapeKind::mesh(), make_mesh_mesh_test());
    add_half_space_tests(tests);
    add_rounded_tests(tests);
}

World::World(const WorldOptions& options) : impl_(std::make_unique<Impl>(options)) {}
World::~World() = default;
World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;

void World::Impl::require_tests_for(ShapeKind kind, const Shape* replaced, std::optional<Question> question) const {
    for (const auto& [other, count] : bodies.kind_counts()) {
        const std::size_t remaining = count - (replaced != nullptr && replaced->kind() == other);
        if (remaining == 0) continue;
        if (!tests.has(kind, other)) throw NotSupported(Question::intersects, kind, other);
        if (question) require_answer(kind, other, *question);
    }
}

void World::Impl::require_update_tests_for(ShapeKind kind, const Shape* replaced) const {
    require_tests_for(kind, replaced);
    for (const auto question : update_questions()) {
        if (question) require_tests_for(kind, replaced, question);
    }
}

void World::Impl::require_answers(Question question) const {
    for (const auto& [a, count_a] : bodies.kind_counts()) {
        for (const auto& [b, count_b] : bodies.kind_counts()) {
            if (a <= b && bodies.has_pair_of(a, b)) require_answer(a, b, question);
        }
    }
}

void World::Impl::require_answer(ShapeKind a, ShapeKind b, Question question) const {
    const OrderedTest test = tests.find(a, b);
    ecods::require_answer(*test.test, question, test.swapped ? b : a, test.swapped ? a : b);
}

void require_answer(const TwoBodyTest& test, Question question, ShapeKind a, ShapeKind b) {
    if (!test.answers(question)) throw NotSupported(question, a, b);
}

void WorldAccess::take_solids_for_surfaces(World& world) {
    World::Impl& w = world.impl();
    w.are_solids_surfaces = true;
    w.relations.list_solids_alone();
    w.tests.set(ShapeKind::mesh(), ShapeKind::mesh(), make_surface_surface_test());
}

World::Impl& World::impl() {
    if (!impl_) throw_misuse(MovedFromWorld());
    return *impl_;
}

const World::Impl& World::impl() const {
    if (!impl_) throw_misuse(MovedFromWorld());
    return *impl_;
}

bool World::is_alive(BodyId body) const noexcept {
    return impl_ && impl_->bodies.is_alive(body);
}

Pose World::pose(BodyId body) const {
    const Bodies& bodies = impl().bodies;
    return bodies[bodies.require(body)].pose;
}

std::shared_ptr<const Shape> World::shape(BodyId body) const {
    const Bodies& bodies = impl().bodies;
    return bodies[bodies.require(body)].shape;
}

Aabb World::box(BodyId body) const {
    const Impl& w = impl();
    return w.broad_phase.box(w.bodies.require(body));
}

std::uint64_t World::user_data(BodyId body) const {
    const Bodies& bodies = impl().bodies;
    return bodies[bodies.require(body)].user_data;
}

void World::set_user_data(BodyId body, std::uint64_t data) {
    Impl& w = impl();
    w.bodies[w.bodies.require(body)].user_data = data;
    if (w.trace) w.trace->write<calls::SetUserData>(body, data);
}

std::vector<BodyId> World::bodies() const {
    return impl().bodies.ids();
}

std::vector<BodyId> World::next_ids() const {
    return impl().bodies.next_ids();
}

}  // namespace ecods
