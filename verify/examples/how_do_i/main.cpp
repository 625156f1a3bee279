// How do I ...? One function for each of the questions that most programs ask; include/ecods/ecods.hpp lists them.
#include <fmt/core.h>
#include <fmt/ostream.h>
#include <ecods/ecods.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <sstream>
#include <string>
#include <tuple>
#include <vector>

#include "examples/how_do_i/bodies.hpp"
#include "examples/how_do_i/moves.hpp"

namespace how_do_i {
namespace {

void touch() {
    const auto cube = unit_cube();
    const bool is_touching = intersects({cube, Pose{}}, {cube, {.t = {1, 0, 0}}});
    fmt::print("touch: {}\n", is_touching);
}

void distance_with_points() {
    const auto cube = unit_cube();
    const ClosestPoints points = closest({cube, Pose{}}, {cube, {.t = {2, 3, 3}}});
    fmt::print("distance with points: {} from {} to {}\n", points.distance, text(points.point_a), text(points.point_b));
}

void ray() {
    const auto cube = unit_cube();
    const auto hit = first_hit(Ray{.origin = {0.5, 0.25, 3}, .direction = {0, 0, -1}}, {cube, Pose{}});
    if (hit) fmt::print("ray: hits at {}, in {}\n", hit->parameter, text(hit->point));
}

// The line comes in through a face, out again, and so on: of a solid, every hit says which.
void where_a_line_goes_in() {
    const auto cube = unit_cube();
    const Ray ray{.origin = {0.5, 0.25, 3}, .direction = {0, 0, -1}};
    for (const SidedHit& side : sided_hits(ray, {cube, Pose{}})) {
        const bool enters = side.passage == Passage::enters;
        fmt::print("where a line goes in: {} at {}, normal {}\n", enters ? "enters" : "leaves", side.hit.parameter,
                   text(*side.normal));
    }
    if (const auto hit = first_hit(ray, {cube, Pose{}})) {
        fmt::print("the normal of a hit: {}\n", text(*hit_normal(ray, {cube, Pose{}}, *hit)));
    }
    for (const InsidePart& part : inside_parts(ray, {cube, Pose{}})) {
        fmt::print("parts inside: from {} to {}\n", part.from, part.to);
    }
}

void world_with_events() {
    World world;
    world.create_body(unit_cube(), Pose{});
    const BodyId moving = world.create_body(unit_cube(), {.t = {1, 0, 0}});
    world.update();
    const std::size_t began = world.began().size();
    world.set_pose(moving, {.t = {3, 0, 0}});
    world.update();
    fmt::print("world with events: {} began, then {} ended\n", began, world.ended().size());
}

// Makes a world of three cubes in a row, at distances of 2 and 3.
World three_cubes() {
    World world;
    for (const double x : {0.0, 3.0, 7.0}) world.create_body(unit_cube(), {.t = {x, 0, 0}});
    return world;
}

void nearest_body() {
    const World world = three_cubes();
    const BodyId last = world.bodies().back();
    const auto nearest = world.nearest(last);
    if (nearest) fmt::print("nearest body: {} at {}\n", fmt::streamed(nearest->body), nearest->distance);
}

void inside_a_solid() {
    const auto cube = unit_cube();
    const Location point = locate({0.5, 0.5, 0.5}, {cube, Pose{}});
    const Pose small{.R = Mat3::Identity() / 4, .t = {0.5, 0.5, 0.5}};
    const Relation solid = relation({cube, small}, {cube, Pose{}});
    fmt::print("inside a solid: the point is {}, the solid {}\n", fmt::streamed(point.side), fmt::streamed(solid));
}

void depth_of_convex_solids() {
    const auto cube = unit_cube();
    const auto out = depth({cube, Pose{}}, {cube, {.t = {0.75, 0, 0}}});
    if (out) fmt::print("depth of convex solids: {} along {}\n", out->depth, text(out->direction));
    const SignedDistance both = signed_distance({cube, Pose{}}, {cube, {.t = {0.75, 0.25, 0}}});
    fmt::print("signed distance: {} from {} to {}\n", both.distance, text(both.point_a), text(both.point_b));
}

void spheres_and_margins() {
    const auto ball = sphere(2);
    const auto padded = rounded(unit_cube(), 0.5);
    const double gap = distance({ball, {.t = {4, 5, 0.5}}}, {padded, Pose{}});
    fmt::print("spheres and margins: {} apart\n", gap);
}

void contact_of_boxes() {
    const auto cube = unit_cube();
    const ContactPatch patch = contact_patch({cube, Pose{}}, {cube, {.t = {0.25, 0.5, 1}}});
    fmt::print("contact of boxes: {} corners, the first at {}\n", patch.corners.size(), text(patch.corners[0].middle));
}

void again_with_a_witness() {
    const auto cube = unit_cube();
    PairWitness witness;  // what decided the last question about the pair; no answer depends on it
    QueryCounts counts;
    double d = 0;
    for (const double x : {1.5, 1.625, 1.75}) d = distance({cube, Pose{}}, {cube, {.t = {x, 0, 0}}}, {witness, counts});
    fmt::print("again with a witness: {} at last, after {} questions\n", d, counts.queries);
}

void mesh_that_is_no_body() {
    const World world = three_cubes();
    const std::shared_ptr<const Mesh> mesh = unit_cube()->mesh_ptr();
    const auto met = world.intersecting_bodies({mesh, {.t = {2.5, 0, 0}}});
    const double d = world.distance({mesh, Pose{}}, world.bodies().back());
    fmt::print("mesh that is no body: meets {}, and is {} from the last body\n", fmt::streamed(met.at(0)), d);
}

void trace_and_replay() {
    World world = three_cubes();
    std::stringstream trace;  // a file, in earnest
    world.trace_to(trace, {.questions = true});
    world.update();
    std::ignore = world.closest_pair();
    world.end_trace();
    const ReplayReport report = replay(trace);
    fmt::print("trace and replay: {} question, {}\n", report.question_count,
               report.difference ? "differs" : "the same");
}

void make_a_mesh() {
    const std::vector<float> coordinates{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const std::vector<std::uint32_t> indices{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const auto mesh = Mesh::create(coordinates, indices);
    const Solid tetrahedron(mesh);  // throws NotSolid if the mesh bounds no solid
    fmt::print("make a mesh: {} vertices, {} triangles\n", mesh->vertices().size(), mesh->triangles().size());
}

void build_a_body() {
    const auto crate = box({1, 2, 0.5});
    const Circumscribed can = cylinder(0.5, 2, 32);  // contains the real cylinder
    const std::vector<double> heights{0, 0, 0, 0, 1, 0, 0, 0, 0};
    const auto hill = height_field(heights, 3, {4, 4}, -1);  // solid down to z = -1
    const double d = distance({crate, Pose{}}, {can.solid, {.t = {2, 0, 0}}});
    const bool is_buried = intersects({crate, {.t = {4, 4, 0}}}, {hill, Pose{}});
    fmt::print("build a body: the can is {:.4f} to {:.4f} away, in the hill: {}\n", d, d + can.deviation, is_buried);
}

void pose_a_body() {
    const auto turn = Pose::from_quaternion({0, 0, 0, 1}, Vec3(3, 0, 0));  // half a turn around z
    const Posed body(unit_cube(), turn);                                   // keeps the cube, which nobody else does
    fmt::print("pose a body: x becomes {} x + {}\n", body.pose.R(0, 0), body.pose.t.x());
}

void overlap_of_boxes() {
    const Aabb box{.min = {0, 0, 0}, .max = {1, 1, 1}};
    const Segment diagonal{.a = {-1, 0, 0}, .b = {0, 1, 0}};  // grazes an edge of the box
    const Ball ball{.center = {2, 2, 2}, .radius = 1.5};
    fmt::print("overlap of boxes: a segment {}, a ball {}\n", overlap(diagonal, box), overlap(ball, box));
}

void exact_signs() {
    const Vec2 a(0, 0), b(3, 1), c(6, 2), d(6, 2 + 0x1p-51);
    fmt::print("exact signs: {}, {}\n", fmt::streamed(orient2d(a, b, c)), fmt::streamed(orient2d(a, b, d)));
}

void catch_an_error() {
    try {
        World().create_body(unit_cube(), {.t = {0, HUGE_VAL, 0}});
    } catch (const InvalidArgument& error) {
        fmt::print("catch an error: {}: {}\n", error.part, error.what());
    }
}

void ignore_pairs() {
    World world;
    for (const std::uint64_t mask : {1, 1, 2}) world.create_body({.shape = unit_cube(), .filter = {1, mask}});
    world.update();
    fmt::print("ignore pairs: {} of 3 pairs collide\n", world.colliding_pairs().size());
}

void keep_a_margin() {
    World world = three_cubes();
    world.set_clearance(2.5);
    world.update();
    fmt::print("keep a margin: {} pair within 2.5\n", world.close_pairs().size());
}

void stand_on_the_ground() {
    const HalfSpace ground(Vec3::UnitZ(), 0);  // z <= 0
    const auto cube = unit_cube();
    fmt::print("stand on the ground: {} above it, {} in it\n",
               signed_distance({cube, {.t = {0, 0, 2}}}, {ground, Pose{}}).distance,
               -signed_distance({cube, {.t = {0, 0, -0.25}}}, {ground, Pose{}}).distance);
}

void count_the_work() {
    World world = three_cubes();
    world.update();
    const Statistics work = world.statistics();
    fmt::print("count the work: {} bodies, {} two-body tests\n", work.body_count, work.two_body_tests);
}

void find_boxes() {
    const auto boxes = make_broad_phase(BroadPhaseKind::automatic);
    boxes->add(0, {.min = {0, 0, 0}, .max = {1, 1, 1}});
    boxes->add(1, {.min = {1, 0, 0}, .max = {2, 1, 1}});
    boxes->update();
    fmt::print("find boxes: {} pair\n", boxes->pairs().size());
}

void prove_an_answer() {
    const auto cube = surface_of(*unit_cube());                                   // proofs are about surfaces
    const Certificate proof = certify({cube, Pose{}}, {cube, {.t = {2, 0, 0}}});  // ecods_check_certificate checks it
    fmt::print("prove an answer: {} step\n", proof.step_count());
}

void limit_instructions() {
    limit_instruction_set(InstructionSet::baseline);
    fmt::print("limit instructions: {}\n", fmt::streamed(instruction_set()));
    limit_instruction_set(supported_instruction_set());
}

}  // namespace
}  // namespace how_do_i

int main() {
    using namespace how_do_i;
    touch();
    distance_with_points();
    ray();
    where_a_line_goes_in();
    cast_on_its_way();
    contact_with_a_normal();
    ball_on_a_floor();
    slide_and_enter();
    stop_at_a_distance();
    cast_a_cloth();
    cast_a_cloth_in_a_world();
    way_through_a_world();
    turn_past_a_post();
    turn_all_the_way();
    move_at_once();
    world_with_events();
    nearest_body();
    inside_a_solid();
    depth_of_convex_solids();
    spheres_and_margins();
    contact_of_boxes();
    again_with_a_witness();
    mesh_that_is_no_body();
    trace_and_replay();
    make_a_mesh();
    build_a_body();
    pose_a_body();
    overlap_of_boxes();
    exact_signs();
    catch_an_error();
    ignore_pairs();
    keep_a_margin();
    stand_on_the_ground();
    count_the_work();
    find_boxes();
    prove_an_answer();
    limit_instructions();
}
