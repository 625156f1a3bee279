#include <cmath>
#include <utility>
#include <vector>

#include "ecods/error.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "oracle/convex_features.hpp"
#include "oracle/solid_points.hpp"
#include "scenes/lattice_mesh.hpp"

namespace ecods::fuzz {
namespace {

using judge::ConvexTruth;
using judge::Wrong;
using scenes::ConvexCase;
using scenes::PosedMesh;
using Judged = judge::Judged<ConvexCase>;

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;

    void check_one() {
        ConvexCase made = next_family(scenes::convex_families()).make(random_);
        if (has_wrong_recipe_) made.a.mesh = without_triangles(*made.a.mesh, 0, 1);
        require_convex("a", made.a, made);
        require_convex("b", made.b, made);
        const Judged judged(made);
        const ConvexTruth& truth = judged.truth;
        take(made, truth);
        if (lie_ && truth.depth()) {
            fail({"depth", judge::text(judge::neighbour(truth.depth()->depth, 1)), judge::text(*truth.depth())}, made,
                 "a lie");
        }
        require_answers(made, judged, "every form");
        if (random_.below(3) == 0) require_answers_in_environment(made, judged);
        if (random_.below(8) == 0) require(truth.ask_bounds(memory_), made, "depth_bounds");
        if (random_.below(4) == 0) check_translations(made, truth);
        if (random_.below(4) == 0) check_made_elsewhere(made, truth);
        if (random_.below(4) == 0) check_order(made, truth);
        if (random_.below(4) == 0) check_hull(made);
        if (random_.below(4) == 0) check_spoilt(made);
        ++index_;
    }

  private:
    void require_convex(const std::string& body, const PosedMesh& posed, const ConvexCase& made) const {
        const auto features = oracle::convex_features(*posed.mesh);
        require_promise(features.has_value(), body + " is convex", "not convex", made);
        // The oracle is asked of few, as it takes as long as all else; a convex mesh is no solid only if it is open or
        // covers its hull more than once. A polygon has one face.
        if (index_ % 4 == 0 && features->faces.size() > 1) require_solid(body, *posed.mesh, made);
        require_promise(!oracle::is_singular(posed.pose), body + " has a regular pose", "a singular pose", made);
    }

    void check_translations(const ConvexCase& made, const ConvexTruth& truth) {
        std::vector<Vec3> directions;
        for (int i = 0; i < 30; ++i) directions.push_back((1 - std::ldexp(1.0, -3 * i)) * random_.direction());
        if (truth.depth()) {
            for (int i = 1; i < 50; i += 4) directions.push_back((1 - std::ldexp(1.0, -i)) * truth.depth()->direction);
        }
        require(truth.ask_translations(memory_, directions), made, "translations");
    }

    // Solids that are made in another environment are the same.
    void check_made_elsewhere(const ConvexCase& made, const ConvexTruth& truth) {
        require_in_environment(made, [&] {
            const ConvexSolid a(made.a.mesh), b(made.b.mesh);
            return truth.with({a, made.a.pose}, {b, made.b.pose}).ask(memory_, witness_);
        });
    }

    // Triangles and their corners in another order have other names, and the numbers are the same.
    void check_order(const ConvexCase& made, const ConvexTruth& truth) {
        ConvexCase other = made;
        for (PosedMesh* body : {&other.a, &other.b}) {
            std::vector<Vec3> vertices(body->mesh->vertices().begin(), body->mesh->vertices().end());
            std::vector<Triangle> triangles(body->mesh->triangles().begin(), body->mesh->triangles().end());
            scenes::shuffle(vertices, triangles, random_);
            body->mesh = Mesh::create(std::move(vertices), std::move(triangles));
        }
        const Judged judged(other);
        std::optional<Wrong> wrong = judged.truth.ask(memory_, witness_);
        if (!wrong && judged.truth.distance() != truth.distance()) {
            wrong = Wrong{"oracle", judge::text(truth.distance()), judge::text(judged.truth.distance())};
        }
        require(wrong, other, "triangles and corners in another order");
    }

    // Of the vertices of both, some of them twice.
    void check_hull(const ConvexCase& made) {
        std::vector<Vec3> points;
        for (const PosedMesh* body : {&made.a, &made.b}) {
            const auto vertices = body->mesh->vertices();
            for (std::size_t i = 0; i < vertices.size() && i < 10; ++i) points.push_back(vertices[i]);
        }
        for (int i = 0; i < 3; ++i) points.push_back(points[random_.below(static_cast<std::uint32_t>(points.size()))]);
        require(judge::ask_for_hull(points), made, "hulls of points");
    }

    // A vertex is moved: to another, towards the middle, or by one ulp. What is no solid any more is not asked about.
    void check_spoilt(const ConvexCase& made) {
        std::vector<Vec3> vertices(made.a.mesh->vertices().begin(), made.a.mesh->vertices().end());
        const auto triangles = made.a.mesh->triangles();
        const auto any = [&] { return random_.below(static_cast<std::uint32_t>(vertices.size())); };
        Vec3& vertex = vertices[any()];
        const std::uint32_t choice = random_.below(3);
        if (choice == 0) vertex = 0.5 * vertex + 0.5 * vertices[any()];
        if (choice == 1) vertex = 0.75 * vertex;
        if (choice == 2) vertex[random_.below(3)] *= 1 + 0x1p-52;
        const auto mesh = Mesh::create(std::move(vertices), {triangles.begin(), triangles.end()});
        try {
            check_solid(*mesh);
        } catch (const Error&) {
            return;
        }
        require(judge::ask_whether_convex(mesh), made, "whether a mesh is convex");
    }
};

}  // namespace

void run_convex(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 180, &Run::check_one);
}

}  // namespace ecods::fuzz
