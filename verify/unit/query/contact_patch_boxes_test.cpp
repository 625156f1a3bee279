// Contact patches of boxes that are tilted a little against each other, with as many corners as a physics engine
// expects; and of prisms, of whose many corners few are kept.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

#include "ecods/contact.hpp"
#include "ecods/solid.hpp"
#include "unit/query/solid_soup.hpp"

namespace ecods {
namespace {

// The boxes of MuJoCo's tests of multiple contacts (test/engine/engine_collision_gjk_test.cc: BoxBoxMultiCCD to 15,
// BoxEdge2 and BoxEdgeEdge), with fewer digits: many are tilted by 1e-5 to 1e-3, so that support features are vertices
// and edges. As many points as MuJoCo expects face each other within a tilt of half a degree, and do not part the
// boxes.
struct Box {
    Vec3 half, t;
    std::array<double, 9> R;  // row by row
};
struct Case {
    std::size_t corners;
    Box a, b;
};
// clang-format off
const std::vector<Case> first_cases{
    {4, {{1, 1, 1}, {0, 0, 1.9},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}},
        {{10, 10, 1}, {0, 0, 0},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}}},
    {4, {{1, 1, 1}, {9.5, 9.5, 1.9},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}},
        {{10, 10, 1}, {0, 0, 0},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}}},
    {4, {{5, 5, 0.1}, {0, 0, 0},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}},
        {{1, 1, 1}, {-0.941218619, 2.20972901, 1.0954567},
        {0.99999981, -1.4738591e-05, 0.00062185365, -0.00062185343, 1.4756879e-05, 0.99999981,
         -1.4747764e-05, -1, 1.474771e-05}}},
    {8, {{0.25, 0.25, 0.05}, {-0.0153467189, -0.0235004488, -4.85938272},
        {0.50006325, -0.86598889, -1.503629e-05, 0.86598889, 0.50006325, 9.5410644e-06,
         -7.4335951e-07, -1.7792396e-05, 1}},
        {{0.25, 0.25, 0.05}, {-0.0153477497, -0.0235006013, -4.95878285},
        {1, -3.3207421e-05, -4.4925527e-08, 3.3207421e-05, 1, 6.4145865e-07, 4.4904226e-08, -6.4146014e-07, 1}}},
    {8, {{0.25, 0.25, 0.05}, {-0.0153815245, -0.0235279319, -4.559214},
        {0.96595505, -0.2587099, -0.00019635881, 0.25870992, 0.96595506, 9.0476786e-05,
         0.00016626655, -0.00013819648, 0.99999998}},
        {{0.25, 0.25, 0.05}, {-0.0153586686, -0.0235420705, -4.65910835},
        {0.86607654, -0.49991139, -0.00019065875, 0.49991141, 0.86607654, 8.6494189e-05,
         0.00012188564, -0.00017022307, 0.99999998}}},
    {2, {{0.5, 0.5, 0.1}, {0, 0, -0.1},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}},
        {{0.1, 0.1, 0.1}, {0.413029898, 0.190777715, 0.100006658},
        {-0.41261753, -0.91090394, -0.00088793068, 0.91090437, -0.41261728, -0.00046014398,
         5.2771424e-05, -0.0009986834, 0.9999995}}},
    {5, {{0.25, 0.25, 0.05}, {-0.00202074025, -0.0226543848, -4.8585429},
        {0.48285193, -0.87569746, 0.0028233411, 0.87570108, 0.4828536, -0.00010226999,
         -0.0012737028, 0.0025217841, 0.99999601}},
        {{0.25, 0.25, 0.05}, {-0.011066235, -0.023114696, -4.95837581},
        {0.99998513, -0.0052938453, 0.0013066639, 0.0052938711, 0.99998599, -1.6319793e-05,
         -0.0013065592, 2.3236861e-05, 0.99999915}}},
    {4, {{0.25, 0.25, 0.05}, {-0.0153465, -0.0235055, -4.85966264},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}},
        {{0.25, 0.25, 0.05}, {-0.0153465, -0.0235055, -4.95857429},
        {1, 0, 0, 0, 1, -1.536194e-17, 0, 1.536194e-17, 1}}},
};
const std::vector<Case> more_cases{
    {4, {{0.025, 0.025, 0.025}, {-0.10714, -0.19286, 0.174995152},
        {1, -5.0579e-36, 1.9277154e-19, 5.6403e-36, 1, -3.0208515e-18, -1.9277154e-19, 3.0208515e-18, 1}},
        {{0.025, 0.025, 0.025}, {-0.10714, -0.19286, 0.215625919},
        {1, 3.7070001e-33, -6.4957875e-17, 6.4174485e-33, 1, 1.5586176e-16, 6.4957875e-17, -1.5586176e-16, 1}}},
    {4, {{0.025, 0.025, 0.025}, {-0.103486, -0.076514, 0.125762875},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}},
        {{0.025, 0.025, 0.025}, {-0.103486, -0.076514, 0.17514},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}}},
    {4, {{0.025, 0.025, 0.025}, {-0.103655, -0.196345, 0.124768504},
        {1, 0, 0, 0, 1, -1.3928437e-18, 0, 1.3928437e-18, 1}},
        {{0.025, 0.025, 0.025}, {-0.103655, -0.196345, 0.17452485},
        {1, 0, 0, 0, 1, -1.8885268e-18, 0, 1.8885268e-18, 1}}},
    {4, {{0.025, 0.025, 0.025}, {0.01643, -0.07643, 0.125270689},
        {1, 0, 0, 0, 1, -3.2154383e-18, 0, 3.2154383e-18, 1}},
        {{0.025, 0.025, 0.025}, {0.01643, -0.07643, 0.174837425},
        {1, 0, 0, 0, 1, -1.8997602e-18, 0, 1.8997602e-18, 1}}},
    {4, {{0.02, 0.02, 0.02}, {-0.1, -0.2, -0.0809921811},
        {1, -1.3661928e-31, -2.4512354e-16, 1.3667079e-31, 1, 2.1010473e-19, 2.4512354e-16, -2.1010473e-19, 1}},
        {{0.02, 0.02, 0.02}, {-0.1, -0.2, -0.0418396695},
        {1, -7.4032723e-32, -2.5572597e-16, 7.7542882e-32, 1, 1.3726253e-17, 2.5572597e-16, -1.3726253e-17, 1}}},
    {2, {{0.02, 0.02, 0.02}, {0.000205125713, 5.17931574e-06, -0.0800031939},
        {1, 1.7910915e-05, -6.0138947e-05, -1.7910869e-05, 1, 7.7168717e-07, 6.0138961e-05, -7.7061003e-07, 1}},
        {{0.02, 0.02, 0.02}, {0.000214511103, -5.13389998e-06, -0.040005901},
        {0.99999996, -1.8681857e-05, -0.00027995573, 1.8685325e-05, 1, 1.2385871e-05,
         0.0002799555, -1.2391102e-05, 0.99999996}}},
    {4, {{0.5, 0.5, 0.1}, {0, 0, 0},
        {1, 0, 0, 0, 1, 0, 0, 0, 1}},
        {{0.025, 0.025, 0.025}, {0.0520339832, -0.0520339832, 0.124986477},
        {1, 1.6242376e-10, -1.7350005e-05, 1.4424111e-10, 1, 1.7675204e-05, 1.7350005e-05, -1.7675204e-05, 1}}},
    {2, {{1, 1, 1}, {0.000557860298, 0.00986459501, 1.10375969},
        {0.99999797, -0.0017789363, -0.00094578356, 0.0017817418, 0.99999399, 0.0029737702,
         0.00094048773, -0.0029754493, 0.99999513}},
        {{1, 1, 1}, {-0.0218119359, 0.982885195, 3.09300773},
        {0.00067374755, -0.009560369, 0.99995407, -0.10956581, 0.99393341, 0.0095766296,
         -0.99397931, -0.10956723, -0.0003778294}}},
    {2, {{0.15, 1, 3}, {-1.32412981, 7.14899336e-19, 2.81415262},
        {0.91827792, -3.6426856e-20, 0.39593643, -5.9132158e-20, 1, 2.2914439e-19,
         -0.39593643, -2.3383081e-19, 0.91827792}},
        {{0.15, 1, 3}, {1.32412981, -8.67960651e-19, 2.81415262},
        {0.91827792, 7.2839814e-20, -0.39593643, -1.6740603e-19, 1, -2.0428897e-19,
         0.39593643, 2.5387619e-19, 0.91827792}}},
};
// clang-format on

