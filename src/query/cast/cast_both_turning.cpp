#include "exact/measure/contact/turning_triangles.hpp"
#include "exact/point/integer_points.hpp"
#include "exact/point/vectors.hpp"
#include "geometry/find_invalid.hpp"
#include "geometry/same_bits.hpp"
#include "query/cast/cast_until.hpp"
#include "query/cast/one_time_memory.hpp"
#include "query/cast/search_pieces.hpp"
#include "query/cast/turn_vector.hpp"
#include "query/intersection/query_memory.hpp"
#include "query/intersection/surface_intersection.hpp"
#include "query/shape/other_units.hpp"

namespace ecods {
namespace {

bool is_zero_vector(const exact::LongVector3& v) {
    return v[0].is_zero() && v[1].is_zero() && v[2].is_zero();
}

// Returns true if turns by the quaternions q and r have the same rotation at every time.
bool have_same_rotation(const Quaternion& q, const Quaternion& r) {
    const Vec3 v = vector_of(q), w = vector_of(r);
    return same_point(v, w) && (is_zero(v) || same_point({q.w, 0, 0}, {r.w, 0, 0}));
}

// Returns true if two bodies with turns a and b move as one rigid body: their rotations are equal, the motions of their
// pivots are equal, and both pivots are on one axis of rotation. The distance of any two points is then constant.
bool move_as_one(const Turn& a, const Turn& b) {
    if (!have_same_rotation(a.q, b.q)) return false;
    static const Pose world;
    const exact::PosedPoints<4> pivots{
        {{&world, &a.pivot_from}, {&world, &a.pivot_to}, {&world, &b.pivot_from}, {&world, &b.pivot_to}}};
    return exact::with_integers(pivots, [&](const auto& points) {
        const auto at = [&](std::size_t i) -> exact::LongVector3 {
            const auto& p = points.at[i];
            return {exact::Integer(p[0]), exact::Integer(p[1]), exact::Integer(p[2])};
        };
        const exact::LongVector3 from_a = at(0), from_b = at(2);
        const exact::TurnIntegers turn(a.q.w, vector_of(a.q));
        return is_zero_vector(exact::minus(exact::minus(at(1), from_a), exact::minus(at(3), from_b))) &&
               is_zero_vector(exact::cross(turn.v, exact::minus(from_b, from_a)));
    });
}

std::optional<FirstContact> contact_as_one(const Posed<MeshShape>& a, const Posed<MeshShape>& b, QueryMemory& memory,
                                           PairWitness& witness) {
    PairWitness at_start = witness;
    if (!as_part(memory, [&] { return surface::intersects(a, b, {memory, at_start}); })) return std::nullopt;
    witness = at_start;
    return contact_at_start(a, b, memory);
}

std::optional<FirstContact> search_pieces(const Turning<MeshShape>& a, const Turning<MeshShape>& b, double latest,
                                          QueryMemory& memory, PairWitness& witness) {
    using Search = PieceSearch<BothTurningQuestion>;
    Search::Working& working = OneTimeMemory::of(memory).both_turn;
    working.question.motion().bind(a, b, QueryMemoryAccess::state(memory).counts.casts);
    const Posed<MeshShape> start_a(*a.what, a.pose), start_b(*b.what, b.pose);
    if (move_as_one(a.turn, b.turn)) return contact_as_one(start_a, start_b, memory, witness);
    return Search(start_a, start_b, latest, memory, witness, working).run();
}
std::optional<FirstContact> search_pieces(const Turning<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                          QueryMemory& memory, PairWitness& witness) {
    using Search = PieceSearch<TurnAndStraightQuestion>;
    Search::Working& working = OneTimeMemory::of(memory).turn_and_straight;
    working.question.motion().bind(a, b, QueryMemoryAccess::state(memory).counts.casts);
    const Posed<MeshShape> start_a(*a.what, a.pose), start_b(*b.what, b.from);
    return Search(start_a, start_b, latest, memory, witness, working).run();
}

// Returns the result of search_pieces() for both bodies, in other units if these are better.
template <class Other>
std::optional<FirstContact> cast_in_units(const Turning<MeshShape>& a, const Other& b, double latest,
                                          QueryMemory& memory, PairWitness& witness) {
    ++QueryMemoryAccess::state(memory).counts.queries;
    const OtherUnits units(a, b);
    if (!units.are_better()) return search_pieces(a, b, latest, memory, witness);
    const Turning<MeshShape> scaled_a = units.of(a);
    const Other scaled_b = units.of(b);
    return as_part(memory, [&] { return search_pieces(scaled_a, scaled_b, latest, memory, witness); });
}

}  // namespace

std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Turning<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness) {
    return cast_in_units(a, b, latest, memory, witness);
}
std::optional<FirstContact> cast_until(const Turning<MeshShape>& a, const Moving<MeshShape>& b, double latest,
                                       QueryMemory& memory, PairWitness& witness) {
    return cast_in_units(a, b, latest, memory, witness);
}

}  // namespace ecods
