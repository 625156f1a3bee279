#include "python/bind/arrays.hpp"

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>

#include "python/bind/errors.hpp"

namespace ecods::python {
namespace {

// Doubles represent all integers up to this magnitude.
constexpr std::int64_t whole_max = std::int64_t{1} << 53;

py::array to_array(py::handle value, const char* what) {
    py::array array = value.is_none() ? py::array() : py::array::ensure(value);
    if (!array || value.is_none()) {
        PyErr_Clear();
        throw py::type_error(std::string(what) + ": numbers are expected, not " + type_name(value));
    }
    return array;
}

template <class Integer>
void require_whole(const py::array& array, const char* what) {
    const auto integers = py::array_t<Integer, py::array::c_style | py::array::forcecast>::ensure(array);
    for (const Integer x : std::span(integers.data(), static_cast<std::size_t>(integers.size()))) {
        const bool is_held = std::cmp_less_equal(x, whole_max) && std::cmp_greater_equal(x, -whole_max);
        if (!is_held) throw py::value_error(std::string(what) + ": " + std::to_string(x) + " may be no double");
    }
}

void require_shape(const Doubles& array, const char* what, std::span<const py::ssize_t> shape) {
    bool fits = array.ndim() == static_cast<py::ssize_t>(shape.size());
    std::string expected = "(";
    for (std::size_t i = 0; i < shape.size(); ++i) {
        fits = fits && (shape[i] == -1 || shape[i] == array.shape(static_cast<py::ssize_t>(i)));
        expected += (i == 0 ? "" : ", ") + (shape[i] == -1 ? std::string("n") : std::to_string(shape[i]));
    }
    expected += shape.size() == 1 ? ",)" : ")";
    if (!fits) {
        throw py::value_error(std::string(what) + ": the shape " + expected + " is expected, not " + shape_text(array));
    }
}

// Checks the shape of an array of poses, whose matrices begin at axis `first_axis`. Returns the number of entries of a
// pose: 16 or 12.
std::size_t pose_entries(const Doubles& array, py::ssize_t first_axis, const char* what) {
    const bool fits = array.ndim() == first_axis + 2 && array.shape(first_axis + 1) == 4 &&
                      (array.shape(first_axis) == 3 || array.shape(first_axis) == 4);
    if (!fits) {
        throw py::value_error(std::string(what) + ": the shape (4, 4) or (3, 4)" +
                              (first_axis == 0 ? "" : ", or k of them,") + " is expected, not " + shape_text(array));
    }
    return static_cast<std::size_t>(4 * array.shape(first_axis));
}

void require_pose(const double* entries, std::size_t count, ListIndex index) {
    try {
        validate(pose_of(entries));
        if (count == 16) static_cast<void>(Pose::from_matrix(Eigen::Matrix4d::Map(entries).transpose()));
    } catch (const InvalidArgument& error) {
        throw error.at({}, index);
    }
}

}  // namespace

std::string type_name(py::handle value) {
    return py::str(py::type::handle_of(value).attr("__name__"));
}

std::string shape_text(const py::array& array) {
    std::string text = "(";
    for (py::ssize_t i = 0; i < array.ndim(); ++i) text += (i == 0 ? "" : ", ") + std::to_string(array.shape(i));
    return text + (array.ndim() == 1 ? ",)" : ")");
}

Doubles exact_doubles(py::handle value, const char* what) {
    if (Doubles::check_(value)) return py::reinterpret_borrow<Doubles>(value);
    const py::array array = to_array(value, what);
    const char kind = array.dtype().kind();
    if (kind == 'i' && array.itemsize() == 8) require_whole<std::int64_t>(array, what);
    if (kind == 'u' && array.itemsize() == 8) require_whole<std::uint64_t>(array, what);
    if ((kind != 'f' && kind != 'i' && kind != 'u') || array.itemsize() > 8) {
        throw py::type_error(std::string(what) + ": floats or integers are expected, not " +
                             std::string(py::str(array.dtype())));
    }
    return py::array_t<double, py::array::c_style | py::array::forcecast>::ensure(array);
}

Doubles exact_doubles(py::handle value, const char* what, std::span<const py::ssize_t> shape) {
    Doubles array = exact_doubles(value, what);
    require_shape(array, what, shape);
    return array;
}

Doubles exact_points(py::handle value, const char* what) {
    constexpr std::array<py::ssize_t, 2> rows = {-1, 3};
    return exact_doubles(value, what, rows);
}

Vec3 to_vec3(py::handle value, const char* what) {
    constexpr std::array<py::ssize_t, 1> shape = {3};
    const Doubles array = exact_doubles(value, what, shape);
    return {array.data()[0], array.data()[1], array.data()[2]};
}

Aabb to_box(py::handle value) {
    constexpr std::array<py::ssize_t, 2> shape = {2, 3};
    const Doubles array = exact_doubles(value, "box", shape);
    const double* x = array.data();
    return {.min = {x[0], x[1], x[2]}, .max = {x[3], x[4], x[5]}};
}

Pose pose_of(const double* entries) {
    Pose pose;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) pose.R(row, column) = entries[4 * row + column];
        pose.t[row] = entries[4 * row + 3];
    }
    return pose;
}

