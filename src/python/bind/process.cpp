// Binds settings of the whole process, and small helpers.
#include <sstream>

#include "ecods/export.hpp"
#include "ecods/pose.hpp"
#include "python/bind/bind.hpp"
#include "python/bind/casters.hpp"

namespace ecods::python {
namespace {

Pose make_pose(const Vec3& t, const py::object& R, const py::object& quaternion) {
    if (!R.is_none() && !quaternion.is_none()) throw py::value_error("pose: a matrix or a quaternion, not both");
    Pose pose{.R = Mat3::Identity(), .t = t};
    if (!R.is_none()) {
        constexpr std::array<py::ssize_t, 2> shape = {3, 3};
        const Doubles rows = exact_doubles(R, "R", shape);
        for (int i = 0; i < 9; ++i) pose.R(i / 3, i % 3) = rows.data()[i];
    } else if (!quaternion.is_none()) {
        constexpr std::array<py::ssize_t, 1> shape = {4};
        const Doubles given = exact_doubles(quaternion, "quaternion", shape);
        const double* q = given.data();
        pose = Pose::from_quaternion(Eigen::Quaterniond(q[0], q[1], q[2], q[3]), t);
    }
    validate(pose);
    return pose;
}

}  // namespace

void bind_process(py::module_& m) {
    m.attr("__version__") = ECODS_PYTHON_VERSION;
    m.def("pose", &make_pose, py::arg("t") = py::make_tuple(0, 0, 0), py::arg("R") = py::none(),
          py::arg("quaternion") = py::none(),
          "A pose (4, 4) of a translation (3,) and a matrix (3, 3), or a quaternion (w, x, y, z), taken as it is: not "
          "normalised. Raises InvalidArgument.");
    m.def(
        "body_name",
        [](BodyId body) {
            std::ostringstream text;
            text << body;
            return text.str();
        },
        py::arg("body"), "The name of a body in messages and traces: slot and generation, \"3.1\".");
    m.def("supported_instruction_set", &supported_instruction_set, "The widest InstructionSet of this processor.");
    m.def("instruction_set", &instruction_set,
          "The InstructionSet in use: one for the process. No answer depends on it.");
    m.def("limit_instruction_set", &limit_instruction_set, py::arg("widest"),
          "Forbids wider instruction sets from now on.");
}

}  // namespace ecods::python
