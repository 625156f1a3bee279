#include <algorithm>

#include "ecods/error.hpp"
#include "world/world_impl.hpp"

namespace ecods {
namespace {

// Looks up the subject of a question in a World::Impl: a body, a shape at a pose, or a mesh at a pose.
template <class Impl>
struct FindSubject {
    const Impl& world;

    Subject operator()(BodyId body) const {
        const ProxyIndex proxy = world.bodies.require(body);
        return {world.bodies[proxy].posed(), proxy};
    }
    Subject operator()(const Posed<Shape>& posed) const {
        require_own_kind(*posed.what);
        require_valid(posed.pose);
        return {posed};
    }
    Subject operator()(const Asked::MeshAt& at) const {
        require_valid(at.pose);
        auto shape = world.mesh_shapes.find(at.mesh);
        if (!shape) shape = std::make_shared<const MeshShape>(at.mesh);
        return {Posed<Shape>(std::move(shape), at.pose)};
    }
};

}  // namespace

Subject World::Impl::subject_of(const Asked& asked) const {
    Subject subject = std::visit(FindSubject<Impl>{*this}, asked.what());
    subject.filter = asked.filter();
    return subject;
}

bool World::Impl::passes_over(const Subject& subject, ProxyIndex other) const {
    if (subject.proxy && (other == *subject.proxy || !bodies.is_enabled(ordered_pair(*subject.proxy, other)))) {
        return true;
    }
    return subject.filter && !may_meet(*subject.filter, bodies[other].filter);
}

Aabb World::Impl::box_of(const Subject& subject) const {
    return subject.proxy ? broad_phase.box(*subject.proxy) : box_for(*subject.posed.what, subject.posed.pose);
}

void World::Impl::require_tests_for(const Subject& subject, std::optional<Question> question) const {
    require_tests_for(subject.kind(), subject.proxy ? bodies[*subject.proxy].shape.get() : nullptr, question);
}

SubjectPair World::Impl::pair_of(const Asked& asked_a, const Asked& asked_b, PairOrder order) const {
    Subject a = subject_of(asked_a), b = subject_of(asked_b);
    if (a.proxy && b.proxy) bodies.require_pair(bodies.id_of(*a.proxy), bodies.id_of(*b.proxy));
    const bool is_turned = order == PairOrder::lesser_id_first && a.proxy && b.proxy && *b.proxy < *a.proxy;
    if (is_turned) std::swap(a, b);
    if (!tests.has(a.kind(), b.kind())) throw NotSupported(Question::intersects, a.kind(), b.kind());
    const OrderedTest test = tests.find(a.kind(), b.kind());
    return {std::move(a), std::move(b), test, is_turned};
}

}  // namespace ecods
