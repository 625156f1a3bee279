// Binds builders.hpp.
#include "ecods/builders.hpp"

#include <vector>
#include "python/bind/bind.hpp"
#include "python/bind/record.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

// A PythonCircumscribed is a Circumscribed with its solid in the form in which pybind11 holds it.
struct PythonCircumscribed {
    std::shared_ptr<ConvexSolid> solid;
    double deviation = 0;
};

std::shared_ptr<ConvexSolid> without_const(const std::shared_ptr<const ConvexSolid>& solid) {
    return std::const_pointer_cast<ConvexSolid>(solid);
}

// Calls make() without the interpreter's lock.
template <class Make>
PythonCircumscribed circumscribed(const Make& make) {
    const py::gil_scoped_release release;
    const Circumscribed made = make();
    return {without_const(made.solid), made.deviation};
}

Vec2 to_spacing(const py::object& value) {
    const std::array<py::ssize_t, 1> shape{2};
    const Doubles numbers = exact_doubles(value, "spacing", shape);
    return {numbers.at(0), numbers.at(1)};
}

Doubles to_heights(const py::object& value) {
    const std::array<py::ssize_t, 2> shape{-1, -1};
    return exact_doubles(value, "heights", shape);
}

void add_flat(py::module_& m) {
    m.def(
        "box",
        [](const Vec3& sizes) {
            const py::gil_scoped_release release;
            return without_const(box(sizes));
        },
        py::arg("sizes"),
        "A box of these side lengths (3,), centered at the origin, as a ConvexSolid: exact. Raises InvalidArgument.");
    m.def(
        "prism",
        [](const py::object& polygon, double height) {
            const std::array<py::ssize_t, 2> shape{-1, 2};
            const Doubles rows = exact_doubles(polygon, "polygon", shape);
            // The points are copied, because Vec2 is aligned to 16 bytes, and rows of an array may not be.
            std::vector<Vec2> points;
            for (py::ssize_t i = 0; i < rows.shape(0); ++i) points.emplace_back(rows.at(i, 0), rows.at(i, 1));
            const py::gil_scoped_release release;
            return without_const(prism(points, height));
        },
        py::arg("polygon"), py::arg("height"),
        "The points over a convex polygon (n, 2), from z = -height / 2 to z = height / 2, as a ConvexSolid: exact. "
        "Raises InvalidArgument, NotSolid.");
}

void add_curved(py::module_& m) {
    add_record<PythonCircumscribed>(
        m, "Circumscribed", "A convex polytope that contains a curved body, exactly.",
        Field{"solid", &PythonCircumscribed::solid, "The polytope: a ConvexSolid."},
        Field{"deviation", &PythonCircumscribed::deviation,
              "No point of the polytope is farther from the curved body: the largest distance, or a bound of it."});
    m.def(
        "cylinder",
        [](double radius, double height, std::uint32_t sides) {
            return circumscribed([&] { return cylinder(radius, height, sides); });
        },
        py::arg("radius"), py::arg("height"), py::arg("sides"),
        "A prism around the cylinder along z, centered at the origin: Circumscribed. Raises InvalidArgument.");
    m.def(
        "cone",
        [](double radius, double height, std::uint32_t sides) {
            return circumscribed([&] { return cone(radius, height, sides); });
        },
        py::arg("radius"), py::arg("height"), py::arg("sides"),
        "A pyramid around the cone with its apex at z = height / 2 and its disc at z = -height / 2: Circumscribed. "
        "Raises InvalidArgument.");
    m.def(
        "ellipsoid",
        [](const Vec3& radii, std::uint32_t subdivisions) {
            return circumscribed([&] { return ellipsoid(radii, subdivisions); });
        },
        py::arg("radii"), py::arg("subdivisions"),
        "A polytope around the ellipsoid with these half axes (3,), or around a ball if they are equal: Circumscribed. "
        "It is an icosahedron whose triangles are divided into four, 0 to 6 times. Raises InvalidArgument.");
}

void add_fields(py::module_& m) {
    m.def(
        "height_field",
        [](const py::object& heights, const py::object& spacing) {
            const Doubles z = to_heights(heights);
            const Vec2 step = to_spacing(spacing);
            const std::span given(z.data(), static_cast<std::size_t>(z.size()));
            const auto columns = static_cast<std::size_t>(z.shape(1));
            const py::gil_scoped_release release;
            return to_python(height_field(given, columns, step));
        },
        py::arg("heights"), py::arg("spacing"),
        "The surface over a grid of heights (rows, columns), as a Mesh: heights[j, i] is at x = i spacing[0] and "
        "y = j spacing[1]. Raises InvalidArgument, InvalidMesh.");
    m.def(
        "height_field",
        [](const py::object& heights, const py::object& spacing, double base) {
            const Doubles z = to_heights(heights);
            const Vec2 step = to_spacing(spacing);
            const std::span given(z.data(), static_cast<std::size_t>(z.size()));
            const auto columns = static_cast<std::size_t>(z.shape(1));
            const py::gil_scoped_release release;
            return std::const_pointer_cast<Solid>(height_field(given, columns, step, base));
        },
        py::arg("heights"), py::arg("spacing"), py::arg("base"),
        "The Solid between that surface and the plane z = base, which must be below all heights.");
    m.def(
        "point_cloud",
        [](const py::object& points) {
            const Doubles rows = exact_points(points, "points");
            const std::span given(reinterpret_cast<const Vec3*>(rows.data()), static_cast<std::size_t>(rows.shape(0)));
            const py::gil_scoped_release release;
            return to_python(point_cloud(given));
        },
        py::arg("points"), "The points (n, 3) as a Mesh: face i is the point (i, i, i). Raises InvalidMesh.");
}

}  // namespace

void bind_builders(py::module_& m) {
    add_flat(m);
    add_curved(m);
    add_fields(m);
}

}  // namespace ecods::python
