// The module _armtune, which the package armtune shows.

#include <pybind11/stl.h>

#include <exception>
#include <stdexcept>

#include "core/common/error.hpp"
#include "core/common/message_text.hpp"
#include "python/bindings.hpp"
#include "python/work.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/run_folder.hpp"

namespace py = pybind11;

namespace armtune::python {
namespace {

PyObject* refuse_new(PyTypeObject* type, PyObject*, PyObject*) {
  PyErr_Format(PyExc_TypeError, "%s: only armtune's functions, such as load_scenario and simulate, make one",
               type->tp_name);
  return nullptr;
}

/// Messages of the library may quote names of files that are not UTF-8, of which Python can make no text.
void translate(std::exception_ptr raised) {
  try {
    if (raised) std::rethrow_exception(raised);
  } catch (const py::builtin_exception&) {
    throw;
  } catch (const InputError&) {
    throw;  // is UTF-8, and has a type of its own
  } catch (const std::runtime_error& error) {
    PyErr_SetString(PyExc_RuntimeError, one_line(error.what()).c_str());
  }
}

}  // namespace

py::custom_type_setup made_by_armtune() {
  return py::custom_type_setup([](PyHeapTypeObject* type) { type->ht_type.tp_new = refuse_new; });
}

}  // namespace armtune::python

PYBIND11_MODULE(_armtune, module) {
  using namespace armtune;
  module.doc() = "Offline trajectory and gain tuning for robot arms.";
  py::register_exception_translator(&python::translate);
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  python::bind_gains(module);
  python::bind_rollouts(module);
  python::bind_tuning(module);
  // Objects of one class must not become those of another: "rollout.__class__ = Scenario".
  for (const char* name : {"Gains", "Scenario", "Rollout", "Study", "Tuned"}) {
    reinterpret_cast<PyTypeObject*>(module.attr(name).ptr())->tp_flags |= Py_TPFLAGS_IMMUTABLETYPE;
  }
  py::module_::import("atexit").attr("register")(py::cpp_function(&python::end_all_work));
  module.def(
      "versions", [] { return versions(); }, "(name, version) of armtune and every library in use.");
  module.def("bundled", &bundled_names, py::arg("folder"),
             "Names of what is bundled: robots, scenarios, gains, studies, tasks, theta.");
  module.def(
      "arithmetic", [] { return std::pair(arithmetic().level, arithmetic().fingerprint); },
      "Which variants of sin, exp ... this process computes with: level and fingerprint.");
  module.def("baseline_tunables", &baseline_tunables, py::arg("set"),
             "A value of GLIBC_TUNABLES that asks for the variants that every x86-64 processor has.");
}