void expect_corners(const std::vector<Case>& cases) {
    for (std::size_t i = 0; i < cases.size(); ++i) {
        SCOPED_TRACE(i);
        std::vector<std::shared_ptr<const ConvexSolid>> solids;
        std::array<Pose, 2> poses;
        for (std::size_t k = 0; k < 2; ++k) {
            const Box& made = k == 0 ? cases[i].a : cases[i].b;
            solids.push_back(std::make_shared<ConvexSolid>(box(-made.half, made.half)));
            for (std::size_t j = 0; j < 9; ++j)
                poses[k].R(static_cast<int>(j / 3), static_cast<int>(j % 3)) = made.R[j];
            poses[k].t = made.t;
        }
        const PatchLimits limits{.min_cos_squared = 0.9999, .max_gap = 0};
        const ContactPatch patch = contact_patch({*solids[0], poses[0]}, {*solids[1], poses[1]}, limits);
        EXPECT_EQ(patch.corners.size(), cases[i].corners);
        EXPECT_LT(patch.distance, 0);
        const ContactPatch back = contact_patch({*solids[1], poses[1]}, {*solids[0], poses[0]}, limits);
        EXPECT_EQ(back.corners.size(), cases[i].corners);
    }
}

TEST(ContactPatch, OfBoxesOfMuJoCo) {
    expect_corners(first_cases);
    expect_corners(more_cases);
}

