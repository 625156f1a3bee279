// No unit is preferred: the same scene 2^e times as large takes about as much work, by count.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "ecods/cast.hpp"
#include "ecods/distance.hpp"
#include "ecods/hit.hpp"
#include "ecods/intersection.hpp"
#include "ecods/world.hpp"
#include "environment/each_environment.hpp"
#include "scenes/random.hpp"
#include "scenes/shapes.hpp"

namespace ecods::scale_counts_test {
namespace {

// Coordinates have few digits, so that none is lost where they are subnormal.
Vec3 rounded(const Vec3& v) {
    return (v * 0x1p9).array().round().matrix() * 0x1p-9;
}
Vec3 scaled(const Vec3& v, int e) {
    return {std::ldexp(v[0], e), std::ldexp(v[1], e), std::ldexp(v[2], e)};
}
std::shared_ptr<const Mesh> scaled(const Mesh& mesh, int e) {
    return scenes::mapped(mesh, [e](const Vec3& v) { return scaled(rounded(v), e); });
}

// Turned bodies, near each other and farther off, some of which meet, and ways and segments for them.
struct Scene {
    struct Body {
        std::shared_ptr<const Mesh> mesh;
        Pose from, to;
        Vec3 motion = Vec3::Zero();  // from one to the other
    };
    std::vector<Body> bodies;
    std::vector<Segment> segments;

    Scene(const Mesh& mesh, std::size_t count, int e) {
        scenes::Random random(11);
        const auto own = scaled(mesh, e);
        const auto point = [&](double size) {
            return rounded(size * Vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)));
        };
        for (std::size_t i = 0; i < count; ++i) {
            Body& body = bodies.emplace_back(Body{own, {}, {}});
            body.from.R = body.to.R = random.rotation().toRotationMatrix();
            if (i % 2 == 0) body.to.R = random.rotation().toRotationMatrix();
            body.from.t = scaled(point(4), e);
            body.to.t = scaled(point(4), e);
            body.motion = body.to.t - body.from.t;
            segments.push_back({scaled(point(5), e), scaled(point(5), e)});
        }
    }
};

struct Work {
    std::uint64_t exact, enclosures, tests;

    explicit Work(const QueryCounts& c)
        : exact(c.stages.one_limb + c.stages.two_limbs + c.stages.many_limbs + c.distances.exact + c.hits.exact +
                c.casts.exact),
          enclosures(c.distances.enclosures + c.hits.enclosures + c.casts.enclosures),
          tests(c.box_tests + c.stages.triangle_tests + c.distances.triangle_bounds + c.hits.triangle_tests) {}
};

std::ostream& operator<<(std::ostream& out, const Work& work) {
    return out << work.exact << " exact, " << work.enclosures << " enclosures, " << work.tests << " tests";
}

struct Question {
    const char* name;
    bool holds_everywhere;
    std::function<void(const Scene& scene, QueryMemory& memory)> ask;
};

// Calls `ask` for all pairs of bodies.
template <class Ask>
auto of_pairs(Ask ask) {
    return [ask](const Scene& scene, QueryMemory& memory) {
        const MeshShape shape(scene.bodies.front().mesh);
        for (const auto& a : scene.bodies) {
            for (const auto& b : scene.bodies) {
                if (&a < &b) ask(shape, a, b, memory);
            }
        }
    };
}

template <class Ask>
auto of_a_world(Ask ask) {
    return [ask](const Scene& scene, QueryMemory& memory) {
        World world;
        std::vector<BodyId> ids;
        for (const auto& body : scene.bodies) ids.push_back(world.create_body(body.mesh, body.from));
        ask(world, ids, scene, memory);
    };
}

using Body = Scene::Body;

