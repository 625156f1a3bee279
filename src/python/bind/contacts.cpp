// Binds contact.hpp: contact patches, and depths with points or along a direction.
#include "ecods/contact.hpp"

#include <pybind11/stl.h>

#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/patch_limits.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

void add_records(py::module_& m) {
    add_record(m, "PatchCorner", "A corner of a contact patch: a point of each body.",
               Field{"point_a", &PatchCorner::point_a, "(3,) float64, each coordinate rounded once."},
               Field{"point_b", &PatchCorner::point_b, "(3,) float64; point_b - point_a is gap times the normal."},
               Field{"middle", &PatchCorner::middle, "(3,) float64, the middle of both points."},
               Field{"gap", &PatchCorner::gap, "Their distance along the normal, rounded once; minus a depth."},
               Field{"a", &PatchCorner::a, "The feature of a with point_a."},
               Field{"b", &PatchCorner::b, "The feature of b with point_b."});
    add_record(
        m, "ContactPatch", "Where two convex bodies touch, or would touch first.",
        Field{"distance", &ContactPatch::distance, "The distance, or minus the depth, rounded once."},
        Field{"normal", &ContactPatch::normal, "Unit vector (3,) from a to b."},
        Field{"corners", &ContactPatch::corners,
              "A list of PatchCorner, counterclockwise around the normal, the deepest first."},
        Field{"corner_count", &ContactPatch::corner_count, "Number of corners before max_corners left some out."});
    add_record(m, "BodyPatch", "Two convex bodies that collide, and their contact patch.",
               Field{"bodies", &BodyPatch::bodies, "Their ids, the lesser first."},
               Field{"patch", &BodyPatch::patch, "The ContactPatch of the first and the second."});
    add_record(m, "DepthPoints", "A depth, and the two points that its translation brings together.",
               Field{"depth", &DepthPoints::depth, "The Depth."},
               Field{"a", &DepthPoints::a, "The feature of a with point_a."},
               Field{"b", &DepthPoints::b, "The feature of b with point_b."},
               Field{"point_a", &DepthPoints::point_a, "(3,) float64, each coordinate rounded once."},
               Field{"point_b", &DepthPoints::point_b, "(3,) float64, each coordinate rounded once."});
    add_record(m, "DepthAlong", "How far b must go along a direction until it shares no inner point with a.",
               Field{"parameter", &DepthAlong::parameter, "In units of the direction, rounded once; 0 if they touch."},
               Field{"length", &DepthAlong::length, "The parameter times the direction's length, rounded once."},
               Field{"a", &DepthAlong::a, "The feature of a that names the normal."},
               Field{"b", &DepthAlong::b, "The feature of b that names the normal."},
               Field{"normal", &DepthAlong::normal, "Unit vector (3,), across the plane in which they touch then."});
}

template <class A, class B>
void add_patch(py::module_& m) {
    const LimitArguments limits;
    m.def(
        "contact_patch",
        [](const A& a, const B& b, std::uint32_t max_corners, double min_cos_squared, double max_gap,
           PairWitness* witness) {
            return ask(witness, [&](const Ask& how) {
                return contact_patch(a, b, PatchLimits{max_corners, min_cos_squared, max_gap}, how);
            });
        },
        py::arg("a"), py::arg("b"), limits.max_corners, limits.min_cos_squared, limits.max_gap,
        py::arg("witness") = py::none(),
        "ContactPatch of two convex bodies: ConvexSolid, sphere, capsule, another Rounded with a ConvexSolid or a "
        "triangle as its core; or one HalfSpace. max_corners: at most so many corners, 0 for all; min_cos_squared: "
        "below 1, takes faces that are tilted against the normal by that much; max_gap: leaves out corners further "
        "apart. Raises NotSupported, SingularPose, InvalidArgument.");
}

}  // namespace

void bind_contacts(py::module_& m) {
    add_records(m);
    add_patch<PosedMesh, PosedMesh>(m);
    add_patch<PosedMesh, PosedRounded>(m);
    add_patch<PosedMesh, PosedHalfSpace>(m);
    add_patch<PosedRounded, PosedMesh>(m);
    add_patch<PosedRounded, PosedRounded>(m);
    add_patch<PosedRounded, PosedHalfSpace>(m);
    add_patch<PosedHalfSpace, PosedMesh>(m);
    add_patch<PosedHalfSpace, PosedRounded>(m);
    m.def(
        "depth_points",
        [](const PosedMesh& a, const PosedMesh& b) {
            const auto p = as<ConvexSolid>(a, "a"), q = as<ConvexSolid>(b, "b");
            return ask([&] { return depth_points(p, q); });
        },
        py::arg("a"), py::arg("b"),
        "DepthPoints of two ConvexSolids in each other; None if they share no point. Raises SingularPose.");
    m.def(
        "depth_along",
        [](const PosedMesh& a, const PosedMesh& b, const Vec3& direction) {
            const auto p = as<ConvexSolid>(a, "a"), q = as<ConvexSolid>(b, "b");
            return ask([&] { return depth_along(p, q, direction); });
        },
        py::arg("a"), py::arg("b"), py::arg("direction"),
        "DepthAlong of two ConvexSolids, of which b goes along the direction (3,); None if they share no point. Raises "
        "SingularPose, InvalidArgument.");
}

}  // namespace ecods::python
