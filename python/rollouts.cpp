// Binds robots, scenarios, and the simulation of scenarios with gains.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>

#include "armtune/rollout.hpp"
#include "core/common/utf8.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/watched.hpp"
#include "sim/csv/text_file.hpp"

namespace py = pybind11;

namespace armtune::internal::python {
namespace {

using armtune::Gains;
using armtune::Scenario;

py::object column(const py::object& self, const std::string& name) {
  const auto& rollout = self.cast<const Rollout&>();
  const std::vector<std::string>& names = rollout.columns();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw py::key_error(fmt::format("{}: no such column; rollout.keys() lists the columns", name));
  const auto place = static_cast<std::size_t>(found - names.begin());
  return view(rollout.values().data() + place, rollout.rows(), names.size(), self, false);
}

py::dict columns(const py::object& self) {
  py::dict all;
  for (const std::string& name : self.cast<const Rollout&>().columns())
    all[py::str(name)] = column(self, name);
  return all;
}

std::string repr_of(const Rollout& rollout) {
  std::string text = fmt::format("<armtune.Rollout of {}: {}", rollout.scenario(), rollout.status());
  if (!rollout.reason().empty()) text += ", " + rollout.reason();
  text += fmt::format("; error/position/max {:.4g} m, joint_velocity/max_ratio {:.4g}",
                      rollout.metric("error/position/max"), rollout.metric("joint_velocity/max_ratio"));
  return text + fmt::format("; {} rows of {} columns>", rollout.rows(), rollout.columns().size());
}

SimulateOptions options_of(const MaybePath& folder, const std::string& engine, const std::string& stepper,
                           int workers, int record_every, double deadline) {
  SimulateOptions options;
  options.folder = text_of(folder);
  options.engine = engine_of(engine);
  options.stepper = stepper;
  options.workers = workers;
  options.record_every = record_every;
  options.deadline = deadline;
  return options;
}

py::object simulate_any(const std::vector<Scenario>& scenarios, const py::object& gains,
                        const MaybePath& folder, const std::string& engine, int workers, int record_every,
                        const std::string& stepper, double deadline, py::object progress) {
  SimulateOptions options = options_of(folder, engine, stepper, workers, record_every, deadline);
  if (py::isinstance<Gains>(gains)) {
    const auto set = gains.cast<Gains>();  // a copy: the caller may change its object meanwhile
    return py::cast(watched(std::move(progress), [&](const Watch& watch) {
      options.watch = watch;
      return armtune::simulate(scenarios, set, options);
    }));
  }
  std::vector<Gains> sets;
  try {
    sets = gains.cast<std::vector<Gains>>();
  } catch (const py::cast_error&) {
    throw py::type_error("gains: must be a Gains object or a list of them");
  }
  return py::cast(watched(std::move(progress), [&](const Watch& watch) {
    options.watch = watch;
    return simulate_sets(scenarios, sets, options);
  }));
}

std::string errors_text(const std::vector<const Rollout*>& rollouts) {
  std::vector<Rollout> all;
  for (const Rollout* rollout : rollouts) {
    if (rollout == nullptr) throw py::type_error("rollouts: None is in the list; give Rollout objects only");
    all.push_back(*rollout);
  }
  return armtune::errors_csv(all);
}

void bind_simulated(py::module_& module) {
  py::class_<Simulated> type(module, "Simulated", made_by_armtune(),
                             "The rollouts of scenarios with one gain set. It behaves like their list.");
  type.def_readonly("rollouts", &Simulated::rollouts, "One rollout for each scenario, in their order.")
      .def_readonly("verdict", &Simulated::verdict, "Verdict of the simulation checks.")
      .def_readonly("files", &Simulated::files, "Names of the files in the run folder.");
  act_as_list(type, "rollouts");
}

void bind_scenario(py::module_& module) {
  py::class_<Robot>(module, "Robot", made_by_armtune(), "An arm with its joints and limits.")
      .def_property_readonly("name", [](const Robot& self) { return as_utf8(self.name()); })
      .def_property_readonly("joints", &Robot::joints,
                             "Joint names from the base to the tool, in the order of joint vectors.")
      .def_property_readonly("velocity_limits", &Robot::velocity_limits, "Velocity limits [rad/s, m/s].")
      .def_property_readonly("effort_limits", &Robot::effort_limits, "Effort limits [N m, N].")
      .def_property_readonly("lower_position_limits", &Robot::lower_position_limits,
                             "Lower position limits [rad, m].")
      .def_property_readonly("upper_position_limits", &Robot::upper_position_limits,
                             "Upper position limits [rad, m].");
  module.def(
      "load_robot", [](const std::filesystem::path& name) { return Robot::load(name.string()); },
      py::arg("name"), "Loads a bundled robot by name, or a robot file or URDF by path.");

  py::class_<Scenario>(module, "Scenario", made_by_armtune(),
                       "A task for an arm: path, targets, obstacles and disturbances.")
      .def_property(
          "name", [](const Scenario& self) { return as_utf8(self.name()); }, &Scenario::set_name,
          "Name of the scenario and its results. Scenarios that are simulated together need different names.")
      .def_property("duration", &Scenario::duration, &Scenario::set_duration, "Simulated time [s].")
      .def_property_readonly("control_period", &Scenario::control_period, "Control period [s].")
      .def_property_readonly("robot", &Scenario::robot)
      .def_property_readonly("joints", [](const Scenario& self) { return self.robot().joints(); });
  module.def(
      "load_scenario", [](const std::filesystem::path& name) { return Scenario::load(name.string()); },
      py::arg("name"), "Loads a bundled scenario by name, or a scenario file by path.");
}

}  // namespace

armtune::Engine engine_of(const std::string& name) {
  if (name == "simbody") return armtune::Engine::kSimbody;
  if (name == "native") return armtune::Engine::kNative;
  throw py::value_error(fmt::format("engine: {}; it must be simbody or native", name));
}

void bind_rollouts(py::module_& module) {
  bind_scenario(module);
  py::class_<Rollout>(module, "Rollout", made_by_armtune(),
                      "A simulated scenario: its outcome, metrics and time series.")
      .def_property_readonly("scenario", [](const Rollout& self) { return as_utf8(self.scenario()); })
      .def_property_readonly("status", &Rollout::status,
                             "completed, diverged, no_samples (the task was never tracked) or interrupted.")
      .def_property_readonly("completed", &Rollout::completed)
      .def_property_readonly(
          "reason", [](const Rollout& self) { return as_utf8(self.reason()); },
          "When, where and why the rollout did not complete; empty if it completed.")
      .def_property_readonly("metrics", &Rollout::metrics,
                             "Every metric by name, in SI units; nan if it has no value.")
      .def_property_readonly(
          "broken_limits", &Rollout::broken_limits,
          "The arm's limits that were exceeded, one sentence each. None if the limits were not "
          "checked: with several gain sets, on random arms, and in an objective function of your own.")
      .def_property_readonly("columns", &columns,
                             "All columns by name, as read-only NumPy arrays without a copy. "
                             "pandas.DataFrame(rollout.columns) makes a table of them.")
      .def("keys", &Rollout::columns, "Returns the names of the columns.")
      .def("__getitem__", &column, py::arg("name"),
           "Returns a column as a read-only NumPy array, without a copy.")
      .def("__contains__",
           [](const Rollout& self, const std::string& name) {
             return std::find(self.columns().begin(), self.columns().end(), name) != self.columns().end();
           })
      .def("__iter__", [](const Rollout& self) { return py::iter(py::cast(self.columns())); })
      .def("__len__", &Rollout::rows, "Returns the number of rows, one for each recorded time.")
      .def("__bool__", [](const Rollout&) { return true; })
      .def("__repr__", [](const Rollout& self) { return as_utf8(repr_of(self)); });
  bind_simulated(module);
  module.def(
      "simulate", &simulate_any, py::arg("scenarios"), py::arg("gains"), py::kw_only(),
      py::arg("folder") = py::none(), py::arg("engine") = "simbody", py::arg("workers") = 1,
      py::arg("record_every") = 5, py::arg("stepper") = "midpoint", py::arg("deadline") = 0.0,
      py::arg("progress") = py::none(),
      "Simulates scenarios in parallel and returns their rollouts, with the verdict on them. folder: new "
      "folder for all files of the run. If gains is a list, simulate returns a list of rollouts for each "
      "gain set, without recordings, verdict and folder. For such a list of gain sets, the native engine "
      "computes several rollouts at once, in the vector registers of a processor.");
  module.def(
      "errors_csv",
      [](const std::vector<const Rollout*>& rollouts) { return as_utf8(errors_text(rollouts)); },
      py::arg("rollouts"), "Returns the text of errors.csv: one row for each rollout, with every metric.");
  module.def(
      "write_errors",
      [](const std::vector<const Rollout*>& rollouts, const std::filesystem::path& path) {
        write_text_file(path.string(), errors_text(rollouts));
      },
      py::arg("rollouts"), py::arg("path"), "Writes errors.csv. After an error there is no partial file.");
}

}  // namespace armtune::internal::python
