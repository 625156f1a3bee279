// Binds primitives.hpp: exact predicates over arrays.
#include "ecods/primitives.hpp"

#include <algorithm>
#include <cmath>

#include "ecods/error.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {
namespace {

// Rows holds an argument: points, triangles or poses. Its last axes have the lengths `tail`. All axes before them
// follow numpy's rules of broadcasting.
class Rows {
  public:
    Rows(const py::object& value, const char* what, std::vector<py::ssize_t> tail) : tail_(std::move(tail)) {
        array_ = exact_doubles(value, what);
        const auto axes = static_cast<py::ssize_t>(tail_.size());
        bool fits = array_.ndim() >= axes;
        for (py::ssize_t i = 0; fits && i < axes; ++i) fits = array_.shape(array_.ndim() - axes + i) == tail_[i];
        if (!fits) throw py::value_error(std::string(what) + ": has the shape " + shape_text(array_));
        for (const double& x : std::span(array_.data(), static_cast<std::size_t>(array_.size()))) {
            if (!std::isfinite(x)) refuse(x);
        }
    }

    py::tuple leading_shape() const {
        py::tuple shape(array_.ndim() - static_cast<py::ssize_t>(tail_.size()));
        for (std::size_t i = 0; i < shape.size(); ++i) shape[i] = array_.shape(static_cast<py::ssize_t>(i));
        return shape;
    }

    // Broadcasts the rows so that their leading axes have the shape `leading`.
    void spread(const py::tuple& leading) {
        step_ = size_of_one();
        if (array_.size() == static_cast<py::ssize_t>(step_)) {
            step_ = 0;
        } else if (!leading_shape().equal(leading)) {
            const py::object numpy = py::module_::import("numpy");
            const py::tuple full = leading + py::cast<py::tuple>(py::cast(tail_).attr("__iter__")());
            array_ = exact_doubles(numpy.attr("ascontiguousarray")(numpy.attr("broadcast_to")(array_, full)), "points");
        }
        data_ = array_.data();
    }

    const double* operator[](std::size_t i) const { return data_ + i * step_; }

  private:
    std::size_t size_of_one() const {
        std::size_t size = 1;
        for (const py::ssize_t n : tail_) size *= static_cast<std::size_t>(n);
        return size;
    }
    // Throws InvalidArgument for a coordinate that is not finite, with the text that locate() uses for a point.
    [[noreturn]] void refuse(const double& x) const {
        const auto at = static_cast<std::size_t>(&x - array_.data());
        const std::string axis = std::to_string(at % static_cast<std::size_t>(tail_.back()));
        const std::string value = py::str(py::float_(x));
        throw InvalidArgument("point, axis " + axis + ": coordinate is " + value + ", not finite", Argument::point,
                              "(" + axis + ")", x);
    }

