// Defines the module _armtune, whose names the package armtune exports.

#include <pybind11/stl.h>

#include <exception>
#include <stdexcept>
#include <string>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/message_text.hpp"
#include "python/bindings.hpp"
#include "python/watched.hpp"
#include "tuner/run/arithmetic.hpp"

namespace py = pybind11;

namespace armtune::internal::python {
namespace {

PyObject* refuse_new(PyTypeObject* type, PyObject*, PyObject*) {
  PyErr_Format(PyExc_TypeError, "%s: cannot be created directly; call a function of armtune that returns it",
               type->tp_name);
  return nullptr;
}

}  // namespace

void raise_interrupted(py::object result) {
  const py::object type = py::module_::import("armtune").attr("Interrupted");
  const py::object error = type("interrupted; the attribute 'result' holds the results so far");
  error.attr("result") = std::move(result);
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

void issue_warnings(const std::vector<std::string>& sentences) {
  for (const std::string& sentence : sentences) {
    if (PyErr_WarnEx(PyExc_UserWarning, sentence.c_str(), 1) != 0) throw py::error_already_set();
  }
}

/// Returns a Python string that keeps the bytes of a path that are not UTF-8; None if the text is empty.
py::object text_or_none(const std::string& text) {
  if (text.empty()) return py::none();
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeFSDefaultAndSize(text.data(), static_cast<Py_ssize_t>(text.size())));
}

void raise_input_error(const InputError& error) {
  const py::object type = py::module_::import("armtune._armtune").attr("InputError");
  const py::object raised = type(error.what());
  raised.attr("file") = text_or_none(error.place().file);
  if (error.place().line > 0) raised.attr("line") = error.place().line;
  raised.attr("key") = text_or_none(error.place().key);
  raised.attr("value") = text_or_none(error.value());
  raised.attr("limit") = text_or_none(error.limit());
  PyErr_SetObject(type.ptr(), raised.ptr());
}

/// Binds InputError, with the place, the value and the limit as attributes. Unknown attributes are None.
void bind_input_error(py::module_& module, const py::object& error) {
  // It is also a ValueError, Python's exception for an argument with an unsuitable value.
  const py::tuple bases = py::make_tuple(error, py::handle(PyExc_ValueError));
  const auto& type = py::register_exception<InputError>(module, "InputError", bases);
  for (const char* name : {"file", "line", "key", "value", "limit"}) type.attr(name) = py::none();
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      std::rethrow_exception(std::move(thrown));
    } catch (const InputError& input_error) {
      raise_input_error(input_error);
    }
  });
}

void bind_progress(py::module_& module) {
  py::class_<Progress>(module, "Progress", made_by_armtune(), "Progress of one part of the work.")
      .def_readonly("work", &Progress::work, "Name of the part.")
      .def_readonly("done", &Progress::done)
      .def_readonly("all", &Progress::all, "Final value of done; 0 if not known.")
      .def_readonly("seconds_left", &Progress::seconds_left, "Estimated time left [s]; nan if not known.")
      .def_readonly("detail", &Progress::detail, "The best result so far, or the state of the work.");
}

py::custom_type_setup made_by_armtune() {
  return py::custom_type_setup([](PyHeapTypeObject* type) { type->ht_type.tp_new = refuse_new; });
}

}  // namespace armtune::internal::python

PYBIND11_MODULE(_armtune, module) {
  using namespace armtune::internal;
  module.doc() = "Offline gain tuning and trajectory planning for robot arms.";
  const auto error = py::register_exception<armtune::Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<armtune::FailedError>(module, "FailedError", error);
  python::bind_input_error(module, error);
  python::bind_progress(module);
  python::bind_gains(module);
  python::bind_rollouts(module);
  python::bind_studies(module);
  python::bind_searches(module);
  python::bind_robustness(module);
  python::bind_models(module);
  python::bind_controllers(module);
  // This prevents changes of an object's class, such as "rollout.__class__ = Scenario".
  for (const py::handle item : module.attr("__dict__").attr("values")()) {
    if (py::isinstance<py::type>(item) &&
        !PyType_IsSubtype(reinterpret_cast<PyTypeObject*>(item.ptr()),
                          reinterpret_cast<PyTypeObject*>(PyExc_BaseException)))
      reinterpret_cast<PyTypeObject*>(item.ptr())->tp_flags |= Py_TPFLAGS_IMMUTABLETYPE;
  }
  py::module_::import("atexit").attr("register")(py::cpp_function(&python::end_all_work));
  module.def(
      "arithmetic", [] { return std::pair(arithmetic().level, arithmetic().fingerprint); },
      "Returns (level, fingerprint). level: which variants of sin, exp and similar functions this process "
      "uses. fingerprint: a hash of the results of these functions.");
  module.def(
      "baseline_tunables", &baseline_tunables, py::arg("set"),
      "Returns a value of the environment variable GLIBC_TUNABLES with which glibc uses only instructions "
      "that every x86-64 processor has. set: the present value; its other settings are kept.");
}
