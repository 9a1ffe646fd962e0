// Plans, identification and reports.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "armtune/about.hpp"
#include "armtune/report.hpp"
#include "core/common/utf8.hpp"
#include "python/bindings.hpp"
#include "python/watched.hpp"

#ifdef ARMTUNE_SUITESPARSE
#include "armtune/identify.hpp"
#include "armtune/plan.hpp"
#endif

namespace py = pybind11;

namespace armtune::internal::python {

#ifdef ARMTUNE_SUITESPARSE
namespace {

void bind_plan(py::module_& module) {
  py::class_<PlanLimit>(module, "PlanLimit", made_by_armtune(), "How far a plan uses one of its limits.")
      .def_readonly("limit", &PlanLimit::limit)
      .def_readonly("part", &PlanLimit::part, "The joint or axis.")
      .def_readonly("used", &PlanLimit::used, "Largest share of it at any time: 1 at the limit.")
      .def_readonly("time", &PlanLimit::time, "Of that [s]; nan: at a knot.")
      .def_readonly("binds", &PlanLimit::binds, "It holds the motion back somewhere.");
  py::class_<Plan>(module, "Plan", made_by_armtune(), "A motion of n joints at N moments.")
      .def_readonly("solved", &Plan::solved)
      .def_readonly("status", &Plan::status)
      .def_property_readonly("headline", [](const Plan& self) { return as_utf8(self.headline); })
      .def_readonly("duration", &Plan::duration, "[s]")
      .def_readonly("joints", &Plan::joints)
      .def_readonly("time", &Plan::time, "N [s]")
      .def_readonly("position", &Plan::position, "N lists of n [rad, m]")
      .def_readonly("velocity", &Plan::velocity, "N lists of n [rad/s, m/s]")
      .def_readonly("effort", &Plan::effort, "N lists of n [N m, N]")
      .def_readonly("limits", &Plan::limits, "Those that hold it back first.")
      .def_readonly("files", &Plan::files, "Names of those in the run's folder.");
  module.def(
      "plan",
      [](const std::filesystem::path& task, const MaybePath& folder, py::object progress) {
        return watched(std::move(progress), [&](const Watch& watch) {
          return armtune::plan(task.string(), {text_of(folder), watch});
        });
      },
      py::arg("task"), py::kw_only(), py::arg("folder") = py::none(), py::arg("progress") = py::none(),
      "Plans a bundled task by name, or a task file by path.");
}

void bind_identify(py::module_& module) {
  py::class_<Residuals>(module, "Residuals", made_by_armtune(), "RMS torques of every joint [N m, N].")
      .def_readonly("torque", &Residuals::torque, "The measured torque itself.")
      .def_readonly("by_theta", &Residuals::by_theta, "Left unexplained by what was identified.")
      .def_readonly("by_file", &Residuals::by_file, "Left unexplained by the robot as it was given.");
  py::class_<Identified>(module, "Identified", made_by_armtune(), "An arm's parameters from logs.")
      .def_readonly("theta", &Identified::theta, "13 numbers for each joint, of an arm that can exist.")
      .def_readonly("fitted", &Identified::fitted, "On the samples of the fit.")
      .def_readonly("held_out", &Identified::held_out, "On those left out of it.")
      .def_readonly("doubts", &Identified::doubts, "Why the logs may not be of this arm.")
      .def_readonly("files", &Identified::files, "Names of those in the run's folder.");
  module.def(
      "identify",
      [](const Robot& robot, const std::vector<std::filesystem::path>& logs, const MaybePath& columns,
         bool robust, bool accept, const MaybePath& folder, py::object progress) {
        std::vector<std::string> paths;
        for (const std::filesystem::path& log : logs) paths.push_back(log.string());
        return watched(std::move(progress), [&, arm = robot](const Watch& watch) {
          return armtune::identify(arm, paths, {text_of(folder), text_of(columns), robust, accept, watch});
        });
      },
      py::arg("robot"), py::arg("logs"), py::kw_only(), py::arg("columns") = py::none(),
      py::arg("robust") = false, py::arg("accept") = false, py::arg("folder") = py::none(),
      py::arg("progress") = py::none(),
      "Identifies an arm from logs of its motion. columns: a YAML file that names theirs.");
}

}  // namespace
#endif

void bind_models(py::module_& module) {
#ifdef ARMTUNE_SUITESPARSE
  bind_plan(module);
  bind_identify(module);
#endif
  module.def(
      "report",
      [](const std::filesystem::path& folder, const std::filesystem::path& path) {
        write_report(folder.string(), path.string());
      },
      py::arg("folder"), py::arg("path"),
      "Writes the page of a run's folder to a path that does not exist yet.");
  module.def("versions", &armtune::versions, "(name, version) of armtune and every library in use.");
  module.def("bundled", &armtune::bundled, py::arg("folder"),
             "Names of what is bundled: robots, scenarios, gains, studies, tasks, theta.");
}

}  // namespace armtune::internal::python