Pose to_pose(py::handle value) {
    if (value.is_none()) return {};
    const Doubles array = exact_doubles(value, "pose");
    const std::size_t count = pose_entries(array, 0, "pose");
    require_pose(array.data(), count, {});
    return pose_of(array.data());
}

PoseList::PoseList(py::handle value, const char* what) {
    if (value.is_none()) {
        constexpr std::array<double, 12> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        array_ = Doubles(static_cast<py::ssize_t>(identity.size()), identity.data());
        data_ = array_.data();
        return;
    }
    array_ = exact_doubles(value, what);
    const py::ssize_t first_axis = array_.ndim() == 3 ? 1 : 0;
    const std::size_t entries = pose_entries(array_, first_axis, what);
    data_ = array_.data();
    if (first_axis == 1) {
        count_ = static_cast<std::size_t>(array_.shape(0));
        step_ = entries;
    }
    for (std::size_t i = 0; i < count_; ++i) {
        require_pose(data_ + i * step_, entries, first_axis == 1 ? ListIndex(i) : ListIndex());
    }
}

py::array_t<double> from_vec3(const Vec3& v) {
    return py::array_t<double>(3, v.data());
}

py::array_t<double> from_points(std::span<const Vec3> points) {
    py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
    if (!points.empty()) std::memcpy(array.mutable_data(), points.data(), points.size_bytes());
    return array;
}

py::array_t<double> from_box(const Aabb& box) {
    const std::array<Vec3, 2> corners = {box.min, box.max};
    return from_points(corners);
}

py::array_t<double> from_pose(const Pose& pose) {
    py::array_t<double> array({4, 4});
    auto entry = array.mutable_unchecked<2>();
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) entry(row, column) = pose.R(row, column);
        entry(row, 3) = pose.t[row];
        entry(3, row) = 0;
    }
    entry(3, 3) = 1;
    return array;
}

py::array_t<std::uint64_t> from_bodies(std::span<const BodyId> bodies) {
    py::array_t<std::uint64_t> array(static_cast<py::ssize_t>(bodies.size()));
    std::transform(bodies.begin(), bodies.end(), array.mutable_data(), number_of);
    return array;
}

py::array_t<std::uint64_t> from_pairs(std::span<const BodyPair> pairs) {
    return from_named_pairs<std::uint64_t>(pairs, number_of);
}

py::array_t<std::uint32_t> from_triangles(std::span<const TrianglePair> pairs) {
    return from_named_pairs<std::uint32_t>(pairs, std::identity());
}

namespace {

// Throws StaleBody for the first number that is negative. `kind` is the kind of the array's numpy type.
void require_ids(const py::array& array, char kind) {
    if (kind != 'i') return;
    const auto numbers = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>::ensure(array);
    const std::span given(numbers.data(), static_cast<std::size_t>(numbers.size()));
    const auto found = std::ranges::find_if(given, [](std::int64_t x) { return x < 0; });
    if (found != given.end()) raise_stale(py::int_(*found), static_cast<std::size_t>(found - given.begin()));
}

}  // namespace

std::vector<BodyId> to_bodies(py::handle value) {
    const py::array array = to_array(value, "bodies");
    const char kind = array.dtype().kind();
    const bool is_empty = array.size() == 0;  // numpy makes an array of floats from an empty list
    if (array.ndim() != 1 || (kind != 'u' && kind != 'i' && !is_empty)) {
        throw py::type_error("bodies: one axis of ids is expected, not " + shape_text(array) + " of " +
                             std::string(py::str(array.dtype())));
    }
    require_ids(array, kind);
    const auto numbers = py::array_t<std::uint64_t, py::array::c_style | py::array::forcecast>::ensure(array);
    std::vector<BodyId> bodies(static_cast<std::size_t>(numbers.size()));
    std::transform(numbers.data(), numbers.data() + numbers.size(), bodies.begin(), body_of);
    return bodies;
}

namespace {

PoseList poses_of_bodies(py::handle value, std::span<const BodyId> bodies) {
    try {
        return PoseList(value, "poses");
    } catch (const InvalidArgument& error) {
        const bool is_of_body = error.index && *error.index < bodies.size();
        throw error.at(is_of_body ? bodies[*error.index] : BodyId(), error.index);
    }
}

}  // namespace

std::vector<Pose> to_poses(py::handle value, std::span<const BodyId> bodies) {
    const PoseList list = poses_of_bodies(value, bodies);
    if (list.is_single()) throw py::value_error("poses: one for each body is expected");
    std::vector<Pose> poses;
    poses.reserve(list.size());
    for (std::size_t i = 0; i < list.size(); ++i) poses.push_back(list[i]);
    return poses;
}

}  // namespace ecods::python
