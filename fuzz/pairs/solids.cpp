#include "fuzz/pairs/case_run.hpp"
#include "judge/text.hpp"

namespace ecods::fuzz {
namespace {

using judge::written;
using judge::Wrong;
using scenes::SolidCase;

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;

    // By the oracle.
    void check_one() {
        const SolidCase made = make(next_family(scenes::solid_families()));
        require(require_solid("a", *made.a.mesh, made).ask(*made.a.mesh), made, "every form");
        require(require_solid("b", *made.b.mesh, made).ask(*made.b.mesh), made, "every form");
        const judge::Judged<SolidCase> judged(made);
        take(made, judged.truth);
        if (lie_ && judged.truth.relation() == Relation::touching) {
            require("relation", Relation::apart, judged.truth.relation(), made, "a lie");
        }
        require_answers(made, judged, "every form");
        if (random_.below(4) == 0) require_answers_in_environment(made, judged);
        if (random_.below(2) == 0) check_diagonals(made, {judged.a, made.a.pose}, {judged.b, made.b.pose});
        if (random_.below(4) == 0) check_spoilt(made);
        ++index_;
    }

    // By the sets of cells.
    void check_known() {
        const auto& polycubes = scenes::family_named(scenes::solid_families(), "polycubes");
        family_ = polycubes.name;
        const SolidCase made = make(polycubes);
        // The oracle is asked of few: it takes about ten times as long as the library for all that is asked here.
        if (index_ % 64 == 0 || has_wrong_recipe_) {
            require_solid("a", *made.a.mesh, made);
            require_solid("b", *made.b.mesh, made);
        }
        const Solid a(made.a.mesh), b(made.b.mesh);
        const Posed<Solid> posed_a{a, made.a.pose}, posed_b{b, made.b.pose};
        Relation relation = *made.relation;
        ++counts_.cases;
        ++counts_.kinds[family_][written(relation)];
        if (lie_ && relation == Relation::touching) relation = Relation::apart;
        require("relation", relation, ecods::relation(posed_a, posed_b, memory_), made, "known by its recipe");
        require("relation of (b, a)", judge::mirrored(relation), ecods::relation(posed_b, posed_a, memory_), made);
        for (const scenes::KnownSide& known : made.points) {
            require("locate", known.side, locate(known.point, posed_a, memory_).side, made, "points located");
        }
        ++index_;
    }

  private:
    SolidCase make(const scenes::Family<SolidCase>& family) {
        SolidCase made = family.make(random_);
        if (has_wrong_recipe_) made.a.mesh = without_triangles(*made.a.mesh, 0, 1);
        return made;
    }
    static oracle::Soup soup(const scenes::PosedMesh& body) {
        return {body.mesh->vertices(), body.mesh->triangles(), body.pose};
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
            const auto expected = oracle::surface_relation(soup(of_surface.a), soup(of_surface.b));
            require("surface_relation", expected, ecods::relation(surface, solid, memory_), of_surface,
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
};

}  // namespace

void run_solids(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 130, &Run::check_one);
}

void run_polycubes(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 1000, &Run::check_known);
}

}  // namespace ecods::fuzz
