#include <algorithm>

#include "fuzz/pairs/case_run.hpp"
#include "judge/text.hpp"

namespace ecods::fuzz {
namespace {

using judge::written;
using scenes::Cells;
using scenes::LatticeMap;
using scenes::LatticePoint;
using scenes::Random;

// The ends of its box, which begins at 0.
LatticePoint size_of(const Cells& cells) {
    LatticePoint size{};
    for (const LatticePoint& cell : cells) {
        for (std::size_t k = 0; k < 3; ++k) size[k] = std::max(size[k], cell[k] + 1);
    }
    return size;
}

// A map whose products with small integers are exact.
LatticeMap integer_map(Random& random) {
    while (true) {
        const LatticeMap map = scenes::random_map(random);
        if (map.M == map.M.array().round().matrix()) return map;
    }
}

class Run : CaseRun {
  public:
    Run(std::uint32_t seed, Lie lie, CaseCounts& counts) : CaseRun(seed, lie, counts) { family_ = "placements"; }

    void check(const Cells& a, const Cells& b) {
        const LatticeMap map = integer_map(random_);
        const auto mesh = [&](const Cells& cells) {
            return scenes::place_at(scenes::boundary(cells, random_.below(2) == 0, random_), Pose{map.M, map.o},
                                    random_);
        };
        scenes::SolidCase made{mesh(a), mesh(b), std::nullopt, {}};
        if (has_wrong_recipe_) made.a.mesh = without_triangles(*made.a.mesh, 0, 1);
        require_solid("a", *made.a.mesh, made);
        require_solid("b", *made.b.mesh, made);
        const Solid solid_a(made.a.mesh), solid_b(made.b.mesh);
        const LatticePoint from = size_of(b), to = size_of(a);
        for (int x = -from[0]; x <= to[0]; ++x) {
            for (int y = -from[1]; y <= to[1]; ++y) {
                for (int z = -from[2]; z <= to[2]; ++z) {
                    made.b.pose.t = map.M * Vec3(x, y, z) + map.o;
                    made.relation = scenes::relation(a, scenes::shifted(b, {x, y, z}));
                    check(made, solid_a, solid_b);
                }
            }
        }
    }

    void check_points(const Cells& cells) {
        const LatticeMap map = integer_map(random_);
        const scenes::PosedMesh body =
            scenes::place_at(scenes::boundary(cells, true, random_), Pose{map.M, map.o}, random_);
        const Solid solid(body.mesh);
        const LatticePoint size = size_of(cells);
        for (int x = -1; x <= 2 * size[0] + 1; ++x) {
            for (int y = -1; y <= 2 * size[1] + 1; ++y) {
                for (int z = -1; z <= 2 * size[2] + 1; ++z) {
                    const Vec3 point = map.M * Vec3(0.5 * x, 0.5 * y, 0.5 * z) + map.o;
                    ++counts_.checks["points located"];
                    require("locate", scenes::side_of({x, y, z}, cells),
                            locate(point, {solid, body.pose}, memory_).side, {body, body, std::nullopt, {}});
                }
            }
        }
    }

  private:
    void check(const scenes::SolidCase& made, const Solid& a, const Solid& b) {
        Relation relation = *made.relation;
        ++counts_.cases;
        ++counts_.kinds[family_][written(relation)];
        ++counts_.checks["known by its recipe"];
        if (lie_ && relation == Relation::touching) relation = Relation::apart;
        const Posed<Solid> posed_a{a, made.a.pose}, posed_b{b, made.b.pose};
        require("relation", relation, ecods::relation(posed_a, posed_b, memory_), made);
        require("relation of (b, a)", judge::mirrored(relation), ecods::relation(posed_b, posed_a, memory_), made);
        ++index_;
    }

    template <class T>
    void require(const char* question, const T& expected, const T& got, const scenes::SolidCase& made) const {
        if (expected != got) fail({question, written(expected), written(got)}, made, "");
    }
};

}  // namespace

void run_placements(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    const std::vector<Cells> all = scenes::polycubes(4);
    const std::size_t own = (seed + all.size() - 1) % all.size();
    Run run(seed, lie, counts);
    run.check_points(all[own]);
    for (std::size_t i = 0; i <= own; ++i) run.check(all[own], all[i]);
}

}  // namespace ecods::fuzz
