#include "examples/how_do_i/moves.hpp"

#include <fmt/core.h>
#include <fmt/ostream.h>
#include <ecods/ecods.hpp>

#include <numbers>
#include <variant>
#include <vector>

#include "examples/how_do_i/bodies.hpp"

namespace how_do_i {

void cast_on_its_way() {
    const auto cube = unit_cube();
    const auto contact = cast({cube, {.t = {0, 0, 5}}}, Vec3(0, 0, -8), {cube, Pose{}});
    if (contact) fmt::print("cast on its way: meets at time {}\n", contact->time);
}

void contact_with_a_normal() {
    const auto cube = unit_cube();
    const Posed falling(cube, {.t = {0.25, 0.5, 5}}), floor(cube, Pose{});
    const Vec3 motion(1, 0, -8);
    const auto contact = cast(falling, motion, floor);
    if (!contact) return;
    const ContactPoint at = contact_point(falling, motion, floor, *contact);
    fmt::print("contact with a normal: at {}, along {}\n", text(at.point), text(*at.normal));
}

void ball_on_a_floor() {
    const auto cube = unit_cube();
    const Posed<Rounded> ball(sphere(0.5), {.t = {0.25, 0.5, 5}});
    const Posed<MeshShape> floor(cube, Pose{});
    const Vec3 motion(1, 0, -8);
    const auto contact = cast(ball, motion, floor);
    if (!contact) return;
    const ContactPoint at = contact_point(ball, motion, floor, *contact);
    fmt::print("ball on a floor: at {}, along {}\n", text(at.point), text(*at.normal));
}

// A cube that stands on another one slides off it freely; pushed down, it enters at once.
void slide_and_enter() {
    const auto cube = unit_cube();
    const Posed standing(cube, {.t = {0, 0, 1}}), falling(cube, {.t = {0, 0, 3}}), floor(cube, Pose{});
    const bool slides = !entering(standing, {2, 0, 0}, floor);
    const auto entry = entering(falling, {0, 0, -3}, floor);
    if (!entry) return;
    const auto before = pose_before(falling, {0, 0, -3}, floor, entry->time);
    fmt::print("slide and enter: slides {}, falls in at {:.4f}, free at height {}\n", slides, entry->time,
               before->t.z());
}

void stop_at_a_distance() {
    const auto cube = unit_cube();
    const auto near = cast_to_distance({cube, {.t = {0, 0, 5}}}, {0, 0, -8}, {cube, Pose{}}, 2);
    if (near) fmt::print("stop at a distance: 2 away at time {}\n", near->time);
}

// A sheet of two triangles falls while one of its corners lags behind.
void cast_a_cloth() {
    const std::vector<Vec3> corners{{0, 0, 3}, {1, 0, 3}, {1, 1, 3}, {0, 1, 3}};
    const auto sheet = std::make_shared<const MeshShape>(Mesh::create(corners, {Triangle{0, 1, 2}, {0, 2, 3}}));
    const Deforming cloth(sheet, {{0, 0, 3}, {1, 0, -1}, {1, 1, -1}, {0, 1, -1}});
    const auto contact = cast(cloth, {unit_cube(), Pose{}});
    if (contact) fmt::print("cast a cloth: meets at time {}\n", contact->time);
}

// Which body of a World does the sheet meet first?
void cast_a_cloth_in_a_world() {
    World world;
    for (const double x : {0.0, 1.0}) world.create_body(unit_cube(), {.t = {x, 0, x}});
    const std::vector<Vec3> corners{{0, 0, 4}, {2, 0, 4}, {2, 1, 4}, {0, 1, 4}};
    const auto sheet = std::make_shared<const MeshShape>(Mesh::create(corners, {Triangle{0, 1, 2}, {0, 2, 3}}));
    const Deforming cloth(sheet, {{0, 0, 4}, {2, 0, 0}, {2, 1, 0}, {0, 1, 4}});
    if (const auto met = world.cast(cloth)) {
        fmt::print("cast a cloth in a world: meets {} at time {:.3f}\n", fmt::streamed(met->body), met->contact.time);
    }
}

// A ray goes through the bodies of a World, and a cube goes into the first of them.
void way_through_a_world() {
    World world;
    for (const double x : {0.0, 3.0}) world.create_body(unit_cube(), {.t = {x, 0, 0}});
    const Ray ray{.origin = {-1, 0.25, 0.5}, .direction = {1, 0, 0}};
    for (const BodyInsidePart& part : world.inside_parts(ray)) {
        fmt::print("way through a world: in {} from {} to {}\n", fmt::streamed(part.body), part.part.from,
                   part.part.to);
    }
    const BodySidedHit first = world.sided_hits(ray).front();
    fmt::print("way through a world: enters {}, normal {}\n", fmt::streamed(first.body), text(*first.sided.normal));
    if (const auto entry = world.entering({unit_cube(), {.t = {-3, 0, 0}}}, {4, 0, 0})) {
        fmt::print("way through a world: a cube enters {} at time {}\n", fmt::streamed(entry->body), entry->entry.time);
    }
}

// A rod turns by a quarter about its end, as a joint of a robot does. If each of its points went straight, it would be
// shorter on its way, and miss the post.
void turn_past_a_post() {
    const auto rod = box({2, 0.125, 0.125}), post = box({0.125, 0.125, 1});
    const Turn turn = about({0, 0, 1}, std::numbers::pi / 2, Vec3::Zero());
    const auto contact = cast({rod, {.t = {1, 0, 0}}, turn}, {post, {.t = {1.25, 1.25, 0}}});
    if (!contact) return;
    fmt::print("turn past a post: meets after {:.2f} of 90 degrees\n",
               angle_at(turn, contact->time) * 180 / std::numbers::pi);
    // Another rod turns about an end of its own.
    const Turn other = about({0, 0, 1}, std::numbers::pi / 2, {2, 3, 0});
    const auto between = cast({rod, {.t = {1, 0, 0}}, turn}, {rod, {.t = {1, 3, 0}}, other});
    if (between) {
        fmt::print("two rods that turn: meet after {:.2f} of 90 degrees\n",
                   angle_at(turn, between->time) * 180 / std::numbers::pi);
    }
}

// The rod goes on past half a turn, in which the post is not, to a whole one: two legs of a way.
void turn_all_the_way() {
    const auto rod = box({2, 0.125, 0.125}), post = box({0.125, 0.125, 1});
    const Vec3 hinge = Vec3::Zero();
    const std::vector<WayNode> nodes{{{1, 0, 0, 0}, hinge}, {{0, 0, 0, 1}, hinge}, {{-1, 0, 0, 0}, hinge}};
    const Way<MeshShape> way(rod, {.t = {1, 0, 0}}, nodes);
    const Posed<MeshShape> other(post, {.t = {-1.25, -1.25, 0}});
    const auto met = cast(way, other);
    if (!met) return;
    fmt::print("turn all the way: meets on leg {} at {:.3f}, at {}\n", met->leg, met->contact.time,
               text(contact_point(way, other, *met).point));
    // A world with the post: the same contact, at its share of the time.
    World world;
    world.create_body(post, other.pose);
    if (const auto first = world.cast({way.what->mesh_ptr(), way.pose}, Along{nodes})) {
        fmt::print("turn all the way: in a world at {:.3f}\n", first->contact.time);
    }
}

// A rod turns while a cart comes: which pairs meet on the way, and when?
void move_at_once() {
    World world;
    const BodyId rod = world.create_body(box({2, 0.125, 0.125}), {.t = {1, 0, 0}});
    const BodyId cart = world.create_body(unit_cube(), {.t = {-4, 1, 0}});
    world.create_body(box({0.125, 0.125, 1}), {.t = {1.25, 1.25, 0}});
    const std::vector bodies = {rod, cart};
    const std::vector<Motion> motions = {about({0, 0, 1}, std::numbers::pi / 2, Vec3::Zero()), Translation{{4, 0, 0}}};
    for (const Meeting& meeting : world.meetings(bodies, motions)) {
        fmt::print("move at once: {} at time {:.3f}\n", fmt::streamed(meeting.bodies), meeting.contact.time);
    }
    if (const auto met = world.cast(rod, std::get<Turn>(motions[0]))) {
        fmt::print("move at once: the rod alone meets {} at time {:.3f}\n", fmt::streamed(met->body),
                   met->contact.time);
    }
}

}  // namespace how_do_i
