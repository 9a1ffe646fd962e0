// Binds planning, identification, reports and information about armtune.

#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "armtune/about.hpp"
#include "armtune/report.hpp"
#include "armtune/run_record.hpp"
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
  py::class_<PlanLimit>(module, "PlanLimit", made_by_armtune(), "How much of one limit a plan uses.")
      .def_readonly("limit", &PlanLimit::limit)
      .def_readonly("part", &PlanLimit::part, "The joint or axis.")
      .def_readonly("used", &PlanLimit::used, "Largest share of the limit used at any time; 1: at the limit.")
      .def_readonly(
          "time", &PlanLimit::time,
          "Time at which the limit is used most [s]; nan if this is at a knot, because only times between "
          "knots are kept.")
      .def_readonly("binds", &PlanLimit::binds, "True if the limit restricts the motion somewhere.");
  py::class_<Plan>(module, "Plan", made_by_armtune(), "A planned motion of n joints at N times.")
      .def_readonly("solved", &Plan::solved)
      .def_readonly("status", &Plan::status)
      .def_property_readonly("headline", [](const Plan& self) { return as_utf8(self.headline); })
      .def_readonly("duration", &Plan::duration, "Duration [s].")
      .def_readonly("joints", &Plan::joints)
      .def_readonly("time", &Plan::time, "N times [s].")
      .def_readonly("position", &Plan::position, "N lists of n positions [rad, m].")
      .def_readonly("velocity", &Plan::velocity, "N lists of n velocities [rad/s, m/s].")
      .def_readonly("effort", &Plan::effort, "N lists of n efforts [N m, N].")
      .def_readonly("limits", &Plan::limits,
                    "Share of each limit that the motion uses; limits that restrict the motion come first.")
      .def_readonly("files", &Plan::files, "Names of the files in the run folder.");
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
  py::class_<Residuals>(module, "Residuals", made_by_armtune(), "RMS torques of each joint [N m, N].")
      .def_readonly("torque", &Residuals::torque, "The measured torque.")
      .def_readonly("by_theta", &Residuals::by_theta, "The part not explained by the identified parameters.")
      .def_readonly("by_file", &Residuals::by_file, "The part not explained by the robot file's parameters.");
  py::class_<Identified>(module, "Identified", made_by_armtune(),
                         "The dynamic parameters of an arm, identified from logs.")
      .def_readonly("theta", &Identified::theta, "13 parameters for each joint, physically possible.")
      .def_readonly("fitted", &Identified::fitted, "Residuals on the samples used in the fit.")
      .def_readonly("held_out", &Identified::held_out, "Residuals on the samples left out of the fit.")
      .def_readonly("doubts", &Identified::doubts,
                    "Reasons why the logs may belong to another arm, one sentence each.")
      .def_readonly("files", &Identified::files, "Names of the files in the run folder.");
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
      "Identifies an arm's dynamics from logs of its motion. columns: a YAML file that names the columns of "
      "the logs.");
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
      py::arg("folder"), py::arg("path"), "Writes the report page of a run folder to a new file.");
  module.def(
      "run_record",
      [](const std::filesystem::path& folder) {
        const py::str text = as_utf8(armtune::run_record(folder.string()).json);
        return py::dict(py::module_::import("json").attr("loads")(text));
      },
      py::arg("folder"), "Returns the record of a run folder, run.json, as a dict.");
  module.def("versions", &armtune::versions,
             "Returns (name, version) of armtune and of every library in use.");
  module.def("bundled", &armtune::bundled, py::arg("folder"),
             "Returns the names of bundled files. folder: robots, scenarios, gains, studies, tasks or "
             "theta.");
}

}  // namespace armtune::internal::python
