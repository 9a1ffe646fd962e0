// The module _armtune, which the package armtune shows.

#include <pybind11/stl.h>

#include "core/common/error.hpp"
#include "python/bindings.hpp"
#include "sim/scenario/data_files.hpp"
#include "tuner/run/arithmetic.hpp"
#include "tuner/run/run_folder.hpp"

namespace py = pybind11;

PYBIND11_MODULE(_armtune, module) {
  using namespace armtune;
  module.doc() = "Offline trajectory and gain tuning for robot arms.";
  py::register_exception<InputError>(module, "InputError", PyExc_ValueError);
  python::bind_gains(module);
  python::bind_rollouts(module);
  python::bind_tuning(module);
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
