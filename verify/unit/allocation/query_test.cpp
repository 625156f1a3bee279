// What needs no World, out of memory at any point: meshes, shapes, refits, questions about two bodies.
#include <gtest/gtest.h>

#include <bit>
#include <optional>
#include <utility>

#include "allocation/each_allocation.hpp"
#include "ecods/cast.hpp"
#include "ecods/contact.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "scenes/shapes.hpp"

namespace ecods::allocation {
namespace {

// Two spheres of a size at which queries use all their memory, with trees that nobody has made yet.
struct Pair {
    explicit Pair(double distance) { pose_b.t[0] = distance; }

    Posed<MeshShape> first() const { return {*a, pose_a}; }
    Posed<MeshShape> second() const { return {*b, pose_b}; }

    std::shared_ptr<const MeshShape> a = std::make_shared<MeshShape>(scenes::sphere(12, 8));
    std::shared_ptr<const MeshShape> b = std::make_shared<MeshShape>(scenes::torus(12, 8, 0.25));
    Pose pose_a, pose_b;
    QueryMemory memory;
    PairWitness witness;
    std::string answer = {};
};

std::string number(std::size_t value) {
    return std::to_string(value);
}

std::string text(Relation relation) {
    return number(static_cast<std::size_t>(relation));
}

// Every bit of it.
std::string text(double x) {
    return number(std::bit_cast<std::uint64_t>(x));
}

std::string text(const ClosestPoints& closest) {
    std::string all = text(closest.distance);
    const auto add = [&](const std::string& one) { all.append(" ").append(one); };
    add(number(closest.a.triangle));
    add(number(closest.b.triangle));
    for (int k = 0; k < 3; ++k) {
        add(text(closest.point_a[k]));
        add(text(closest.point_b[k]));
    }
    return all;
}

std::string text(const std::optional<Vec3>& v) {
    std::string all;
    for (int k = 0; v && k < 3; ++k) all.append(" ").append(text((*v)[k]));
    return all;
}

std::string text(const std::vector<CloseFeatures>& close) {
    std::string all;
    for (const CloseFeatures& c : close) {
        all.append(text(c.closest)).append(text(c.direction)).append("; ");
    }
    return all;
}

std::string text(const std::vector<TriangleIntersection>& intersections) {
    std::string all;
    for (const TriangleIntersection& i : intersections) {
        for (const Vec3& corner : i.shared.corners()) all.append(text(std::optional(corner)));
        all.append(text(i.shared.normal)).append("; ");
    }
    return all;
}

std::string text(const std::optional<FirstContact>& contact) {
    if (!contact) return "none";
    return text(contact->time)
        .append(" ")
        .append(number(contact->a.triangle))
        .append(" ")
        .append(number(contact->b.triangle));
}

std::string text(const std::vector<Hit>& hits) {
    std::string all;
    for (const Hit& hit : hits) all.append(text(hit.parameter)).append(" ").append(number(hit.triangle())).append("; ");
    return all;
}
// From before both bodies to beyond them.
const Segment through{{3, 0.125, 0.25}, {-3, -0.125, -0.25}};

std::string first_of(const std::optional<Hit>& hit) {
    return hit ? text(std::vector<Hit>{*hit}) : "none";
}

// From afar to beyond the other one.
std::optional<FirstContact> cast_past(Pair& p) {
    Pose start = p.pose_b;
    start.t[0] += 4;
    return cast({*p.b, start}, -1.5 * start.t, p.first(), p.memory, p.witness);
}

// To behind the other one, turned over on the way: flat half-way.
std::optional<FirstContact> move_past(Pair& p) {
    Pose end;
    end.R = Vec3(-1, -1, 1).asDiagonal();
    end.t = -0.5 * p.pose_b.t;
    return cast(Moving<MeshShape>(*p.b, p.pose_b, end), Moving<MeshShape>(*p.a, p.pose_a, p.pose_a), p.memory);
}

struct Question {
    const char* name;
    void (*ask)(Pair&);
};

const Question questions[] = {
    {"intersects", [](Pair& p) { p.answer = number(intersects(p.first(), p.second(), p.memory)); }},
    {"intersects, with a witness",
     [](Pair& p) { p.answer = number(intersects(p.first(), p.second(), p.memory, p.witness)); }},
    {"relation", [](Pair& p) { p.answer = text(relation(p.first(), p.second(), p.memory)); }},
    {"intersecting_triangles",
     [](Pair& p) { p.answer = number(intersecting_triangles(p.first(), p.second(), p.memory).size()); }},
    {"distance", [](Pair& p) { p.answer = text(distance(p.first(), p.second(), p.memory)); }},
    {"distance, with a witness",
     [](Pair& p) { p.answer = text(distance(p.first(), p.second(), p.memory, p.witness)); }},
    {"first_hit", [](Pair& p) { p.answer = first_of(first_hit(through, p.first(), p.memory)); }},
    {"first_hit, with a witness",
     [](Pair& p) { p.answer = first_of(first_hit(through, p.first(), p.memory, p.witness)); }},
    {"all_hits", [](Pair& p) { p.answer = text(all_hits(through, p.second(), p.memory)); }},
    {"within", [](Pair& p) { p.answer = number(within(p.first(), p.second(), 0.25, p.memory, p.witness)); }},
    {"closest", [](Pair& p) { p.answer = text(closest(p.first(), p.second(), p.memory)); }},
    {"distance_bounds",
     [](Pair& p) {
         const DistanceBounds bounds = distance_bounds(p.first(), p.second(), {.relative = 0.25}, p.memory);
         p.answer = text(bounds.lower).append(" ").append(text(bounds.upper));
     }},
    {"close_triangles",
     [](Pair& p) {
         std::string all;
         for (const ClosestPoints& close : close_triangles(p.first(), p.second(), 0x1p-6, p.memory)) {
             all.append(text(close)).append("; ");
         }
         p.answer = std::move(all);
     }},
    {"close_features", [](Pair& p) { p.answer = text(close_features(p.first(), p.second(), 0x1p-6, p.memory)); }},
    {"cast of a translation",
     [](Pair& p) { p.answer = text(cast(p.second(), -1.5 * p.pose_b.t, p.first(), p.memory)); }},
    {"cast of a translation, with a witness", [](Pair& p) { p.answer = text(cast_past(p)); }},
    {"cast between poses", [](Pair& p) { p.answer = text(move_past(p)); }},
    {"intersections", [](Pair& p) { p.answer = text(intersections(p.first(), p.second(), p.memory)); }},
    {"MeshShape::box", [](Pair& p) { p.answer = number(p.a->box(p.pose_b).min.allFinite()); }},
    {"MeshShape::tree_bytes", [](Pair& p) { p.answer = number(p.a->tree_bytes()); }},
    {"refit without a tree",
     [](Pair& p) {
         const auto vertices = p.a->mesh().vertices();
         p.answer = number(refit(*p.a, {vertices.begin(), vertices.end()})->digest());
     }},
    {"refit with a tree",
     [](Pair& p) {
         const auto vertices = p.b->mesh().vertices();
         p.b->tree_bytes();
         p.answer = number(refit(*p.b, {vertices.begin(), vertices.end()})->tree_bytes());
     }},
    {"Mesh::create and a shape of it",
     [](Pair& p) {
         const auto mesh = scenes::cube(0.5);
         p.answer = number(std::make_shared<MeshShape>(mesh)->tree_bytes());
     }},
};

void go_on(Pair& p) {
    for (int step = 0; step < 3; ++step) {
        p.pose_b.t[0] += 0.125;
        p.answer += number(intersects(p.first(), p.second(), p.memory, p.witness));
        p.answer += text(relation(p.second(), p.first(), p.memory)) + " ";
        p.answer += number(intersecting_triangles(p.first(), p.second(), p.memory).size());
        p.answer += text(distance(p.first(), p.second(), p.memory, p.witness));
    }
}

TEST(QueryOutOfMemory, EveryQuestionIsAnsweredTheNextTime) {
    for (const Question& question : questions) {
        Failures failures;
        // Deep in one another, and at distance 2 in contact, decided by exact numbers.
        for (const double distance : {0.75, 2.0, 2.25, 9.0}) {
            fail_each_allocation<Pair>(
                {.make = [=] { return Pair(distance); },
                 .call = question.ask,
                 .difference = [](Pair& x,
                                  Pair& y) { return x.answer == y.answer ? "" : y.answer + " for " + x.answer; },
                 .go_on = go_on},
                failures);
        }
        EXPECT_EQ(failures.defects, 0u) << question.name << "; first: " << failures.first;
    }
}

// A shape that two bodies share is asked on while one question failed to make its tree.
TEST(QueryOutOfMemory, ASharedShapeKeepsWhatItHas) {
    Failures failures;
    fail_each_allocation<Pair>({.make =
                                    [] {
                                        Pair pair(0.75);
                                        pair.b = pair.a;
                                        return pair;
                                    },
                                .call = [](Pair& p) { p.answer = text(relation(p.first(), p.second(), p.memory)); },
                                .difference = [](Pair& x, Pair& y) { return x.answer == y.answer ? "" : y.answer; },
                                .go_on = go_on},
                               failures);
    EXPECT_EQ(failures.defects, 0u) << failures.first;
}

}  // namespace
}  // namespace ecods::allocation
