// Shortens the error for arguments that fit no signature to one line.
#include <string>

#include "python/bind/bind.hpp"

namespace ecods::python {
namespace {

namespace py = pybind11;

// `dispatcher` is the function of pybind11 behind all functions that it binds: it selects the overload and converts
// arguments.
PyCFunctionWithKeywords dispatcher = nullptr;

// If Python's current error is about arguments that no overload takes, replaces the error's text by one line.
void shorten(PyObject* args, PyObject* kwargs) {
    py::error_already_set refused;
    try {
        const std::string text = py::str(refused.value());
        if (text.find("(): incompatible ") == std::string::npos) return refused.restore();
        const py::object line =
            py::module_::import("ecods.refusals")
                .attr("line")(text, py::reinterpret_borrow<py::tuple>(args),
                              kwargs == nullptr ? py::dict() : py::reinterpret_borrow<py::dict>(kwargs));
        PyErr_SetObject(PyExc_TypeError, line.ptr());
    } catch (py::error_already_set& failure) {
        failure.restore();
    }
}

PyObject* call(PyObject* self, PyObject* args, PyObject* kwargs) {
    PyObject* const result = dispatcher(self, args, kwargs);
    if (result == nullptr && PyErr_ExceptionMatches(PyExc_TypeError) != 0) shorten(args, kwargs);
    return result;
}

PyCFunctionWithKeywords as_called(PyCFunction function) {
    return reinterpret_cast<PyCFunctionWithKeywords>(reinterpret_cast<void (*)()>(function));
}

PyMethodDef& definition_of(PyObject* function) {
    return *reinterpret_cast<PyCFunctionObject*>(function)->m_ml;
}

// Replaces pybind11's function behind one bound function by call(). Leaves other functions unchanged, because classes
// also have functions of Python's own.
void shorten_one(py::handle value) {
    PyObject* function = value.ptr();
    const py::object of_static = py::getattr(value, "__func__", py::none());
    if (Py_TYPE(function) == &PyStaticMethod_Type) function = of_static.ptr();
    if (PyInstanceMethod_Check(function)) function = PyInstanceMethod_GET_FUNCTION(function);
    if (PyCFunction_Check(function) == 0) return;
    PyMethodDef& definition = definition_of(function);
    if (as_called(definition.ml_meth) != dispatcher) return;
    definition.ml_meth = reinterpret_cast<PyCFunction>(reinterpret_cast<void (*)()>(&call));
}

}  // namespace

void shorten_refusals(const py::module_& m) {
    const py::cpp_function any([] {});
    // A pybind11 with another calling convention is left unchanged.
    if (definition_of(any.ptr()).ml_flags != (METH_VARARGS | METH_KEYWORDS)) return;
    dispatcher = as_called(definition_of(any.ptr()).ml_meth);
    for (const auto& item : m.attr("__dict__").cast<py::dict>()) {
        if (!py::isinstance<py::type>(item.second)) {
            shorten_one(item.second);
            continue;
        }
        for (const auto& member : py::dict(item.second.attr("__dict__"))) shorten_one(member.second);
    }
}

}  // namespace ecods::python
