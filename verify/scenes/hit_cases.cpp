#include "scenes/hit_cases.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "scenes/distance_cases.hpp"
#include "scenes/hard_pair_parts.hpp"
#include "scenes/integer_rotation.hpp"
#include "scenes/lattice_bodies.hpp"

namespace ecods::scenes {
namespace {

using hard::Basis;
using hard::coin;
using hard::full;
using hard::integer;

constexpr double infinity = std::numeric_limits<double>::infinity();

double limit(Random& random) {
    switch (random.below(6)) {
        case 0:
            return 0;
        case 1:
            return 1;
        case 2:
            return std::ldexp(full(random, 0.5, 1), integer(random, -60, 60));
        case 3:
            return random.below(8) == 0 ? std::numeric_limits<double>::denorm_min() : integer(random, 1, 3) / 3.0;
        default:
            return infinity;
    }
}

// The segment, or a ray along it.
std::variant<Segment, Ray> line_of(const Segment& segment, Random& random) {
    const Vec3 direction = segment.b - segment.a;
    if (random.below(3) != 0 || !direction.allFinite() || direction == Vec3::Zero()) return segment;
    return Ray{segment.a, direction, limit(random)};
}

Segment lattice_segment(Random& random, int size) {
    return {lattice_point(random, size), lattice_point(random, size)};
}

HitCase lattice(Random& random) {
    const auto mesh = lattice_mesh(random, 2, 6, random.below(4) == 0);
    const Segment segment = lattice_segment(random, 3);
    if (coin(random)) return {mesh, Pose(), line_of(segment, random)};
    const Basis basis(random);
    return {in_basis(*mesh, basis), Pose(), line_of({in_basis(segment.a, basis), in_basis(segment.b, basis)}, random)};
}

HitCase lattice_one_ulp(Random& random) {
    HitCase made = lattice(random);
    const auto axis = integer(random, 0, 2);
    if (auto* segment = std::get_if<Segment>(&made.line)) {
        hard::nudge((coin(random) ? segment->a : segment->b)[axis], random);
    } else {
        hard::nudge(std::get<Ray>(made.line).origin[axis], random);
    }
    return made;
}

HitCase integer_matrix(Random& random) {
    HitCase made{lattice_mesh(random, 2, 6, random.below(4) == 0), Pose(), Segment()};
    const double scale = std::ldexp(1.0, integer(random, -400, 400));
    made.pose.R = integer_entries(random, 2);
    made.pose.t = lattice_point(random, 1000);
    Segment segment = lattice_segment(random, 3);
    for (Vec3* end : {&segment.a, &segment.b}) *end = scale * (made.pose.R * *end + made.pose.t);
    made.pose.R *= scale;
    made.pose.t *= scale;
    made.line = line_of(segment, random);
    return made;
}

HitCase points(Random& random) {
    HitCase made = coin(random) ? lattice(random) : integer_matrix(random);
    Vec3 at =
        std::holds_alternative<Segment>(made.line) ? std::get<Segment>(made.line).a : std::get<Ray>(made.line).origin;
    // A corner, half-way between two, or a mean of three: exact where the pose is of integers.
    const auto& t = made.mesh->triangles()[0];
    const auto corner = [&](std::size_t i) { return made.mesh->vertices()[t[i]]; };
    const auto inner = [&]() -> Vec3 {
        switch (random.below(4)) {
            case 0:
                return corner(random.below(3));
            case 1:
                return 0.5 * (corner(0) + corner(1 + random.below(2)));
            default:
                return 0.25 * corner(0) + 0.25 * corner(1) + 0.5 * corner(2);
        }
    };
    if (random.below(4) != 0) at = made.pose.R * inner() + made.pose.t;
    Segment segment{at, at};
    if (random.below(3) == 0) hard::nudge(segment.b[integer(random, 0, 2)], random);
    if (random.below(3) == 0) hard::nudge(segment.a[integer(random, 0, 2)], random);
    made.line = segment;
    return made;
}

// The triangle is in the plane z = p, the ray comes from z = 0 with a step of q.
HitCase rational(Random& random) {
    struct Place {
        Vec3 foot;
        Feature feature;
    };
    using Kind = Feature::Kind;
    const std::array<Place, 7> places{{{Vec3(1, 1, 0), {Kind::face, 0, 0}},
                                       {Vec3(2, 0, 0), {Kind::edge, 0, 0}},
                                       {Vec3(2, 2, 0), {Kind::edge, 0, 1}},
                                       {Vec3(0, 3, 0), {Kind::edge, 0, 2}},
                                       {Vec3(0, 0, 0), {Kind::vertex, 0, 0}},
                                       {Vec3(4, 0, 0), {Kind::vertex, 0, 1}},
                                       {Vec3(0, 4, 0), {Kind::vertex, 0, 2}}}};
    const Place& place = places[random.below(places.size())];
    const double p = integer(random, 0, 1000), q = integer(random, 1, 1000);
    const Vec3 slope(integer(random, -3, 3), integer(random, -3, 3), 0);
    const IntegerRotation of_space(random);
    const double scale = std::ldexp(1.0, integer(random, -800, 800));
    HitCase made;
    // In units of q, so that the foot is moved by whole numbers.
    made.mesh = Mesh::create({Vec3(0, 0, p) * q, Vec3(4 * q, 0, p * q), Vec3(0, 4 * q, p * q)}, {{0, 1, 2}});
    const Mat3 R = scale * of_space.R;
    made.pose.R = R;
    made.line = Ray{R * (q * place.foot - p * slope), R * (q * (slope + Vec3(0, 0, q))), infinity};
    made.known = HitCase::Known{p / q, place.feature};
    return made;
}

// The recipe above: the plane is at p / q.
HitCase limits(Random& random) {
    HitCase made = rational(random);
    Ray& ray = std::get<Ray>(made.line);
    const double at = made.known->parameter;
    ray.max_parameter = at;
    if (const std::uint32_t which = random.below(3); which != 0 && at > 0) {
        ray.max_parameter = std::nextafter(at, which == 1 ? 0.0 : infinity);
    }
    made.known.reset();
    return made;
}

HitCase from_distance_case(Random& random) {
    const DistanceCase made = any_family(distance_families(), random).make(random);
    const Vec3 of_a = any_corner(*made.a, made.pose_a, random);
    Segment segment{any_corner(*made.b, made.pose_b, random), of_a};
    if (random.below(3) == 0) segment.a = any_corner(*made.a, made.pose_a, random);
    if (const Vec3 beyond = 2 * segment.b - segment.a; coin(random) && beyond.allFinite()) segment.b = beyond;
    if (random.below(4) == 0) hard::nudge(segment.b[integer(random, 0, 2)], random);
    if (!segment.a.allFinite()) segment.a.setZero();
    if (!segment.b.allFinite()) segment.b.setOnes();
    return {made.a, made.pose_a, line_of(segment, random)};
}

constexpr Family<HitCase> table[] = {
    // Small lattice triangles and ends in a basis of full mantissas: vertices, edges, faces' planes
    {"lattice", lattice},
    {"lattice, one ulp", lattice_one_ulp},  // the same, one coordinate of an end a unit in the last place off
    // Small lattices under a matrix of small integers, singular ones and reflections among them
    {"integer matrix", integer_matrix},
    // Segments of length 0 on vertices, edges, faces and beside them, and ones of one unit
    {"points", points},
    // Known: a vertex, an edge or a face at the parameter p / q, in an integer rotation
    {"rational", rational},
    {"limits", limits},  // rays that end at, just before and just after a lattice plane
    // The bodies of distance_cases.hpp: lines through rounded corners of both, and beside them
    {"bodies of distances", from_distance_case},
};

}  // namespace

Families<HitCase> hit_families() {
    return table;
}

}  // namespace ecods::scenes
