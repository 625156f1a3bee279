// Signed distances of boxes and prisms (FCL, test/test_fcl_signed_distance.cpp), depths of boxes
// (test_fcl_box_box.cpp).
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "foreign/shapes.hpp"
#include "foreign/sources.hpp"

namespace ecods::foreign::fcl_boxes {
namespace {

// Two boxes by their sides and the first three rows of their matrices.
struct Boxes {
    Vec3 sides_a;
    std::array<double, 12> a;
    Vec3 sides_b;
    std::array<double, 12> b;
};

// Scenes of the field: issues 388, 395, 415, 398, 428, and 21673 of Drake.
const Boxes scenes[] = {
    {{0.03, 0.12, 0.1},
     {-3.0627937852578681533e-08, -0.99999999999999888978, -2.8893865161583314238e-08, 0.63499979627350811029,
      0.9999999999999980016, -3.0627939739957803544e-08, 6.4729926918527511769e-08, -0.48500002215636439651,
      -6.4729927722963847085e-08, -2.8893863029448751323e-08, 0.99999999999999711342, 1.0778146458339641356},
     {0.025, 0.35, 1.845},
     {0, -1, 0, 0.8, 1, 0, 0, -0.4575, 0, 0, 1, 1.0225}},
    {{0.46, 0.48, 0.01},
     {1, 0, 0, -0.721, 0, 1, 0, -0.772, 0, 0, 1, 0.81},
     {0.049521, 0.146, 0.0725},
     {0.10758262492983036718, -0.6624881850015212903, -0.74130653817877356637, -0.42677133002999478872,
      0.22682184885125472595, -0.709614040775253474, 0.6670830248314786326, -0.76596851247746788882,
      -0.96797615037608542021, -0.23991106241273435495, 0.07392465377049164954, 0.80746731400091054098}},
    {{0.49, 0.05, 0.21},
     {4.8966386501092529215e-12, -1, 0, -0.44, 1, 4.8966386501092529215e-12, 0, -0.61499999999858001587, 0, 0, 1,
      0.355},
     {0.035, 0.12, 0.03},
     {0.83512153565236335595, -0.55006546945762568868, -9.4542360608233572896e-16, -0.40653441507331000704,
      0.55006546945762568868, 0.83512153565236313391, 1.1787444236552387666e-15, -0.69166166923735727945,
      1.2902271444330665572e-16, -1.4878153530113264589e-15, 1, 0.43057093858718892276}},
    {{0.614, 3, 0.37},
     {1, 0, 0, -0.675, 0, 1, 0, 0, 0, 0, 1, 0.9115},
     {0.494, 0.552, 0.01},
     {1, 0, 0, -0.692, 0, 1, 0, 0, 0, 0, 1, 0.935}},
    {{0.2, 0.33, 0.1},
     {1, 0, 0, -0.071000000000000035305, 0, 1, 0, -0.772, 0, 0, 1, 0.79999999999999993339},
     {0.452, 0.27, 0.6},
     {1, 0, 0, 0.121, 0, 1, 0, -0.78769605692727695523, 0, 0, 1, 0.53422044196125151316}},
    {{0.3165, 0.2276, 0.1768},
     {0.44540578475530234748, 0.89532881496493399442, -8.8937407685638678971e-09, 1.2652949075960071568,
      -0.89532881496493377238, 0.44540578475530190339, -2.8948680226084145336e-08, 1.4551012423210101243,
      -2.1957263975186326105e-08, 2.0856732016652919226e-08, 0.99999999999999955591, 0.49480006232932938204},
     {0.4943, 0.3546, 0.0752},
     {0.44171122913485860728, 0.8971572827861190591, -1.622764514865468214e-09, 1.1304016226141906376,
      -0.8971572827861190591, 0.44171122913485860728, -5.1621053952306079594e-09, 1.8410802645284281009,
      -3.9144271413829990148e-09, 3.7360349218094348098e-09, 1, 0.44400006232932492933}},
    {{0.05, 0.55, 0.3},
     {0.00079632671073326442932, -0.99999968293183538748, 0, 0.75000000000000055511, 0.99999968293183538748,
      0.00079632671073326442932, 0, -2.4083553715553102684e-15, 0, 0, 1, 0.15},
     {0.25, 0.2, 0.15},
     {6.1232339957367660359e-17, 0, 1, 0.75, -1, 6.1232339957367660359e-17, 6.1232339957367660359e-17, 0,
      -6.1232339957367660359e-17, -1, 3.7493994566546440196e-33, 0.15}},
};
constexpr std::size_t touching_scene = 5;

// The source asks that closest points belong to their solids and are as far from each other as is said; and a depth is
// one: the boxes are parted by slightly more of it, and not by slightly less.
void check_consistency(Expectations& expect, const Posed<ConvexSolid>& a, const Posed<ConvexSolid>& b) {
    const auto closest = closest_apart(a, b);
    const auto how_deep = depth(a, b);
    expect.is(closest.has_value() != how_deep.has_value(), true);
    if (closest) {
        const double largest = std::max(closest->point_a.cwiseAbs().maxCoeff(), closest->point_b.cwiseAbs().maxCoeff());
        expect.near((closest->point_a - closest->point_b).norm(), closest->distance, 4 * 0x1p-53 * largest);
        expect.is(distance(a, b), closest->distance);
        expect.is(distance(b, a), closest->distance);
    } else {
        const Vec3 way = how_deep->depth * how_deep->direction, step = 1e-9 * how_deep->direction;
        expect.is(distance(a, {*b.what, Pose{b.pose.R, b.pose.t + (way + step)}}) > 0, true);
        expect.is(distance(a, {*b.what, Pose{b.pose.R, b.pose.t + (way - step)}}) > 0, false);
        expect.near(depth(b, a)->depth, how_deep->depth, 0);
    }
}

void ask_scenes(Expectations& expect) {
    expect.from("test_distance_box_box_regression1 to 7");
    for (std::size_t i = 0; i < std::size(scenes); ++i) {
        const Boxes& s = scenes[i];
        const ConvexSolid a = box(s.sides_a / 2), b = box(s.sides_b / 2);
        const Posed<ConvexSolid> posed_a{a, pose_of(s.a)}, posed_b{b, pose_of(s.b)};
        check_consistency(expect, posed_a, posed_b);
        const auto closest = closest_apart(posed_a, posed_b);
        // The source allows 1.5e-8.
        if (i == touching_scene) expect.near(signed_number(posed_a, posed_b), 0, 0x1p-26);
        if (!closest) continue;
        const auto is_in = [](const Pose& pose, const Vec3& p, const Vec3& sides) {
            const Vec3 own = pose.R.inverse() * (p - pose.t);
            return (own.cwiseAbs() - sides / 2).maxCoeff() < 1e-14;
        };
        expect.is(is_in(posed_a.pose, closest->point_a, s.sides_a), true);
        expect.is(is_in(posed_b.pose, closest->point_b, s.sides_b), true);
    }
}

// Tilted cubes, one on the other (issue 493): distances about u of their size, which the poses' rounding changes by as
// much.
void ask_kissing(Expectations& expect) {
    expect.from("regression_tilted_kissing_contact");
    Mat3 R;
    R << 0.94096063217417758029, 0.29296840037289501035, 0.16959541586174811667,   //
        -0.23569836841299879326, 0.92661523595848427348, -0.29296840037289506586,  //
        -0.2429801799032638987, 0.23569836841299884878, 0.94096063217417758029;
    for (const double side : {0.01, 0.25, 0.5, 10., 1000.}) {
        const ConvexSolid cube = box(Vec3::Constant(side / 2));
        const Pose a{R, Vec3(0, 0, 5 * side)};
        for (const double distance : {-1e-15, -2.5e-16, -1e-16, 0., 1e-16, 2.5e-16, 1e-15}) {
            const double scaled = distance * std::max(1., side);
            const Pose b{R, a.t + R * Vec3(0, side + scaled, 0)};
            expect.near(signed_number({cube, a}, {cube, b}), scaled, 8 * 0x1p-53 * 5 * std::max(1., side));
            check_consistency(expect, {cube, a}, {cube, b});
        }
    }
}

// A prism along x over a polygon of y and z, turned and moved by two rows of a matrix of which the third is 1, 0 and
// about 0; and one along z over a triangle (issue 21673 of Drake).
struct Prisms {
    std::vector<std::array<double, 2>> polygon;
    std::array<double, 8> rows;
    std::array<double, 6> triangle;
};

ConvexSolid prism(const Prisms& p) {
    std::vector<Vec3> points;
    for (const auto& v : p.polygon) {
        for (const double x : {-0.5, 0.5}) points.emplace_back(x, v[0], v[1]);
    }
    return hull_of(points);
}
ConvexSolid upright_prism(const Prisms& p) {
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < 6; i += 2) {
        for (const double z : {-0.5, 0.5}) points.emplace_back(p.triangle[i], p.triangle[i + 1], z);
    }
    return hull_of(points);
}

void ask_prisms(Expectations& expect) {
    expect.from("convex_to_convex5 to 7");
    const Prisms all[] = {
        {{{0.5, -0.866025}, {-0.5, -0.866025}, {1, 0}, {-0.5, 0.866025}, {0.5, 0.866025}, {-1, 0}},
         {-2.2411796174427631456e-09, 0.7148738189791493669, -0.69925347545662319693, 6.3335747278141161232,
          2.2912444319183419853e-09, 0.69925347545662319693, 0.7148738189791493669, 8.4631576303276716544},
         {5.242363, 9.122811, 6.359664, 8.28526, 5.670377, 7.598539}},
        {{{0.309017, -0.951057}, {1, 0}, {-0.809017, 0.587785}, {0.309017, 0.951057}, {-0.809017, -0.587785}},
         {-3.1934130613594990691e-09, -0.085331461972016672823, -0.99635261910516315087, 11.261494468063983021,
          -2.7349614983807029573e-10, 0.99635261910516315087, -0.085331461972016672823, 5.7102314848013024928},
         {10.924769, 5.670102, 10.839257, 4.83299, 11.452507, 5.520981}},
        {{{-0.5, -0.866025}, {-0.5, 0.866025}, {1, 0}},
         {-3.155367699156126597e-09, -0.17548349096519452739, -0.98448237383849002136, 9.4277544959429171456,
          -5.6244271491403150214e-10, 0.98448237383849002136, -0.17548349096519452739, 4.3549730982604870633},
         {7.502455, 3.992667, 7.91275, 2.73346, 8.674382, 3.710847}},
    };
    for (const Prisms& p : all) {
        const ConvexSolid a = prism(p), b = upright_prism(p);
        const auto& r = p.rows;
        const Pose pose =
            pose_of({r[0], r[1], r[2], r[3], r[4], r[5], r[6], r[7], 1, 0, -3.2051032938795742666e-09, 0});
        check_consistency(expect, {a, pose}, {b, Pose{}});
    }
}

// A cube in each of six positions that look the same, against another box: the depth, and that the second goes along
// `direction` out of the first.
void check_depth(Expectations& expect, const Vec3& sides_a, const Pose& a, double side_b, const Pose& b, double deep,
                 const Vec3& direction) {
    const ConvexSolid first = box(sides_a / 2), second = box(Vec3::Constant(side_b / 2));
    const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
    for (const Mat3& R : {Mat3(Mat3::Identity()), turn(pi, x), turn(pi / 2, x), turn(3 * pi / 2, x), turn(pi / 2, y),
                          turn(3 * pi / 2, y)}) {
        const Pose turned{b.R * R, b.t};
        for (const bool is_swapped : {false, true}) {
            const Posed<ConvexSolid> p{first, a}, q{second, turned};
            const auto found = is_swapped ? depth(q, p) : depth(p, q);
            expect.is(found.has_value(), true);
            if (!found) continue;
            expect.near(found->depth, deep, 1e-14);
            for (int k = 0; k < 3; ++k) expect.near(found->direction[k], (is_swapped ? -1 : 1) * direction[k], 1e-14);
        }
    }
}

void ask_depths(Expectations& expect) {
    const Vec3 unit = Vec3::Ones(), x = Vec3::UnitX(), y = Vec3::UnitY(), z = Vec3::UnitZ();
    const double root_2 = std::numbers::sqrt2;
    expect.from("collision_box_box_all_contacts");
    check_depth(expect, unit, {turn(pi / 4, y), Vec3::Zero()}, 3, at(0, 0, -1.5), root_2 / 2, -z);
    expect.from("collision_box_box_cull_contacts");
    check_depth(expect, unit, {turn(pi / 8, x), Vec3::Zero()}, 1, {turn(pi / 4, z), Vec3(0, 0, -0.75)},
                root_2 / 2 * std::cos(pi / 8) - 0.25, -z);
    expect.from("collision_box_box_edge_contact");
    const Vec3 direction(root_2 / 2, 0, root_2 / 2);
    check_depth(expect, unit, {turn(-pi / 4, y) * turn(pi / 4, z), direction * (root_2 - 0.1)}, 1, Pose{}, 0.1,
                -direction);
}

}  // namespace

void ask(Expectations& expect) {
    ask_scenes(expect);
    ask_kissing(expect);
    ask_prisms(expect);
    ask_depths(expect);
}

}  // namespace ecods::foreign::fcl_boxes
