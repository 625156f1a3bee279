// The table of what each question about two bodies answers, by kinds of bodies. rounded.hpp and half_space.hpp have it
// in words.
#include "unit/query/kinds.hpp"

#include <algorithm>
#include <cmath>
#include <concepts>
#include <type_traits>
#include <utility>

namespace ecods::kinds {
namespace {

const Vec3 ahead(2, 0, 0);

// FUNCTION makes a function of two bodies that std::invocable accepts only if the call in it exists.
#define FUNCTION(...)                                     \
    [=](const auto& a, const auto& b) requires requires { \
        __VA_ARGS__;                                      \
    }                                                     \
    { return __VA_ARGS__; }

// Asks, and expects an answer that is the same for both orders of the bodies.
template <class Function, class Expect>
auto asks(const Function& function, const Expect& expect) {
    return [=](const Case& c) {
        ask_typed(c, function, [&](const auto& answer, bool is_exchanged) { expect(c, answer, is_exchanged); });
    };
}
const auto anything = [](const Case&, const auto&, bool) {};

// Expects a number to be the known distance; where none is known, not to be negative.
void expect_number(const Case& c, double got) {
    if (c.is_known()) {
        EXPECT_EQ(got, c.distance());
    }
    if (!c.is_known()) {
        EXPECT_GE(got, 0) << "a surface may have nothing where the other body is";
    }
}

// Casts take any solid as a mesh.
template <class Thing>
using CastAs = std::conditional_t<std::derived_from<Thing, MeshShape>, MeshShape, Thing>;
template <class Thing>
Moving<CastAs<Thing>> moving(const Posed<Thing>& body, const Pose& to) {
    return {*body.what, body.pose, to};
}
template <class Thing>
Turning<CastAs<Thing>> turning(const Posed<Thing>& body, const Turn& turn) {
    return {*body.what, body.pose, turn};
}

Deforming deforming(const Posed<MeshShape>& body) {
    std::vector<Vec3> ends(body.what->mesh().vertices().begin(), body.what->mesh().vertices().end());
    return {std::make_shared<const MeshShape>(body.what->mesh_ptr()), std::move(ends)};
}

void expect_bounds(const Case& c, const DistanceBounds& got) {
    EXPECT_LE(got.lower, got.upper);
    if (c.is_known()) {
        EXPECT_TRUE(got.lower <= c.distance() && got.upper >= c.distance());
    }
}
void expect_points(const Case& c, const ClosestPoints& got, bool is_exchanged) {
    expect_number(c, got.distance);
    if (c.gap <= 0) return;
    EXPECT_EQ((got.point_b - got.point_a)[0], is_exchanged ? -c.toward() : c.toward());
    EXPECT_EQ(std::min(got.point_a[0], got.point_b[0]), 1);
}

std::vector<Row> triangles() {
    const auto near = [](const Case& c, const auto& got, bool) { EXPECT_TRUE(!got.empty() || c.gap < 0); };
    const auto meeting = [](const Case& c, const auto& got, bool) {
        EXPECT_TRUE(got.empty() == (c.gap > 0) || c.gap < 0);
    };
    return {
        // of            M       S      C     F    K   R  H
        // and           MSCFKRH SCFKRH CFKRH FKRH KRH RH H
        {"close_triangles", "++++--- +++--- ++--- +--- --- -- -", asks(FUNCTION(close_triangles(a, b, 1)), near)},
        {"close_features", "++++--- +++--- ++--- +--- --- -- -", asks(FUNCTION(close_features(a, b, 1)), near)},
        {"intersecting_triangles", "++++--- +++--- ++--- +--- --- -- -",
         asks(FUNCTION(intersecting_triangles(a, b)), meeting)},
        {"intersections", "++++--- +++--- ++--- +--- --- -- -", asks(FUNCTION(intersections(a, b)), meeting)},
    };
}

std::vector<Row> distances() {
    const auto number = [](const Case& c, double got, bool) { expect_number(c, got); };
    const auto bounds = [](const Case& c, const DistanceBounds& got, bool) { expect_bounds(c, got); };
    const auto closest_points = expect_points;
    const auto yes_if_meeting = [](const Case& c, bool got, bool) {
        if (c.is_known()) {
            EXPECT_EQ(got, c.gap <= 0);
        }
    };
    const auto within_half = [](const Case& c, bool got, bool) { EXPECT_TRUE(got || c.gap > 0.5 || c.gap < 0); };
    const auto how = [](const Case& c, Relation got, bool) {
        if (c.is_known()) {
            EXPECT_EQ(got, c.gap > 0 ? Relation::apart : Relation::touching);
        }
    };
    const double below_one = std::nextafter(1.0, 0.0);
    return {
        // of            M       S      C     F    K   R  H
        // and           MSCFKRH SCFKRH CFKRH FKRH KRH RH H
        {"intersects", "+++++++ ++++++ +++++ ++++ +++ ++ +", asks(FUNCTION(intersects(a, b)), yes_if_meeting)},
        {"relation", "+++++a+ ++++a+ +++a+ ++a+ +a+ a+ +", asks(FUNCTION(relation(a, b)), how)},
        {"distance", "+++++++ ++++++ +++++ ++++ +++ ++ +", asks(FUNCTION(distance(a, b)), number)},
        {"within", "+++++++ ++++++ +++++ ++++ +++ ++ +", asks(FUNCTION(within(a, b, 0.5)), within_half)},
        {"within, compared exactly", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         asks(FUNCTION(std::pair(within(a, b, 1), within(a, b, below_one))),
              [](const Case& c, const std::pair<bool, bool>& got, bool) {
                  EXPECT_TRUE(got.first || c.gap < 0);
                  EXPECT_TRUE(got.second == (c.gap < 1) || c.gap < 0);
              })},
        {"closest", "+++++++ ++++++ +++++ ++++ +++ ++ -", asks(FUNCTION(closest(a, b)), closest_points)},
        {"distance_bounds", "++++++- +++++- ++++- +++- ++- +- -",
         asks(FUNCTION(distance_bounds(a, b, DistanceTolerance{})), bounds)},
        {"signed_distance_bounds", "++++--- +++--- ++--- +--- --- -- -",
         asks(FUNCTION(signed_distance_bounds(a, b)), bounds)},
        {"signed_distance", "----aa+ ---aa+ +++a+ ++a+ +a+ a+ -",
         asks(FUNCTION(signed_distance(a, b)),
              [](const Case& c, const SignedDistance& got, bool is_exchanged) {
                  if (c.is_known()) {
                      EXPECT_EQ(got.distance, c.gap);
                  }
                  if (c.gap > 0) {
                      EXPECT_EQ(got.direction, Vec3((is_exchanged ? -1 : 1) * c.toward(), 0, 0));
                  }
              })},
    };
}

std::vector<Row> depths() {
    const auto deep = [](const Case& c, const auto& got, bool) {
        if (c.is_known()) {
            EXPECT_EQ(got.has_value(), c.gap <= 0);
        }
    };
    return {
        // of            M       S      C     F    K   R  H
        // and           MSCFKRH SCFKRH CFKRH FKRH KRH RH H
        {"depth", "----xx- ---xx- +++x- ++x- +x- x- -",
         asks(FUNCTION(depth(a, b)),
              [](const Case& c, const std::optional<Depth>& got, bool) {
                  if (c.is_known()) {
                      EXPECT_EQ(got.has_value(), c.gap <= 0);
                  }
                  if (got && c.is_known()) {
                      EXPECT_EQ(got->depth, 0);
                  }
              })},
        {"depth_bounds", "------- +++--- ++--- +--- --- -- -", asks(FUNCTION(depth_bounds(a, b)), deep)},
        {"depth_points", "------- ------ ++--- +--- --- -- -", asks(FUNCTION(depth_points(a, b)), deep)},
        {"depth_along", "------- ------ ++--- +--- --- -- -", asks(FUNCTION(depth_along(a, b, ahead)), deep)},
        {"contact_patch", "xxxxxxx xxxxxx +++x+ ++x+ +x+ xx x",
         asks(FUNCTION(contact_patch(a, b)),
              [](const Case& c, const ContactPatch& got, bool) {
                  EXPECT_FALSE(got.corners.empty());
                  if (c.is_known()) {
                      EXPECT_EQ(got.distance, c.gap);
                  }
                  if (c.gap > 0) {
                      EXPECT_EQ(got.normal, Vec3(c.toward(), 0, 0));
                  }
              })},
        {"certify", "+xxx--- xxx--- xx--- x--- --- -- -", asks(FUNCTION(certify(a, b)), anything)},
        {"certify_distance", "+xxx--- xxx--- xx--- x--- --- -- -", asks(FUNCTION(certify_distance(a, b)), anything)},
        {"certify_within", "+xxx--- xxx--- xx--- x--- --- -- -", asks(FUNCTION(certify_within(a, b, 1)), anything)},
    };
}

// The first contact of a body that goes to the other one by 2 in the time from 0 to 1.
void expect_contact(const Case& c, const std::optional<FirstContact>& got, double at_gap_one) {
    if (!c.is_known()) return;
    ASSERT_TRUE(got.has_value());
    EXPECT_EQ(got->time, c.gap > 0 ? at_gap_one : 0);
}

std::vector<Row> casts() {
    const auto toward = [](const Case& c) { return Vec3(2 * c.toward(), 0, 0); };
    const auto by = [=](const auto& ask, double at_gap_one) {
        return [=](const Case& c) {
            ask_typed(c, ask(c, toward(c)), [&](const auto& got, bool) { expect_contact(c, got, at_gap_one); });
        };
    };
    const auto any_time = [=](const auto& ask) {
        return [=](const Case& c) { ask_typed(c, ask(c, toward(c)), [](const auto&, bool) {}); };
    };
    // In the other order, a half space is at rest, and the body comes.
    const auto sign = [](const Case& c, const auto& a) { return a.what == c.a.shape.get() ? 1.0 : -1.0; };
    // The left body turns.
    const auto is_left = [](const Case& c, const auto& x) { return x.what == c.left().shape.get(); };
    const auto end_of = [=](const Case& c, const auto& x) { return is_left(c, x) ? turned(x.pose) : x.pose; };
    const Turn quarter = {{1, 0, 0, 1}, {3, 7, 5}, {3, 7, 5}};
    return {
        // of            M       S      C     F    K   R  H
        // and           MSCFKRH SCFKRH CFKRH FKRH KRH RH H
        {"cast of a translation", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         by([=](const Case& c, const Vec3& m) { return FUNCTION(cast(a, Vec3(sign(c, a) * m), b)); }, 0.5)},
        {"cast_to_distance", "++++++- +++++- ++++- +++- ++- +- -",
         by([=](const Case&, const Vec3& m) { return FUNCTION(cast_to_distance(a, m, b, 0.5)); }, 0.25)},
        {"cast from pose to pose, translated", "+++++++ ++++++ +++++ ++++ +++ ++ +",
         by([=](const Case& c,
                const Vec3& m) { return FUNCTION(cast(moving(a, moved(a.pose, sign(c, a) * m)), moving(b, b.pose))); },
            0.5)},
        {"cast from pose to pose, turned", "++++sxs +++sxs ++sxs +sss sss xs s",
         any_time([=](const Case& c, const Vec3&) {
             return FUNCTION(cast(moving(a, end_of(c, a)), moving(b, end_of(c, b))));
         })},
        {"cast of motions, translated", "++++++- +++++- ++++- +++- ++- +- -",
         by([=](const Case&,
                const Vec3& m) { return FUNCTION(cast(a, Motion(Translation{m}), b, Motion(Translation{0 * m}))); },
            0.5)},
        {"cast of motions, turned", "++++xx- +++xx- ++xx- +xx- xx- x- -", any_time([=](const Case& c, const Vec3&) {
             return FUNCTION(
                 cast(a, is_left(c, a) ? Motion(quarter) : Motion(), b, is_left(c, b) ? Motion(quarter) : Motion()));
         })},
        {"cast of a Deforming", "++++--- +++--- ++--- +--- --- -- -",
         any_time([=](const Case&, const Vec3&) { return FUNCTION(cast(deforming(a), b)); })},
        {"entering", "+xxx--- ++x--- +x--- x--- --- -- -",
         any_time([=](const Case& c, const Vec3& m) { return FUNCTION(entering(a, Vec3(sign(c, a) * m), b)); })},
        {"pose_before", "++++--- +++--- ++--- +--- --- -- -",
         any_time([=](const Case& c, const Vec3& m) { return FUNCTION(pose_before(a, Vec3(sign(c, a) * m), b, 1)); })},
        {"cast of a Turning", "++++--- +++--- ++--- +--- --- -- -",
         any_time([=](const Case&, const Vec3&) { return FUNCTION(cast(turning(a, quarter), b)); })},
    };
}

TEST(Kinds, Distances) {
    expect_table(distances());
    expect_table(triangles());
}

TEST(Kinds, Depths) {
    expect_table(depths());
}

TEST(Kinds, Casts) {
    expect_table(casts());
}

}  // namespace
}  // namespace ecods::kinds
