// Binds Mesh, Solid, ConvexSolid, Posed and Moving.
#include <limits>
#include <memory>
#include <sstream>
#include <type_traits>
#include <utility>

#include "ecods/primitives.hpp"
#include "python/bind/ask.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/errors.hpp"
#include "python/bind/shapes.hpp"

namespace ecods::python {
namespace {

// Makes a mesh from arrays of vertices and of faces. Indices of 32 bits are used as they are; other indices are
// converted to 64 bits without a sign, which makes a negative index too large.
std::shared_ptr<const Mesh> make_mesh(py::handle vertices, py::handle faces) {
    const py::array indices = py::array::ensure(faces);
    if (!indices) throw py::error_already_set();
    const char kind = indices.dtype().kind();
    if (kind != 'i' && kind != 'u' && indices.size() > 0) throw py::type_error("faces: integers are expected");
    if (indices.size() > 0 && (indices.ndim() != 2 || indices.shape(1) != 3)) {
        throw py::value_error("faces: the shape (n, 3) is expected, not " + shape_text(indices));
    }
    Doubles points = exact_doubles(vertices, "vertices");
    if (points.size() > 0) points = exact_points(points, "vertices");
    const std::span coordinates(points.data(), static_cast<std::size_t>(points.size()));
    const auto create = [&](const auto& numbers) {
        const std::span given(numbers.data(), static_cast<std::size_t>(numbers.size()));
        const py::gil_scoped_release release;
        return Mesh::create(coordinates, given);
    };
    if (py::isinstance<py::array_t<std::uint32_t>>(indices)) {
        return create(py::array_t<std::uint32_t, py::array::c_style | py::array::forcecast>::ensure(indices));
    }
    try {
        return create(py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>::ensure(indices));
    } catch (const InvalidMesh& error) {
        const bool is_negative = std::cmp_greater(error.index, std::numeric_limits<std::int64_t>::max());
        if (kind == 'i' && is_negative) raise_negative(error);
        throw;
    }
}

template <class Shape>
std::shared_ptr<Shape> make_shape(const std::shared_ptr<const Mesh>& mesh) {
    const py::gil_scoped_release release;
    return std::make_shared<Shape>(mesh);
}

// Returns a read-only array that refers to the memory of `rows` and keeps `owner`, the mesh, alive.
template <class Number, class Rows>
py::array view(const py::object& owner, const Rows& rows) {
    py::array array(py::dtype::of<Number>(), {static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}}, rows.data(),
                    owner);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

const Mesh& mesh_of(const py::object& self) {
    return self.cast<const MeshShape&>().mesh();
}

// Adds constructors from vertices and faces and, except for Mesh itself, from a Mesh. Also adds pickling by vertices
// and faces.
template <class Shape, class Type>
void add_making(Type& type) {
    type.def(py::init([](const py::object& vertices, const py::object& faces) {
                 return make_shape<Shape>(make_mesh(vertices, faces));
             }),
             py::arg("vertices"), py::arg("faces"),
             "Makes a mesh of vertices (n, 3), which are floats or integers that doubles hold exactly, in any unit, "
             "and faces (m, 3), which are indices of vertices. Raises InvalidMesh; raises TypeError or ValueError for "
             "other kinds of arrays.");
    type.def(py::pickle(
        [](const py::object& self) {
            return py::make_tuple(self.attr("vertices").attr("copy")(), self.attr("faces").attr("copy")());
        },
        [](const py::tuple& state) { return make_shape<Shape>(make_mesh(state[0], state[1])); }));
    if constexpr (!std::is_same_v<Shape, MeshShape>) {
        type.def(py::init([](const MeshShape& mesh) { return make_shape<Shape>(mesh.mesh_ptr()); }), py::arg("mesh"));
    }
}

std::string text_of(const py::object& self) {
    std::ostringstream text;
    text << "<ecods." << type_name(self) << " of " << mesh_of(self).vertices().size() << " vertices, "
         << mesh_of(self).triangles().size() << " triangles>";
    return text.str();
}

void add_mesh_calls(py::class_<MeshShape, std::shared_ptr<MeshShape>>& type) {
    type.def_property_readonly(
        "vertices", [](const py::object& self) { return view<double>(self, mesh_of(self).vertices()); },
        "(n, 3) float64: the mesh's own memory, read-only.");
    type.def_property_readonly(
        "faces", [](const py::object& self) { return view<std::uint32_t>(self, mesh_of(self).triangles()); },
        "(m, 3) uint32: the mesh's own memory, read-only.");
    type.def_property_readonly("digest", &MeshShape::digest,
                               "A hash of coordinates and indices, the same on every machine.");
    type.def_property_readonly("uses_all_vertices",
                               [](const MeshShape& self) { return self.mesh().uses_all_vertices(); });
    type.def_property_readonly("form", &MeshShape::form, "MeshForm: the set that this is.");
    type.def("tree_bytes", &MeshShape::tree_bytes, "The bytes of the tree, which is built if there is none yet.");
    type.def("box", &MeshShape::box, py::arg("pose") = py::none(),
             "A box (2, 3) that contains the posed mesh: fast, and close to the least such box. box_of() is closer.");
    type.def(
        "at", [](std::shared_ptr<MeshShape> self, const Pose& pose) { return PosedMesh(std::move(self), pose); },
        py::arg("pose"), "The mesh at a pose (4, 4) or (3, 4): the real points R v + t. Raises InvalidArgument.");
    type.def(
        "moving",
        [](std::shared_ptr<MeshShape> self, const Pose& from, const Pose& to) {
            return MovingMesh(std::move(self), from, to);
        },
        py::arg("start"), py::arg("end"),
        "The mesh on its way from one pose to another in the time from 0 to 1, each point on a straight line.");
    type.def(
        "refit",
        [](const MeshShape& self, const py::object& vertices) {
            const Doubles points = exact_points(vertices, "vertices");
            std::vector<Vec3> moved(static_cast<std::size_t>(points.shape(0)));
            std::copy_n(points.data(), points.size(), moved.empty() ? nullptr : moved.front().data());
            const py::gil_scoped_release release;
            return to_python(ecods::refit(self, std::move(moved)));
        },
        py::arg("vertices"),
        "The same triangles with other vertices (n, 3), as a new Mesh, a surface, whose tree is that of this one with "
        "new "
        "boxes. "
        "Raises InvalidMesh.");
    type.def("__repr__", &text_of);
    copies_are_itself(type);  // so that a copy shares the tree
}

void add_solids(py::module_& m) {
    py::class_<Solid, MeshShape, std::shared_ptr<Solid>> solid(
        m, "Solid",
        "A mesh that bounds a solid: closed and free of self-intersection, which is checked exactly. It is all points "
        "on and "
        "inside that surface, in every call that takes a Mesh; surface_of() is the surface alone. Raises NotSolid, "
        "which "
        "names the place.");
    add_making<Solid>(solid);

    py::class_<ConvexSolid, Solid, std::shared_ptr<ConvexSolid>> convex(
        m, "ConvexSolid",
        "A Solid without dents, or a flat convex set: a polygon that "
        "triangles tile, a segment or a point, which "
        "has no inner points. Raises NotSolid.");
    convex.def_property_readonly("dimension", &ConvexSolid::dimension,
                                 "3; of a polygon 2, of a segment 1 and of a point 0.");
    add_making<ConvexSolid>(convex);
    convex.def_static(
        "hull",
        [](const py::object& points) {
            const Doubles rows = exact_points(points, "points");
            const std::span given(reinterpret_cast<const Vec3*>(rows.data()), static_cast<std::size_t>(rows.shape(0)));
            const py::gil_scoped_release release;
            return std::make_shared<ConvexSolid>(given);
        },
        py::arg("points"),
        "The convex hull of points (n, 3), exactly: its vertices are those points that are no combination of others. "
        "Of points in one plane it is a polygon, a segment or a point. Raises InvalidMesh, NotSolid.");
}

std::shared_ptr<MeshShape> require(std::shared_ptr<MeshShape> mesh) {
    if (!mesh) throw InvalidArgument("mesh is null", Argument::null, "mesh");
    return mesh;
}

// Returns the mesh of a Posed or a Moving.
template <class Placed>
std::shared_ptr<MeshShape> mesh_in(const Placed& placed) {
    return to_python(placed.kept);
}

void add_places(py::class_<PosedMesh>& type) {
    type.def(py::init([](std::shared_ptr<MeshShape> mesh, const Pose& pose) {
                 return PosedMesh(require(std::move(mesh)), pose);
             }),
             py::arg("mesh"), py::arg("pose") = py::none(),
             "Mesh.at(pose): a Mesh, Solid or ConvexSolid at a pose (4, 4) or (3, 4), or where it is. Raises "
             "InvalidArgument.");
    type.def_property_readonly("mesh", &mesh_in<PosedMesh>, "The Mesh, Solid or ConvexSolid.");
    type.def_readonly("pose", &PosedMesh::pose, "(4, 4) float64.");
    type.def("__repr__", [](const PosedMesh& self) {
        return "Posed(" + text_of(py::cast(mesh_in(self))) + ", " + pose_text("pose", self.pose) + ")";
    });
    type.def(py::pickle([](const PosedMesh& self) { return py::make_tuple(mesh_in(self), self.pose); },
                        [](const py::tuple& state) {
                            return PosedMesh(require(state[0].cast<std::shared_ptr<MeshShape>>()),
                                             state[1].cast<Pose>());
                        }));
    py::implicitly_convertible<MeshShape, PosedMesh>();
}

void add_motions(py::class_<MovingMesh>& type) {
    type.def(py::init([](std::shared_ptr<MeshShape> mesh, const Pose& start, const Pose& end) {
                 return MovingMesh(require(std::move(mesh)), start, end);
             }),
             py::arg("mesh"), py::arg("start"), py::arg("end"), "Mesh.moving(start, end). Raises InvalidArgument.");
    type.def_property_readonly("mesh", &mesh_in<MovingMesh>);
    type.def_readonly("start", &MovingMesh::from, "(4, 4) float64.");
    type.def_readonly("end", &MovingMesh::to, "(4, 4) float64.");
    type.def("__repr__", [](const MovingMesh& self) {
        return "Moving(" + text_of(py::cast(mesh_in(self))) + ", " + pose_text("start", self.from) + ", " +
               pose_text("end", self.to) + ")";
    });
    type.def(py::pickle([](const MovingMesh& self) { return py::make_tuple(mesh_in(self), self.from, self.to); },
                        [](const py::tuple& state) {
                            return MovingMesh(require(state[0].cast<std::shared_ptr<MeshShape>>()),
                                              state[1].cast<Pose>(), state[2].cast<Pose>());
                        }));
}

}  // namespace

void bind_meshes(py::module_& m) {
    // Declares these types first, because signatures of Mesh name them.
    py::class_<PosedMesh> posed(m, "Posed",
                                "A mesh at a pose: the set of the real points R v + t. Mesh.at() makes one, too.");
    py::class_<MovingMesh> moving(
        m, "Moving",
        "A mesh on its way from one pose to another: each point goes straight. Mesh.moving() makes one, too.");
    py::class_<MeshShape, std::shared_ptr<MeshShape>> mesh(
        m, "Mesh",
        "Closed triangles, immutable: a surface, which need not be closed or connected. Triangles of zero area are the "
        "segments or points that they span. Its tree and other data for questions are made once, when first needed: "
        "keep the object to ask again. The given arrays are copied.");
    add_making<MeshShape>(mesh);
    add_mesh_calls(mesh);
    add_solids(m);
    add_places(posed);
    add_motions(moving);
    m.def(
        "box_of", [](const PosedMesh& body) { return box_of(body.what->mesh(), body.pose); }, py::arg("body"),
        "A box (2, 3) that contains the posed mesh and exceeds the least one by rounding only. One pass over "
        "vertices.");
}

}  // namespace ecods::python
