// Includes all public headers. The headers are the manual; read them in the order below.
//
// These ten calls are what nine of ten users need; verify/examples/how_do_i has each in a program of a few lines.
//
//     Mesh::create(vertices, triangles)                   a triangle mesh                         mesh.hpp
//     MeshShape(mesh), Solid(mesh), ConvexSolid(points)   a surface, a solid, a convex solid      shape.hpp
//     intersects({shape, pose}, {shape, pose})            do two bodies touch?                    intersection.hpp
//     closest({shape, pose}, {shape, pose})               how far apart, and where?               distance.hpp
//     first_hit(ray, {shape, pose})                       what does a ray hit?                    hit.hpp
//     cast({shape, pose}, motion, {shape, pose})          when does a moving body arrive?         cast.hpp
//     depth({solid, pose}, {solid, pose})                 how deep are they in each other?        solid.hpp
//     world.create_body(mesh, pose), world.set_pose(...)  many bodies                             world.hpp
//     world.update(); world.colliding_pairs(), began()    which of them touch, since when?        world.hpp
//     world.nearest(body), world.first_hit(ray)           what is near, what is in the way?       world.hpp
//
// How do I ...
//
//     pose a body by a quaternion, an isometry, a matrix?   Pose::from_quaternion, from_isometry, from_matrix
//     ask for a point?                                      closest, signed_distance; locate (of a solid)
//     find penetration, separation?                         signed_distance, depth, depth_bounds; within
//     get contact points and normals?                       contact_patch (convex); intersections, close_features
//     move a joint, turn a door, rigidly?                   about, between; cast of turning bodies (turn.hpp)
//     move several bodies at once?                          World::meetings; Motion (pose.hpp)
//     stop at a distance, land without touching?            cast_to_distance; entering, pose_before (cast.hpp)
//     cast cloth, or a mesh that bends?                     Deforming (cast.hpp)
//     have a ground, a wall?                                HalfSpace (solid.hpp)
//     find what is inside what?                             relation; World::relations, bodies_containing
//     ignore pairs?                                         CollisionFilter, World::set_pair_enabled
//     keep a margin around bodies?                          rounded (rounded.hpp); World::set_clearance, close_pairs
//     make spheres and capsules?                            sphere, capsule (rounded.hpp)
//     ask again quickly about a pair that moved little?     PairWitness (ask.hpp)
//     make a box, a cylinder, terrain?                      box, cylinder, height_field (builders.hpp)
//     use my threads?                                       Executor (world_options.hpp)
//     use shapes of my own?                                 Shape, TwoBodyTest
//     report a bug?                                         World::trace_to, replay (trace.hpp)
//     prove an answer to somebody else?                     certify (certificate.hpp)
//     catch errors?                                         Error, and 14 classes below it (error.hpp)
//
// Words. Boxes *overlap*. Two sets *intersect* if they share a point; they then *touch* or *cross*. Otherwise they are
// *apart*. Pairs in a world's lists *collide*.
#pragma once

// clang-format off
#include "ecods/mesh.hpp"           // triangle meshes
#include "ecods/pose.hpp"           // where bodies are, and how they move
#include "ecods/shape.hpp"          // shapes: meshes, solids, convex solids, and the caller's own with their tests
#include "ecods/builders.hpp"       // boxes, prisms, polytopes around curved bodies, height fields, clouds
#include "ecods/primitives.hpp"     // boxes, segments, rays, balls; exact signs, and how two triangles meet
#include "ecods/intersection.hpp"   // do two bodies meet, and where?
#include "ecods/distance.hpp"       // how far are they from each other, and where?
#include "ecods/rounded.hpp"        // spheres, capsules, and margins around bodies
#include "ecods/hit.hpp"            // what does a segment or a ray hit?
#include "ecods/cast.hpp"           // when does a body on the move first meet another, or come near it?
#include "ecods/turn.hpp"           // when does a body that turns, once or from node to node, first meet another?
#include "ecods/solid.hpp"          // what is inside what, and how deep? a ground, a wall
#include "ecods/contact.hpp"        // where do two convex bodies touch, and in which corners?
#include "ecods/results.hpp"        // the answers to all these
#include "ecods/ask.hpp"            // memory, witness and counts of a question
#include "ecods/world.hpp"          // many moving bodies
#include "ecods/world_options.hpp"  // options of worlds, bodies and traces; subjects of questions; counts
#include "ecods/ids.hpp"            // names of bodies and pairs; filters
#include "ecods/error.hpp"          // what can go wrong
#include "ecods/trace.hpp"          // a record of every call that changed a world, and how it is run again
#include "ecods/certificate.hpp"    // an answer with a proof that others can check
#include "ecods/broad_phase.hpp"    // which boxes overlap
#include "ecods/export.hpp"         // the version; instruction sets; which names are the interface
// clang-format on
