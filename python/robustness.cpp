// Binds the simulation of gains on random arms, and stability margins.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "armtune/robustness.hpp"
#include "core/common/utf8.hpp"
#include "python/bindings.hpp"
#include "python/watched.hpp"

namespace py = pybind11;

namespace armtune::internal::python {
namespace {

using armtune::Gains;
using armtune::Margin;
using armtune::Margins;
using armtune::Scenario;

void bind_samples(py::module_& module) {
  py::class_<RobustnessSample>(module, "RobustnessSample", made_by_armtune(),
                               "One random arm, simulated in every scenario.")
      .def_readonly("number", &RobustnessSample::number)
      .def_readonly("rollouts", &RobustnessSample::rollouts,
                    "One rollout for each scenario, without recordings.")
      .def_readonly("broken", &RobustnessSample::broken,
                    "The limit that was broken first in each scenario; empty if none was broken.")
      .def_property_readonly("keeps_all", &RobustnessSample::keeps_all);
  py::class_<Robustness>(module, "Robustness", made_by_armtune(), "Results of gains on random arms.")
      .def_readonly("samples", &Robustness::samples)
      .def_property_readonly("yield_", &Robustness::yield,
                             "Share of the random arms that keep every limit; nan without samples.")
      .def_readonly("verdict", &Robustness::verdict)
      .def_readonly("files", &Robustness::files, "Names of the files in the run folder.");
  module.def(
      "robustness",
      [](const std::vector<Scenario>& scenarios, const Gains& gains, std::uint64_t samples,
         std::uint64_t seed, const std::map<std::string, double>& perturbation, const MaybePath& distribution,
         const std::string& engine, const MaybePath& folder, bool resume, int workers, double deadline,
         py::object progress) {
        RobustnessOptions options{
            text_of(folder),   resume,  samples,  seed, perturbation, text_of(distribution),
            engine_of(engine), workers, deadline, {}};
        return watched(std::move(progress), [&, set = gains](const Watch& watch) {
          options.watch = watch;
          return armtune::robustness(scenarios, set, options);
        });
      },
      py::arg("scenarios"), py::arg("gains"), py::kw_only(), py::arg("samples") = 1000, py::arg("seed") = 1,
      py::arg("perturbation") = std::map<std::string, double>(), py::arg("distribution") = py::none(),
      py::arg("engine") = "simbody", py::arg("folder") = py::none(), py::arg("resume") = false,
      py::arg("workers") = 1, py::arg("deadline") = 0.0, py::arg("progress") = py::none(),
      "Simulates gains on random arms. perturbation: a dict with the width of each random change. Its keys "
      "are mass, center, inertia, rotor, friction, payload, delay, noise, theta and target_speed. Keys left "
      "out have default widths. distribution: a file with a joint distribution, such as the uncertainty.yaml "
      "of a calibration, from which friction, rotor inertia, gains of drives, delay, payload, tilt and encoder "
      "offsets are drawn instead.");
}

void bind_margins(py::module_& module) {
  py::class_<Margin>(module, "Margin", made_by_armtune(),
                     "A stability margin: how far one quantity can change in one scenario.")
      .def_readonly("kind", &Margin::kind)
      .def_readonly("unit", &Margin::unit)
      .def_readonly("scenario", &Margin::scenario)
      .def_readonly("nominal", &Margin::nominal)
      .def_readonly("stands", &Margin::stands, "The last value that passed; None if the nominal value fails.")
      .def_readonly("fails", &Margin::fails,
                    "The first value that failed; None if all values that were tried passed.")
      .def_readonly("reason", &Margin::reason)
      .def("__repr__", [](const Margin& self) {
        return as_utf8(fmt::format("<armtune.Margin {} in {}: {} {}>", self.kind, self.scenario,
                                   self.stands ? fmt::format("{:.4g}", *self.stands) : "none", self.unit));
      });
  py::class_<Margins> all(module, "Margins", made_by_armtune(),
                          "The stability margins of a gain set. It behaves like a list of them.");
  all.def_readonly("margins", &Margins::margins)
      .def_readonly("verdict", &Margins::verdict,
                    "One check for each kind of margin, which passes if the loop is stable without a change.")
      .def_readonly("files", &Margins::files, "Names of the files in the run folder.");
  act_as_list(all, "margins");
  module.def(
      "margins",
      [](const std::vector<Scenario>& scenarios, const Gains& gains, const MaybePath& folder,
         const std::string& engine, int workers, py::object progress) {
        MarginsOptions options{text_of(folder), engine_of(engine), workers, {}};
        return watched(std::move(progress), [&, set = gains](const Watch& watch) {
          options.watch = watch;
          return armtune::margins(scenarios, set, options);
        });
      },
      py::arg("scenarios"), py::arg("gains"), py::kw_only(), py::arg("folder") = py::none(),
      py::arg("engine") = "simbody", py::arg("workers") = 1, py::arg("progress") = py::none(),
      "Finds the stability margins of the closed loop in each scenario: delay, gain, control rate and "
      "velocity noise. folder: new folder for all files of the run.");
}

}  // namespace

void bind_robustness(py::module_& module) {
  bind_samples(module);
  bind_margins(module);
}

}  // namespace armtune::internal::python
