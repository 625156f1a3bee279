#include "fuzz/pairs/solids.hpp"

#include <fmt/format.h>

#include "ecods/error.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "fuzz/pairs/fewer_triangles.hpp"
#include "judge/solid_truth.hpp"
#include "scenes/solid_cases.hpp"

namespace ecods::fuzz {
namespace {

using judge::SolidTruth;
using judge::Wrong;
using scenes::Random;
using scenes::SolidCase;
using scenes::SolidFamily;

class Run : CaseRun {
  public:
    Run(std::uint32_t seed, Lie lie, SolidCounts& counts) : CaseRun(seed, lie, counts.checks), counts_(counts) {}

    // By the oracle.
    void check_one() {
        const auto families = scenes::solid_families();
        const SolidCase made = make(families[index_ % families.size()]);
        require(require_solid("a", *made.a.mesh, made).ask(*made.a.mesh), made, "every form");
        require(require_solid("b", *made.b.mesh, made).ask(*made.b.mesh), made, "every form");
        const Solid a(made.a.mesh), b(made.b.mesh);
        const SolidTruth truth({a, made.a.pose}, {b, made.b.pose}, made.known_points());
        count(truth.relation());
        require_recipe(made, truth);
        if (lie_ && truth.relation() == SolidRelation::touching) {
            require("solid_relation", SolidRelation::apart, truth.relation(), made, "a lie");
        }
        require(truth.ask(memory_), made, "every form");
        if (random_.below(4) == 0) require_in_environment(made, [&] { return truth.ask(memory_); });
        if (random_.below(2) == 0) check_diagonals(made, {a, made.a.pose}, {b, made.b.pose});
        if (random_.below(4) == 0) check_spoilt(made);
        ++index_;
    }

    // By the sets of cells.
    void check_known() {
        const SolidCase made = make(SolidFamily::polycubes);
        // The oracle is asked of few: it takes about ten times as long as the library for all that is asked here.
        if (index_ % 64 == 0 || has_wrong_recipe_) {
            require_solid("a", *made.a.mesh, made);
            require_solid("b", *made.b.mesh, made);
        }
        const Solid a(made.a.mesh), b(made.b.mesh);
        const Posed<Solid> posed_a{a, made.a.pose}, posed_b{b, made.b.pose};
        SolidRelation relation = *made.relation;
        count(relation);
        if (lie_ && relation == SolidRelation::touching) relation = SolidRelation::apart;
        require("solid_relation", relation, solid_relation(posed_a, posed_b, memory_), made, "known by its recipe");
        require("solid_relation of (b, a)", judge::mirrored(relation), solid_relation(posed_b, posed_a, memory_), made);
        for (const scenes::KnownSide& known : made.points) {
            require("locate", known.side, locate(known.point, posed_a, memory_).side, made, "points located");
        }
        ++index_;
    }

  private:
    SolidCase make(SolidFamily family) {
        family_ = scenes::name(family);
        SolidCase made = scenes::make_solid_case(family, random_);
        if (has_wrong_recipe_) made.a.mesh = without_first_triangle(*made.a.mesh);
        return made;
    }
    void require_recipe(const SolidCase& made, const SolidTruth& truth) const {
        if (made.relation) {
            require_known(*made.relation == truth.relation(), written(*made.relation), written(truth.relation()), made);
        }
        for (const scenes::KnownSide& known : made.points) {
            if (!known.point.allFinite()) continue;
            const Side side = judge::to_location(oracle::locate(known.point, soup(made.a))).side;
            require_known(known.side == side, written(known.side), written(side), made);
        }
    }
    static oracle::Soup soup(const scenes::PosedMesh& body) {
        return {body.mesh->vertices(), body.mesh->triangles(), body.pose};
    }
    void count(SolidRelation relation) {
        ++counts_.solids;
        ++counts_.kinds[family_][written(relation)];
    }

    using CaseRun::require;
    template <class T>
    void require(const char* question, const T& expected, const T& got, const SolidCase& made,
                 const char* how = "known by its recipe") const {
        require(expected == got ? std::nullopt : std::optional(Wrong{question, written(expected), written(got)}), made,
                how);
    }

    // Triangles on any corners of the first solid, segments and points among them: through it, in its faces, along its
    // edges, or outside.
    void check_diagonals(const SolidCase& made, const Posed<Solid>& a, const Posed<Solid>& b) {
        const auto vertices = made.a.mesh->vertices();
        std::vector<Triangle> triangles(1 + random_.below(3));
        for (Triangle& t : triangles) {
            for (std::uint32_t& index : t) index = random_.below(static_cast<std::uint32_t>(vertices.size()));
        }
        SolidCase of_surface = made;
        of_surface.a.mesh = Mesh::create({vertices.begin(), vertices.end()}, std::move(triangles));
        const MeshShape shape(of_surface.a.mesh);
        const Posed<MeshShape> surface{shape, made.a.pose};
        for (const Posed<Solid>& solid : {a, b}) {
            of_surface.b = {solid.what->mesh_ptr(), solid.pose};
            const auto expected =
                static_cast<SurfaceRelation>(oracle::surface_relation(soup(of_surface.a), soup(of_surface.b)));
            require("surface_relation", expected, surface_relation(surface, solid, memory_), of_surface,
                    "surfaces on corners of a solid");
        }
    }

    // Without one triangle or with one twice, and both bodies as one mesh.
    void check_spoilt(SolidCase made) {
        const auto triangles = made.a.mesh->triangles();
        std::vector<Vec3> vertices(made.a.mesh->vertices().begin(), made.a.mesh->vertices().end());
        std::vector<Triangle> list(triangles.begin(), triangles.end());
        const std::uint32_t at = random_.below(static_cast<std::uint32_t>(list.size()));
        const std::uint32_t choice = random_.below(3);
        if (choice == 0 && list.size() > 1) list.erase(list.begin() + at);
        if (choice == 1) list.push_back(list[at]);
        if (choice == 2) {
            const auto first = static_cast<std::uint32_t>(vertices.size());
            vertices.insert(vertices.end(), made.b.mesh->vertices().begin(), made.b.mesh->vertices().end());
            for (const Triangle& t : made.b.mesh->triangles())
                list.push_back({t[0] + first, t[1] + first, t[2] + first});
        }
        made.a.mesh = Mesh::create(std::move(vertices), std::move(list));
        require(judge::ask_whether_solid(*made.a.mesh), made, "meshes that bound no solid");
    }

    SolidCounts& counts_;
    QueryMemory memory_;
};

}  // namespace

void run_solids(std::uint32_t seed, Lie lie, SolidCounts& counts) {
    Run run(seed, lie, counts);
    for (std::uint64_t i = 0; i < solids_per_run; ++i) run.check_one();
}

void run_polycubes(std::uint32_t seed, Lie lie, SolidCounts& counts) {
    Run run(seed, lie, counts);
    for (std::uint64_t i = 0; i < polycubes_per_run; ++i) run.check_known();
}

}  // namespace ecods::fuzz
