// Everything. The headers are the manual; read them in this order.
//
// Words. *Overlap* is said of boxes; *intersect* of sets that share a point, one that they only touch in included;
// *touch* and *cross* of how they do; *collide* of the pairs in a world's lists; *disjoint* of sets that share none.
#pragma once

// clang-format off
#include "ecods/world.hpp"             // many moving bodies: which of them touch?
#include "ecods/world_options.hpp"     // what it is made with
#include "ecods/world_answers.hpp"     // what a world answers
#include "ecods/statistics.hpp"        // what it did, as counts
#include "ecods/mesh.hpp"              // what a body is made of
#include "ecods/pose.hpp"              // where it is
#include "ecods/posed.hpp"             // a thing at a pose
#include "ecods/error.hpp"             // what can go wrong
#include "ecods/intersection.hpp"      // questions about two bodies, without a world
#include "ecods/distance.hpp"          // how far are they from each other, and where?
#include "ecods/contact.hpp"           // where they meet, and which features nearly do
#include "ecods/hit.hpp"               // what a segment or a ray meets
#include "ecods/cast.hpp"              // when does a body on the move first meet another?
#include "ecods/motion.hpp"            // a thing on its way from one pose to another
#include "ecods/solid.hpp"             // what is inside what: closed meshes as solids
#include "ecods/convex_solid.hpp"      // solids without dents, and how far two of them are from each other
#include "ecods/depth.hpp"             // how deep solids are in each other
#include "ecods/certificate.hpp"       // an answer with a proof that others can check
#include "ecods/closest_points.hpp"    // two closest points, and the features that hold them
#include "ecods/first_contact.hpp"     // when two bodies first meet, and with which features
#include "ecods/triangle_hit.hpp"      // what a segment or a ray shares with a triangle
#include "ecods/shared_set.hpp"        // what two triangles share, and features that are near each other
#include "ecods/predicates.hpp"        // exact signs, and how two triangles meet
#include "ecods/shape.hpp"             // shapes of the caller's own
#include "ecods/collision_filter.hpp"  // which bodies are meant to meet at all
#include "ecods/executor.hpp"          // where work in parallel runs
#include "ecods/trace.hpp"             // a record of every call that changed a world
#include "ecods/replay.hpp"            // which is run again
#include "ecods/broad_phase.hpp"       // which boxes overlap
#include "ecods/aabb.hpp"              // boxes
#include "ecods/segment.hpp"           // segments and rays
#include "ecods/ball.hpp"              // balls
#include "ecods/ids.hpp"               // names of bodies, pairs of them and of triangles
#include "ecods/instruction_set.hpp"   // which of the processor's instructions are used
#include "ecods/version.hpp"
// clang-format on