const std::vector<Question>& questions() {
    static const std::vector<Question> all{
        {"intersects", true, of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = intersects({shape, a.from}, {shape, b.from}, memory);
         })},
        {"relation", true, of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = relation({shape, a.from}, {shape, b.from}, memory);
         })},
        {"intersecting triangles", true,
         of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = intersecting_triangles({shape, a.from}, {shape, b.from}, memory);
         })},
        {"distance", false, of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = distance({shape, a.from}, {shape, b.from}, memory);
         })},
        {"closest", false, of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = closest({shape, a.from}, {shape, b.from}, memory);
         })},
        {"within", false, of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = within({shape, a.from}, {shape, b.from},
                                  shape.mesh().vertices().front().cwiseAbs().maxCoeff(), memory);
         })},
        {"cast", true, of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = cast({shape, a.from}, b.motion, {shape, b.from}, 1, memory);
         })},
        {"cast between poses", true,
         of_pairs([](const MeshShape& shape, const Body& a, const Body& b, QueryMemory& memory) {
             std::ignore = cast({shape, a.from, a.to}, {shape, b.from, b.to}, 1, memory);
         })},
        {"first hit", false,
         [](const Scene& scene, QueryMemory& memory) {
             const MeshShape shape(scene.bodies.front().mesh);
             for (const auto& body : scene.bodies) {
                 for (const Segment& segment : scene.segments)
                     std::ignore = first_hit(segment, {shape, body.from}, memory);
             }
         }},
        {"all hits of rays", false,
         [](const Scene& scene, QueryMemory& memory) {
             const MeshShape shape(scene.bodies.front().mesh);
             for (const auto& body : scene.bodies) {
                 for (const Segment& s : scene.segments)
                     std::ignore = all_hits(Ray{s.a, s.b}, {shape, body.from}, memory);
             }
         }},
        {"meetings", true,
         of_a_world([](World& world, const std::vector<BodyId>& ids, const Scene& scene, QueryMemory& m) {
             std::vector<Pose> to;
             for (const auto& body : scene.bodies) to.push_back(body.to);
             std::ignore = std::as_const(world).meetings(ids, to, m);
         })},
        {"closest pair", false, of_a_world([](World& world, const std::vector<BodyId>&, const Scene&, QueryMemory& m) {
             std::ignore = std::as_const(world).closest_pair(World::no_limit, m);
         })},
    };
    return all;
}

// Some counts hold at every scale, and some where frames of meshes do (bounds/local_frame.hpp).
TEST(ScaleCounts, NoUnitIsPreferred) {
    const auto expect_near = [](std::uint64_t count, std::uint64_t usual) {
        return count <= 4 * usual + 8 && usual <= 4 * count + 8;
    };
    for (const Question& question : questions()) {
        QueryMemory usual_memory;
        question.ask(Scene(*scenes::cube(1), 12, 0), usual_memory);
        const Work usual(usual_memory.counts());
        for (const int e : {-1060, -1000, -960, -900, -700, -500, -300, 300, 500, 700, 900, 960}) {
            if (!question.holds_everywhere && std::abs(e) > 700) continue;
            QueryMemory memory;
            question.ask(Scene(*scenes::cube(1), 12, e), memory);
            const Work work(memory.counts());
            EXPECT_TRUE(expect_near(work.exact, usual.exact) && expect_near(work.enclosures, usual.enclosures) &&
                        expect_near(work.tests, usual.tests))
                << question.name << ", times 2^" << e << ": " << work << ", usually " << usual;
        }
    }
}

// Casts of a body that is turned, in every environment: the same times, features and triangles at every scale.
TEST(ScaleCounts, AnswersAreThoseOfTheUsualScale) {
    const auto ask = [](const Scene& scene) {
        const MeshShape shape(scene.bodies.front().mesh);
        QueryMemory memory;
        std::vector<std::optional<FirstContact>> contacts;
        std::vector<TrianglePair> pairs;
        for (const Body& a : scene.bodies) {
            for (const Body& b : scene.bodies) {
                contacts.push_back(cast({shape, a.from, a.to}, {shape, b.from, b.to}, 1, memory));
                contacts.push_back(cast({shape, a.from}, a.motion, {shape, b.from}, 1, memory));
                for (const TrianglePair& pair : intersecting_triangles({shape, a.from}, {shape, b.to}, memory)) {
                    pairs.push_back(pair);
                }
                EXPECT_EQ(intersects({shape, a.from}, {shape, b.to}, memory),
                          relation({shape, a.from}, {shape, b.to}, memory) != Relation::apart);
            }
        }
        return std::pair(contacts, pairs);
    };
    const auto usual = ask(Scene(*scenes::cube(1), 4, 0));
    EXPECT_GT(usual.second.size(), 10u);
    for (const int e : {-1060, -250, 960}) {
        const Scene scene(*scenes::cube(1), 4, e);
        environment::in_each_environment([&] { return ask(scene); },
                                         [&](const auto& answers, const std::string& where) {
                                             EXPECT_TRUE(answers == usual) << where << ", times 2^" << e;
                                         });
    }
}

}  // namespace
}  // namespace ecods::scale_counts_test