    std::vector<py::ssize_t> tail_;
    Doubles array_;
    const double* data_ = nullptr;
    std::size_t step_ = 0;
};

// Returns answer(i) for all rows i, as an array whose shape is the common shape of the leading axes, or as a single
// answer if there are no leading axes.
template <class Answer, class Function>
py::object over(std::vector<Rows>& rows, const Function& answer) {
    py::list shapes;
    for (const Rows& each : rows) shapes.append(each.leading_shape());
    const py::tuple leading = py::module_::import("numpy").attr("broadcast_shapes")(*shapes);
    for (Rows& each : rows) each.spread(leading);
    if (leading.empty()) return py::cast(answer(std::size_t{0}));
    std::vector<py::ssize_t> shape;
    for (const auto& n : leading) shape.push_back(n.cast<py::ssize_t>());
    py::array_t<std::int8_t> answers(shape);
    std::int8_t* const out = answers.mutable_data();
    const auto count = static_cast<std::size_t>(answers.size());
    const py::gil_scoped_release release;
    for (std::size_t i = 0; i < count; ++i) out[i] = static_cast<std::int8_t>(answer(i));
    return answers;
}

Vec3 vec3(const double* x) {
    return {x[0], x[1], x[2]};
}

std::array<Vec3, 3> corners(const double* x) {
    return {vec3(x), vec3(x + 3), vec3(x + 6)};
}

// Appends the poses to `rows`, after the points. `poses` is a sequence with an item for each point: an array (..., 4,
// 4), or None.
void add_poses(std::vector<Rows>& rows, const py::object& poses) {
    const auto sequence = py::cast<py::sequence>(poses);
    const std::size_t count = rows.size();
    if (sequence.size() != count) throw py::value_error("poses: one for each argument is expected, or None");
    const py::object identity = from_pose({});
    for (std::size_t i = 0; i < count; ++i) {
        const py::object given = sequence[i];
        const Doubles pose = exact_doubles(given.is_none() ? identity : given, "poses");
        const PoseList checked(pose.attr("reshape")(-1, 4, 4), "poses");
        rows.emplace_back(pose, "poses", std::vector<py::ssize_t>{4, 4});
    }
}

py::object orient2d_of(const py::object& a, const py::object& b, const py::object& c) {
    std::vector<Rows> rows = {{a, "a", {2}}, {b, "b", {2}}, {c, "c", {2}}};
    const auto point = [&](std::size_t k, std::size_t i) { return Vec2(rows[k][i][0], rows[k][i][1]); };
    return over<Sign>(rows, [&](std::size_t i) { return orient2d(point(0, i), point(1, i), point(2, i)); });
}

py::object orient2d_along(const py::object& a, const py::object& b, const py::object& c, int axis,
                          const py::object& poses) {
    if (axis < 0 || axis > 2) throw py::value_error("axis: 0 to 2 is expected");
    std::vector<Rows> rows = {{a, "a", {3}}, {b, "b", {3}}, {c, "c", {3}}};
    add_poses(rows, poses.is_none() ? py::make_tuple(py::none(), py::none(), py::none()) : poses);
    const auto at = [&](std::size_t k, std::size_t i) { return PosedPoint{pose_of(rows[k + 3][i]), vec3(rows[k][i])}; };
    return over<Sign>(rows, [&](std::size_t i) { return orient2d(at(0, i), at(1, i), at(2, i), axis); });
}

py::object orient3d_of(const py::object& a, const py::object& b, const py::object& c, const py::object& d,
                       const py::object& poses) {
    std::vector<Rows> rows = {{a, "a", {3}}, {b, "b", {3}}, {c, "c", {3}}, {d, "d", {3}}};
    if (poses.is_none()) {
        const auto point = [&](std::size_t k, std::size_t i) { return vec3(rows[k][i]); };
        return over<Sign>(rows,
                          [&](std::size_t i) { return orient3d(point(0, i), point(1, i), point(2, i), point(3, i)); });
    }
    add_poses(rows, poses);
    const auto at = [&](std::size_t k, std::size_t i) { return PosedPoint{pose_of(rows[k + 4][i]), vec3(rows[k][i])}; };
    return over<Sign>(rows, [&](std::size_t i) { return orient3d(at(0, i), at(1, i), at(2, i), at(3, i)); });
}

py::object triangles_of(const py::object& a, const py::object& b, const py::object& poses) {
    std::vector<Rows> rows = {{a, "a", {3, 3}}, {b, "b", {3, 3}}};
    if (poses.is_none()) {
        return over<Relation>(
            rows, [&](std::size_t i) { return triangle_triangle(corners(rows[0][i]), corners(rows[1][i])); });
    }
    add_poses(rows, poses);
    const auto at = [&](std::size_t k, std::size_t i) {
        return PosedTriangle{pose_of(rows[k + 2][i]), corners(rows[k][i])};
    };
    return over<Relation>(rows, [&](std::size_t i) { return triangle_triangle(at(0, i), at(1, i)); });
}

}  // namespace

void bind_predicates(py::module_& m) {
    const auto poses = py::arg("poses") = py::none();
    m.def("orient2d", &orient2d_of, py::arg("a"), py::arg("b"), py::arg("c"),
          "The sign of det(b - a, c - a) of points (..., 2): positive for a left turn. A Sign, or int8 values of Sign "
          "over the common leading axes. Exact. Raises InvalidArgument, as all predicates do.");
    m.def("orient2d_along", &orient2d_along, py::arg("a"), py::arg("b"), py::arg("c"), py::arg("axis"), poses,
          "orient2d of points (..., 3), at poses (..., 4, 4) of their own, seen along an axis: of coordinates (axis + "
          "1) mod 3 and (axis + 2) mod 3. `poses` has one for each point, or None. Exact for the real points.");
    m.def("orient3d", &orient3d_of, py::arg("a"), py::arg("b"), py::arg("c"), py::arg("d"), poses,
          "The sign of det(b - a, c - a, d - a) of points (..., 3): positive when d is where (b - a) x (c - a) points. "
          "With `poses`, of the real points R v + t. Exact.");
    m.def("triangle_triangle", &triangles_of, py::arg("a"), py::arg("b"), poses,
          "Relation of triangles (..., 3, 3), or int8 values of Relation. With `poses`, of the real points. Exact.");
}

}  // namespace ecods::python
