#include "fuzz/engines/families.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "fuzz/engines/boxes.hpp"
#include "scenes/fitted_parts.hpp"
#include "scenes/hard_pairs.hpp"
#include "scenes/ship.hpp"

namespace ecods::fuzz {
namespace {

using scenes::MeshPairs;

// Families of triangles whose poses are rigid up to rounding; each triangle becomes a mesh,
// which has it twice: there are libraries that crash on a mesh of one.
constexpr std::array rigid_families = {
    "generic",           "lattice",         "lattice, one ulp", "coplanar",
    "edge on edge",      "vertex on face",  "vertex near face", "permutation matrices",
    "short coordinates", "far from origin", "slivers"};

MeshPairs triangle_pairs(const char* family, std::size_t count, std::uint32_t seed) {
    MeshPairs pairs;
    scenes::Random random(seed);
    for (std::size_t i = 0; i < count; ++i) {
        const scenes::PosedPair pair = scenes::family_named(scenes::hard_families(), family).make(random);
        for (const auto& triangle : {pair.a, pair.b}) {
            pairs.meshes.push_back(
                {"triangle", Mesh::create({triangle.begin(), triangle.end()}, {{0, 1, 2}, {0, 1, 2}})});
        }
        pairs.queries.push_back({{2 * i, pair.pose_a}, {2 * i + 1, pair.pose_b}});
    }
    return pairs;
}

EngineFamily boxes(std::string name, std::string what, const BoxRecipe& recipe) {
    return {std::move(name), std::move(what),
            [recipe](std::size_t count, std::uint32_t seed) { return box_pairs(recipe, count, seed); }};
}

EngineFamily gaps(double gap, const std::string& text) {
    return {"ships, gap " + text, "two ships of 430 triangles, apart or into each other by that many radii",
            [gap](std::size_t count, std::uint32_t seed) {
                return scenes::gap_pairs("ship", scenes::ship(), gap, count, seed);
            }};
}

std::vector<EngineFamily> make_families() {
    std::vector<EngineFamily> families;
    families.push_back({"ships, anywhere", "two ships in random rotations, their balls overlapping",
                        [](std::size_t count, std::uint32_t seed) {
                            return scenes::random_pairs("ship", scenes::ship(), count, seed);
                        }});
    families.push_back(gaps(0x1p-20, "2^-20"));
    families.push_back(gaps(0x1p-30, "2^-30"));
    families.push_back(gaps(0x1p-52, "2^-52"));
    families.push_back(boxes("boxes, axis-aligned", "short coordinates; face, edge or corner in exact contact", {}));
    families.push_back(boxes("boxes, 45 bits", "the same with sizes of 45 bits, each body under a signed permutation",
                             {.bits = 45, .turn = BoxTurn::permutations}));
    families.push_back(boxes("boxes, one rotation", "in exact contact in one common rotated pose",
                             {.bits = 10, .turn = BoxTurn::common_rotation}));
    families.push_back(
        boxes("boxes, one ulp", "axis-aligned, one coordinate of the contact an ulp off", {.bits = 20, .ulps = 1}));
    families.push_back(boxes("boxes, one rotation, one ulp", "in one rotated pose, one coordinate an ulp off",
                             {.bits = 20, .turn = BoxTurn::common_rotation, .ulps = 1}));
    families.push_back(boxes("boxes, far away", "in exact contact in one rotated pose, 1 to 2^40 from the origin",
                             {.bits = 10, .turn = BoxTurn::common_rotation, .far_exponent_max = 40}));
    families.push_back(boxes("plates", "boxes in exact contact, one size 2^-10 to 2^-40 of the others",
                             {.bits = 10, .turn = BoxTurn::common_rotation, .thin_exponent_max = 40}));
    families.push_back({"bricks", "192 triangles each, in a wall; face on face, or parted by 2^-20",
                        [](std::size_t count, std::uint32_t seed) { return scenes::stacked_bricks(count, seed); }});
    // Their oracle costs as much as all else.
    families.push_back({"shafts in hubs", "1,536 triangles each, all flanks in contact, or none",
                        [](std::size_t count, std::uint32_t seed) {
                            return scenes::splined_shafts(std::min<std::size_t>(count, 20), seed);
                        }});
    for (const char* const family : rigid_families) {
        families.push_back(
            {"triangles, " + std::string(family), "one triangle a mesh, twice",
             [family](std::size_t count, std::uint32_t seed) { return triangle_pairs(family, count, seed); }});
    }
    return families;
}

}  // namespace

const std::vector<EngineFamily>& engine_families() {
    static const std::vector<EngineFamily> families = make_families();
    return families;
}

}  // namespace ecods::fuzz
