// Scenarios, and what becomes of them under gains.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/common/error.hpp"
#include "core/common/message_text.hpp"
#include "core/common/utf8.hpp"
#include "core/control/gain_fields.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/interruptible.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/scenario.hpp"
#include "tuner/rollouts/simulate.hpp"

namespace py = pybind11;

namespace armtune::python {
namespace {

struct Rolled {
  ScenarioResult result;
  std::vector<std::string> names;  ///< of the columns
  std::vector<double> values;      ///< row by row

  std::size_t rows() const { return names.empty() ? 0 : values.size() / names.size(); }
};

py::object column(const py::object& self, const std::string& name) {
  const auto& rolled = self.cast<const Rolled&>();
  const auto found = std::find(rolled.names.begin(), rolled.names.end(), name);
  if (found == rolled.names.end())
    throw py::key_error(fmt::format("{}: no such column; rollout.keys() names them", name));
  const auto place = static_cast<std::size_t>(found - rolled.names.begin());
  return view(rolled.values.data() + place, rolled.rows(), rolled.names.size(), self, false);
}

py::dict metrics(const Rolled& self) {
  py::dict all;
  for (const Metric metric : all_metrics()) all[name(metric)] = self.result.result.metrics[metric];
  return all;
}

std::vector<Rolled> simulate_all(const std::vector<Scenario>& scenarios, const NamedJoints& gains,
                                 int workers, int record_every, const std::string& stepper,
                                 py::object progress) {
  Work work;
  check_workers(workers);
  if (record_every < 1)
    throw py::value_error(fmt::format("record_every: {}, must be 1 or more", record_every));
  validate(gains.gains, gains.joints, "gains");
  for (const Scenario& scenario : scenarios) {
    if (joint_names(*scenario.robot) != gains.joints)
      throw py::value_error(
          one_line(fmt::format("{}: the gains are for an arm of other joints", scenario.name)));
  }
  Callback callback(std::move(progress));
  SimulateOptions options;
  options.workers = workers;
  options.record_stride = record_every;
  options.stepper = stepper_from_name(stepper);
  options.progress = [&](std::size_t done) { callback(done, scenarios.size()); };
  std::vector<Rolled> rolled(scenarios.size());
  options.recorded = [&](std::size_t i, Recorder recorder, bool completed) {
    for (const Column& c : recorder.columns()) rolled[i].names.push_back(c.name);
    rolled[i].values = std::move(recorder).rows(completed);
  };
  Gains given = gains.gains;  // the caller's may change meanwhile
  auto results = interruptible(work, callback, [&](const std::atomic<bool>& stop) {
    return simulate(
        scenarios, [&](const Scenario&) { return given; }, options, stop);
  });
  for (std::size_t i = 0; i < rolled.size(); ++i) rolled[i].result = std::move(results[i]);
  return rolled;
}

/// What a scenario's file may say too.
void set_duration(Scenario& self, double duration) {
  constexpr double kMostPeriods = 1e8;  // as in a file
  const double period = self.control_period;
  if (!(duration >= period && duration <= kMostPeriods * period)) {
    throw InputError(fmt::format("duration: {} s; it must lie between one and {:.0e} control periods of {} s",
                                 duration, kMostPeriods, period));
  }
  self.duration = duration;
}

/// It stands in CSV files and in names of files.
void set_name(Scenario& self, const std::string& name) {
  const bool plain = std::all_of(name.begin(), name.end(), [](char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.';
  });
  if (name.empty() || !plain || is_formula(name) || name[0] == '.')
    throw InputError(fmt::format("name: {}; give one of letters, digits, '_', '-' and '.'", shown(name)));
  self.name = name;
}

std::string errors_text(const std::vector<const Rolled*>& rollouts) {
  std::vector<ScenarioResult> results;
  for (const Rolled* rolled : rollouts) {
    if (rolled == nullptr) throw py::type_error("rollouts: None is no Rollout");
    results.push_back(rolled->result);
  }
  return errors_csv(results);
}

}  // namespace

void bind_rollouts(py::module_& module) {
  py::class_<Scenario>(module, "Scenario", made_by_armtune(),
                       "A task for an arm: path, targets, obstacles, and what is not ideal.")
      .def_property(
          "name", [](const Scenario& self) { return as_utf8(self.name); }, &set_name,
          "What its results are called by: of two variants that are simulated together one needs another.")
      .def_property(
          "duration", [](const Scenario& self) { return self.duration; }, &set_duration,
          "Simulated time [s].")
      .def_readonly("control_period", &Scenario::control_period, "[s]")
      .def_property_readonly("joints", [](const Scenario& self) { return joint_names(*self.robot); });
  module.def(
      "load_scenario", [](const std::filesystem::path& name) { return load_scenario(name.string()); },
      py::arg("name"), "A bundled scenario by name, or a file by path.");

  py::class_<Rolled>(module, "Rollout", made_by_armtune(),
                     "A simulated scenario: its outcome, metrics and time series.")
      .def_property_readonly("scenario", [](const Rolled& self) { return as_utf8(self.result.scenario); })
      .def_property_readonly(
          "status", [](const Rolled& self) { return name(self.result.result.status); },
          "'completed', or what became of it.")
      .def_property_readonly(
          "reason", [](const Rolled& self) { return as_utf8(self.result.result.reason); },
          "When, where and why it ended; empty if completed.")
      .def_property_readonly("metrics", &metrics,
                             "Every metric by name, SI units; nan where there is no value.")
      .def(
          "keys", [](const Rolled& self) { return self.names; }, "Names of the columns.")
      .def("__getitem__", &column, py::arg("name"),
           "A column as a read-only NumPy array onto the rollout's own numbers, without a copy.")
      .def("__contains__",
           [](const Rolled& self, const std::string& name) {
             return std::find(self.names.begin(), self.names.end(), name) != self.names.end();
           })
      .def("__len__", &Rolled::rows, "Rows: recorded moments.");
  module.def("simulate", &simulate_all, py::arg("scenarios"), py::arg("gains"), py::kw_only(),
             py::arg("workers") = 1, py::arg("record_every") = 5, py::arg("stepper") = "midpoint",
             py::arg("progress") = py::none(),
             "Scenarios under gains, in parallel. progress(done, all) is called after each. Ctrl-C ends it.");
  module.def(
      "errors_csv", [](const std::vector<const Rolled*>& rollouts) { return as_utf8(errors_text(rollouts)); },
      py::arg("rollouts"), "The text of errors.csv: one row per rollout, every metric.");
  module.def(
      "write_errors",
      [](const std::vector<const Rolled*>& rollouts, const std::filesystem::path& path) {
        write_text_file(path.string(), errors_text(rollouts));
      },
      py::arg("rollouts"), py::arg("path"), "Writes errors.csv, whole or not at all.");
}

}  // namespace armtune::python
