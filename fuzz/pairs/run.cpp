#include <limits>
#include <vector>

#include "fuzz/pairs/ask.hpp"
#include "fuzz/pairs/case_run.hpp"
#include "fuzz/pairs/variants.hpp"
#include "judge/text.hpp"
#include "oracle/oracle.hpp"

namespace ecods::fuzz {
namespace {

using judge::written;
using scenes::PosedPair;
using HardFamily = scenes::Family<PosedPair>;

Relation ask_oracle(const PosedPair& pair) {
    return oracle::triangle_triangle(pair.pose_a, pair.a, pair.pose_b, pair.b);
}

class Run : CaseRun {
  public:
    using CaseRun::CaseRun;
    ~Run() {
        const StageCounts& own = bodies_.counts();
        counts_.stages["triangle tests"] += own.triangle_tests;
        for (const Stage& stage : stages) counts_.stages[stage.name] += own.*stage.count;
    }
    Run(const Run&) = delete;
    Run& operator=(const Run&) = delete;

    void check_one() {
        const HardFamily& family = next_family(scenes::hard_families());
        const PosedPair pair = family.make(random_);
        Relation expected = ask_oracle(pair);
        if (pair.intersects) {
            const bool promised = *pair.intersects != has_wrong_recipe_;
            require_promise(promised == (expected != Relation::apart), promised ? "touching or crossing" : "apart",
                            written(expected), pair);
            ++counts_.checks["known by its recipe"];
        }
        ++counts_.cases;
        ++counts_.kinds[family_][written(expected)];
        if (lie_ && expected == Relation::touching) expected = Relation::crossing;

        require_all_paths(pair, expected, float_modes[0], "as made");
        if (random_.below(4) == 0) check_modes(pair, expected);
        if (random_.below(2) == 0) check_variants(pair, expected);
        if (random_.below(32) == 0) check_orders(pair, expected);
        if (random_.below(32) == 0) check_meshes(family, pair);
        ++index_;
    }

  private:
    void require(const Answer& answer, const PosedPair& pair, Relation expected, const char* how) const {
        if (answer.path != nullptr) fail({answer.path, written(expected), written(answer.relation)}, pair, how);
    }
    void require_all_paths(const PosedPair& pair, Relation expected, const FloatMode& mode, const char* how) {
        ++counts_.checks[how];
        require(ask_all_paths(pair, expected, mode, bodies_), pair, expected, how);
    }

    void check_modes(const PosedPair& pair, Relation expected) {
        const std::uint32_t mode = 1 + random_.below(float_modes.size() - 1);
        require_all_paths(pair, expected, float_modes[mode], float_modes[mode].name);
    }

    // One variant of the pair, and then one of that.
    void check_variants(PosedPair pair, Relation expected) {
        for (int i = 0; i < 2; ++i) {
            const Variant& variant = variants()[random_.below(static_cast<std::uint32_t>(variants().size()))];
            if (variant.apply(pair, random_)) require_all_paths(pair, expected, float_modes[0], variant.name);
        }
    }

    void check_orders(const PosedPair& pair, Relation expected) {
        ++counts_.checks["all orders of corners and arguments"];
        require(ask_all_orders(pair, expected), pair, expected, "all orders");
    }

    // Corners of this pair and another of its family, joined to a few triangles at random: degenerate ones among them,
    // and ones that share corners. `stride` spreads the vertices, with unused ones between them.
    std::shared_ptr<const Mesh> make_mesh(const std::array<Vec3, 3>& own, const std::array<Vec3, 3>& other,
                                          std::uint32_t stride, std::uint32_t triangle_count) {
        constexpr double unused = std::numeric_limits<double>::max();
        std::vector<Vec3> vertices(5 * stride + 1, Vec3(unused, -unused, unused));
        for (std::uint32_t i = 0; i < 3; ++i) {
            vertices[i * stride] = own[i];
            vertices[(3 + i) * stride] = other[i];
        }
        std::vector<Triangle> triangles{{0, stride, 2 * stride}};
        for (std::uint32_t i = 1; i < triangle_count; ++i) {
            triangles.push_back({random_.below(6) * stride, random_.below(6) * stride, random_.below(6) * stride});
        }
        return Mesh::create(std::move(vertices), std::move(triangles));
    }

    // The relations of triangle i of mesh a with j of mesh b, at i * count + j.
    std::vector<Relation> ask_meshes(const MeshPair& meshes, const BoundMeshes& bound, const FloatMode& mode,
                                     bool is_swapped) {
        const InFloatMode in_mode(mode);
        const auto count = static_cast<std::uint32_t>(meshes.a->triangles().size());
        std::vector<Relation> relations(count * count);
        bound.bind(bodies_, meshes, is_swapped);
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::uint32_t j = 0; j < count; ++j) {
                relations[i * count + j] = is_swapped ? bodies_.relation(j, i) : bodies_.relation(i, j);
            }
        }
        return relations;
    }

    void check_meshes(const HardFamily& family, PosedPair pair) {
        // In the other frame the two poses are not the same bits, and no shortcut decides.
        if (random_.below(2) == 0) model_in_other_frames(pair, random_);
        const PosedPair more = family.make(random_);
        // Vertices 1024 apart have one place in the caches.
        const std::uint32_t count = 1 + random_.below(10);
        const std::uint32_t stride = random_.below(2) == 0 ? 1 : 1024;
        const MeshPair meshes{make_mesh(pair.a, more.a, stride, count), make_mesh(pair.b, more.b, stride, count),
                              pair.pose_a, pair.pose_b};
        std::vector<Relation> expected;
        for (std::uint32_t i = 0; i < count; ++i) {
            for (std::uint32_t j = 0; j < count; ++j) expected.push_back(ask_oracle(triangle_pair_of(meshes, i, j)));
        }
        const BoundMeshes bound(meshes);
        const FloatMode& mode = float_modes[random_.below(float_modes.size())];
        for (const bool is_swapped : {false, true}) {
            const std::vector<Relation> relations = ask_meshes(meshes, bound, mode, is_swapped);
            for (std::uint32_t i = 0; i < count * count; ++i) {
                if (relations[i] == expected[i]) continue;
                fail({std::string("TriangleRelations, triangles of larger meshes, ") + mode.name, written(expected[i]),
                      written(relations[i])},
                     triangle_pair_of(meshes, i / count, i % count), "");
            }
        }
        counts_.checks["triangle pairs of larger meshes"] += count * count;
    }

    TriangleRelations bodies_;
};

}  // namespace

void run_pairs(std::uint32_t seed, Lie lie, CaseCounts& counts) {
    check_cases(seed, lie, counts, 1000, &Run::check_one);
}

}  // namespace ecods::fuzz
