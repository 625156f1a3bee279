#include "suites/own_questions.hpp"

#include <fmt/core.h>

#include <bit>

#include "ecods/cast.hpp"
#include "ecods/certificate.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/shape.hpp"
#include "ecods/solid.hpp"

namespace ecods::bench {

namespace {

using Body = Posed<MeshShape>;

template <class Shape>
std::unique_ptr<MeshShape> make(const std::shared_ptr<const Mesh>& mesh) {
    return std::make_unique<Shape>(mesh);
}

std::unique_ptr<MeshShape> make_hull(const std::shared_ptr<const Mesh>& mesh) {
    return std::make_unique<ConvexSolid>(mesh->vertices());
}

// Casts the body to the shape that `make` made.
template <class Shape>
Posed<Shape> as(const Body& body) {
    return {static_cast<const Shape&>(*body.what), body.pose};
}

void add(Hash& hash, const Feature& feature) {
    hash.add(static_cast<std::uint64_t>(feature.kind));
    hash.add(std::uint64_t{feature.triangle} << 32 | feature.corner);
}

std::uint64_t touch(const Body& a, const Body& b, const Ask& ask) {
    return intersects(a, b, ask) ? 1 : 0;
}

std::uint64_t distance_bits(const Body& a, const Body& b, const Ask& ask) {
    return std::bit_cast<std::uint64_t>(distance(a, b, ask));
}

std::uint64_t relation_number(const Body& a, const Body& b, const Ask& ask) {
    return static_cast<std::uint64_t>(relation(a, b, ask));
}

std::uint64_t triangle_pairs(const Body& a, const Body& b, const Ask& ask) {
    Hash hash;
    for (const TrianglePair& pair : intersecting_triangles(a, b, ask)) hash.add(std::uint64_t{pair.a} << 32 | pair.b);
    return hash.value();
}

std::uint64_t closest_features(const Body& a, const Body& b, const Ask& ask) {
    const ClosestPoints points = closest(a, b, ask);
    Hash hash;
    hash.add(points.distance);
    hash.add(static_cast<std::uint64_t>(points.kind));
    add(hash, points.a);
    add(hash, points.b);
    return hash.value();
}

// The limit is an eighth of the distance of their centres.
std::uint64_t is_within(const Body& a, const Body& b, const Ask& ask) {
    return within(a, b, (b.pose.t - a.pose.t).norm() / 8, ask) ? 1 : 0;
}

std::uint64_t contact_bits(const std::optional<FirstContact>& contact) {
    Hash hash;
    if (!contact) return hash.value();
    hash.add(contact->time);
    hash.add(static_cast<std::uint64_t>(contact->kind));
    add(hash, contact->a);
    add(hash, contact->b);
    return hash.value();
}

// Goes from twice as far as it is to where the other one is.
std::uint64_t cast_contact(const Body& a, const Body& b, const Ask& ask) {
    const Vec3 way = b.pose.t - a.pose.t;
    return contact_bits(cast({*a.what, {a.pose.R, a.pose.t - way}}, 2 * way, b, 1, ask));
}

// Turns on the way, from the pose of the first to that of the second.
std::uint64_t move_contact(const Body& a, const Body& b, const Ask& ask) {
    const Vec3 way = b.pose.t - a.pose.t;
    return contact_bits(cast(Moving<MeshShape>(*a.what, {a.pose.R, a.pose.t - way}, b.pose),
                             Moving<MeshShape>(*b.what, b.pose, b.pose), 1, ask));
}

void add(Hash& hash, const Hit& hit) {
    hash.add(hit.parameter);
    hash.add(hit.leave_parameter);
    hash.add(static_cast<std::uint64_t>(hit.kind));
    add(hash, hit.feature);
    for (const double x : hit.point) hash.add(x);
}

// Goes through both centres, and as far again.
Segment line_of(const Body& a, const Body& b) {
    return {a.pose.t, b.pose.t + (b.pose.t - a.pose.t)};
}

std::uint64_t first_hit_bits(const Body& a, const Body& b, const Ask& ask) {
    Hash hash;
    if (const std::optional<Hit> hit = first_hit(line_of(a, b), b, ask)) add(hash, *hit);
    return hash.value();
}

std::uint64_t all_hit_bits(const Body& a, const Body& b, const Ask& ask) {
    Hash hash;
    for (const Hit& hit : all_hits(line_of(a, b), b, ask)) add(hash, hit);
    return hash.value();
}

std::uint64_t certificate_bits(const Body& a, const Body& b, const Ask& ask) {
    const Certificate certificate = certify(a, b, ask);
    return static_cast<std::uint64_t>(certificate.claim());
}

// Numbers relations of solids without `crossing`, as builds before 0.4 do: their answers are compared with new ones.
std::uint64_t solid_relation_number(const Body& a, const Body& b, const Ask& ask) {
    const Relation relation = ecods::relation(as<Solid>(a), as<Solid>(b), ask);
    return static_cast<std::uint64_t>(relation) - (relation > Relation::crossing ? 1 : 0);
}

std::uint64_t location_bits(const Body& a, const Body& b, const Ask& ask) {
    const Location location = locate(a.pose.t, as<Solid>(b), ask);
    Hash hash;
    hash.add(static_cast<std::uint64_t>(location.side));
    add(hash, location.feature);
    return hash.value();
}

// Says how deep, or else how far.
std::uint64_t hull_bits(const Body& a, const Body& b, const Ask& ask) {
    const Posed<ConvexSolid> one = as<ConvexSolid>(a), other = as<ConvexSolid>(b);
    const double apart = distance(one, other, ask);
    if (apart > 0) return std::bit_cast<std::uint64_t>(apart);
    const Depth deep = depth(one, other, ask).value();
    Hash hash;
    hash.add(deep.depth);
    add(hash, deep.a);
    add(hash, deep.b);
    return hash.value();
}

}  // namespace

void Hash::add(std::uint64_t value) {
    for (int i = 0; i < 8; ++i) {
        state_ = (state_ ^ (value & 255)) * 1099511628211u;
        value >>= 8;
    }
}

void Hash::add(double value) {
    add(std::bit_cast<std::uint64_t>(value));
}

std::string Hash::text() const {
    return fmt::format("{:016x}", state_);
}

const OwnQuestion touch_question{"", make<MeshShape>, touch};
const OwnQuestion distance_question{", distances", make<MeshShape>, distance_bits};
const OwnQuestion closest_question{", closest", make<MeshShape>, closest_features};

std::span<const OwnQuestion> surface_questions() {
    static const OwnQuestion questions[] = {{", relations", make<MeshShape>, relation_number},
                                            {", triangles", make<MeshShape>, triangle_pairs},
                                            closest_question,
                                            {", within", make<MeshShape>, is_within},
                                            {", casts", make<MeshShape>, cast_contact},
                                            {", moves", make<MeshShape>, move_contact},
                                            {", first hits", make<MeshShape>, first_hit_bits},
                                            {", all hits", make<MeshShape>, all_hit_bits},
                                            {", certificates", make<MeshShape>, certificate_bits},
                                            {", hulls", make_hull, hull_bits}};
    return questions;
}

std::span<const OwnQuestion> solid_questions() {
    static const OwnQuestion questions[] = {{", solid relations", make<Solid>, solid_relation_number},
                                            {", locations", make<Solid>, location_bits}};
    return questions;
}

}  // namespace ecods::bench
