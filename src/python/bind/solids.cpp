// Questions about solids: solid.hpp, convex_solid.hpp, depth.hpp.
#include "ecods/depth.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

using Body = const PosedMesh&;

void add_solids(py::module_& m, const py::arg& a, const py::arg& b) {
    m.def(
        "check_solid",
        [](const MeshShape& mesh) {
            const py::gil_scoped_release release;
            check_solid(mesh.mesh());
        },
        py::arg("mesh"), "Raises NotClosed or SelfIntersecting, which name the place, unless the mesh bounds a solid.");
    m.def(
        "self_intersections",
        [](const MeshShape& mesh) {
            std::vector<TrianglePair> pairs;
            {
                const py::gil_scoped_release release;
                pairs = self_intersections(mesh.mesh());
            }
            return from_triangles(pairs);
        },
        py::arg("mesh"),
        "Every pair of triangles that share a segment or more that is not a side of both: (k, 2) uint32.");
    m.def(
        "locate",
        [](const Vec3& point, Body solid) {
            const auto posed = as<Solid>(solid, "solid");
            return ask([&](auto& memory) { return locate(point, posed, memory); });
        },
        py::arg("point"), py::arg("solid"),
        "Location of a point (3,): outside, on or inside. Exact. Raises InvalidPoint.");
    m.def(
        "solid_relation",
        [](Body x, Body y) {
            const auto p = as<Solid>(x, "a");
            const auto q = as<Solid>(y, "b");
            return ask([&](auto& memory) { return solid_relation(p, q, memory); });
        },
        a, b, "SolidRelation of two Solids: apart, touching, overlapping, inside, contains or equal. Exact.");
    m.def(
        "surface_relation",
        [](Body surface, Body solid) {
            const auto posed = as<Solid>(solid, "solid");
            return ask([&](auto& memory) { return surface_relation(surface, posed, memory); });
        },
        py::arg("surface"), py::arg("solid"),
        "SurfaceRelation of a mesh to a Solid: apart, touching, inside or partly_inside. Exact.");
    m.def(
        "depth_bounds",
        [](Body x, Body y) {
            const auto p = as<Solid>(x, "a");
            const auto q = as<Solid>(y, "b");
            return ask([&](auto& memory) { return depth_bounds(p, q, memory); });
        },
        a, b, "DepthBounds of two Solids, convex or not. Raises SolidsApart, SingularPose.");
}

// A question of two convex solids with a witness.
template <class Question>
auto convex(Question question) {
    return [question](Body x, Body y, PairWitness* known) {
        const auto p = as<ConvexSolid>(x, "a");
        const auto q = as<ConvexSolid>(y, "b");
        return ask(known, [&](auto& memory, auto& w) { return question(p, q, memory, w); });
    };
}

}  // namespace

void bind_solid_questions(py::module_& m) {
    const py::arg a("a");
    const py::arg b("b");
    const auto witness = py::arg("witness") = py::none();
    add_solids(m, a, b);
    m.def("solid_distance",
          convex([](auto& p, auto& q, auto& memory, auto& w) { return solid_distance(p, q, memory, w); }), a, b,
          witness, "The distance of two ConvexSolids, interiors included: rounded once. Raises SingularPose.");
    m.def("solid_closest",
          convex([](auto& p, auto& q, auto& memory, auto& w) { return solid_closest(p, q, memory, w); }), a, b, witness,
          "ClosestPoints of two ConvexSolids; None where they share a point. Raises SingularPose.");
    m.def("depth", convex([](auto& p, auto& q, auto& memory, auto& w) { return depth(p, q, memory, w); }), a, b,
          witness, "Depth of two ConvexSolids in each other. Raises SolidsApart, SingularPose.");
}

}  // namespace ecods::python