// Every choice of a few corners has the greatest area, also where turned poses make all denominators differ; rotations
// by a quarter are exact, so the choice is that of the straight pose.
TEST(ContactPatchPrisms, OfAtMostSomeOfManyCorners) {
    const auto prism = [](double turn) {
        std::vector<Vec3> points;
        for (int i = 0; i < 12; ++i) {
            const double angle = turn + std::numbers::pi * i / 6;
            for (const double z : {0.0, 1.0}) points.push_back({std::cos(angle), std::sin(angle), z});
        }
        return ConvexSolid(points);
    };
    const ConvexSolid first = prism(0.125), second = prism(0.375);
    Pose quarter;
    quarter.R << 0, 0, 1, 1, 0, 0, 0, 1, 0;
    const auto on_top = [](Pose pose) {
        pose.t = pose.R * Vec3(0.0625, 0, 0.96875);
        return pose;
    };
    for (const std::uint32_t most : {3U, 4U, 7U, 12U}) {
        const ContactPatch straight = contact_patch({first, Pose()}, {second, on_top(Pose())}, {.max_corners = most});
        const ContactPatch turned = contact_patch({first, quarter}, {second, on_top(quarter)}, {.max_corners = most});
        ASSERT_EQ(straight.corners.size(), most);
        ASSERT_EQ(turned.corners.size(), most);
        EXPECT_GT(straight.corner_count, most);
        for (std::size_t i = 0; i < most; ++i) {
            EXPECT_EQ(turned.corners[i].point_a, quarter.R * straight.corners[i].point_a);
        }
    }
}

}  // namespace
}  // namespace ecods
