// Converts numbers from and to numpy arrays without rounding.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ecods/ids.hpp"
#include "ecods/pose.hpp"
#include "ecods/primitives.hpp"

namespace ecods::python {

namespace py = pybind11;

// Doubles is an array of contiguous doubles, row by row.
using Doubles = py::array_t<double, py::array::c_style>;

// Returns the numbers of an array, or of an object that numpy converts to an array. Throws TypeError if they are not
// numbers, and ValueError if an integer is not exactly representable as a double. `what` names the argument in
// messages.
Doubles exact_doubles(py::handle value, const char* what);

// Returns the numbers of an array of this shape, in which -1 stands for any length. Throws TypeError and ValueError as
// the function above, and ValueError for any other shape.
Doubles exact_doubles(py::handle value, const char* what, std::span<const py::ssize_t> shape);

// Returns the numbers of an array of points, whose shape is (n, 3).
Doubles exact_points(py::handle value, const char* what);

// Returns the shape of the array as text, such as "(3, 4)".
std::string shape_text(const py::array& array);

// Returns the name of the value's type, such as "list".
std::string type_name(py::handle value);

Vec3 to_vec3(py::handle value, const char* what);

// Returns the box of an array (2, 3); the first row is its min, the second its max.
Aabb to_box(py::handle value);

// Returns the pose of an array: (4, 4) with a last row of 0 0 0 1, or (3, 4). None stands for the identity. Throws
// InvalidArgument.
Pose to_pose(py::handle value);

// Returns the pose whose matrix is the first 12 entries, row by row. Does not check the entries.
Pose pose_of(const double* entries);

// A PoseList holds a list of poses, (k, 4, 4) or (k, 3, 4), or a single pose, which it returns for every index. The
// constructor checks all poses and throws InvalidArgument, which names the index of the first bad pose.
class PoseList {
  public:
    explicit PoseList(py::handle value, const char* what);

    bool is_single() const noexcept { return step_ == 0; }
    std::size_t size() const noexcept { return count_; }
    Pose operator[](std::size_t index) const { return pose_of(data_ + index * step_); }

  private:
    Doubles array_;
    const double* data_ = nullptr;
    std::size_t count_ = 1;
    std::size_t step_ = 0;  // number of doubles from one pose to the next; 0 for a single pose
};

// The functions from_ return new arrays.
py::array_t<double> from_vec3(const Vec3& v);
py::array_t<double> from_points(std::span<const Vec3> points);  // (n, 3)
py::array_t<double> from_box(const Aabb& box);                  // (2, 3)
py::array_t<double> from_pose(const Pose& pose);                // (4, 4)

template <class Number>
py::array_t<Number> from_numbers(const std::vector<Number>& numbers) {
    return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

// Returns an array (n, 2) with a row for each pair: number_of(pair.a) and number_of(pair.b).
template <class Number, class Pairs, class NumberOf>
py::array_t<Number> from_named_pairs(const Pairs& pairs, const NumberOf& number_of) {
    py::array_t<Number> array({static_cast<py::ssize_t>(pairs.size()), py::ssize_t{2}});
    Number* out = array.mutable_data();
    for (const auto& pair : pairs) {
        *out++ = number_of(pair.a);
        *out++ = number_of(pair.b);
    }
    return array;
}

// Convert a body id to Python's number and back. A number that names no body becomes an id that no body has, which
// every call rejects as stale.
constexpr std::uint64_t number_of(BodyId body) noexcept {
    return body.rank();
}
constexpr BodyId body_of(std::uint64_t number) noexcept {
    return {.slot = static_cast<std::uint32_t>(number >> 32),
            .generation = static_cast<std::uint16_t>(number >> 16),
            .world = static_cast<std::uint16_t>(number)};
}

py::array_t<std::uint64_t> from_bodies(std::span<const BodyId> bodies);          // (n,)
py::array_t<std::uint64_t> from_pairs(std::span<const BodyPair> pairs);          // (n, 2)
py::array_t<std::uint32_t> from_triangles(std::span<const TrianglePair> pairs);  // (n, 2)
std::vector<BodyId> to_bodies(py::handle value);
// Returns poses for `bodies`, checked like the poses of a PoseList. Errors name the body, as the errors of
// World::set_poses do.
std::vector<Pose> to_poses(py::handle value, std::span<const BodyId> bodies);

}  // namespace ecods::python
