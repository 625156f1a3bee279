// Numbers in and out of numpy, none of them rounded.
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "ecods/aabb.hpp"
#include "ecods/ids.hpp"
#include "ecods/pose.hpp"

namespace ecods::python {

namespace py = pybind11;

// Doubles side by side, row by row.
using Doubles = py::array_t<double, py::array::c_style>;

// The numbers of an array, or of what numpy makes one of. Throws TypeError where they are not numbers; ValueError where
// one is an integer that no double is. `what` names the argument in messages.
Doubles exact_doubles(py::handle value, const char* what);

// The same, of this shape; -1 stands for any length. Throws ValueError otherwise.
Doubles exact_doubles(py::handle value, const char* what, std::span<const py::ssize_t> shape);

// The same of points, (n, 3).
Doubles exact_points(py::handle value, const char* what);

// "(3, 4)"
std::string shape_text(const py::array& array);

// "list"
std::string type_name(py::handle value);

Vec3 to_vec3(py::handle value, const char* what);

// A box: (2, 3), its least corner first.
Aabb to_box(py::handle value);

// One pose: (4, 4) with a last row of 0 0 0 1, (3, 4), or None, which is where the mesh is. Throws InvalidArgument.
Pose to_pose(py::handle value);

// The pose of 12 doubles, row by row; four more may follow. It is not checked.
Pose pose_of(const double* entries);

// Poses one after the other: (k, 4, 4) or (k, 3, 4); or one, which then stands for as many as are asked for. All of
// them are checked when the list is made: InvalidArgument names the entry.
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
    std::size_t step_ = 0;  // 0: one for all
};

// New arrays.
py::array_t<double> from_vec3(const Vec3& v);
py::array_t<double> from_points(std::span<const Vec3> points);  // (n, 3)
py::array_t<double> from_box(const Aabb& box);                  // (2, 3)
py::array_t<double> from_pose(const Pose& pose);                // (4, 4)

template <class Number>
py::array_t<Number> from_numbers(const std::vector<Number>& numbers) {
    return py::array_t<Number>(static_cast<py::ssize_t>(numbers.size()), numbers.data());
}

// A row for each pair, (n, 2), with number_of(name) of its two names.
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

// A body as a number, and back. What no body has becomes the null id, which every call refuses as stale.
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
// The poses that bodies are to have, checked as PoseList does; errors name the body, as World::set_poses does.
std::vector<Pose> to_poses(py::handle value, std::span<const BodyId> bodies);

}  // namespace ecods::python
