// Studies and their search.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <limits>

#include "core/common/utf8.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/interruptible.hpp"
#include "tuner/search/tune.hpp"

namespace py = pybind11;

namespace armtune::python {
namespace {

/// A search that is over, its evaluations in order.
struct Tuned {
  NamedJoints start, best;
  double objective = 0.0;
  bool feasible = false;
  std::string reason;
  py::array objectives, violations, points;
};

struct Series {
  std::vector<double> objective, violation, x;
};

Tuned tuned_of(const Study& study, const TuneResult& result, Series seen) {
  const auto joints = joint_names(*study.scenarios.front().robot);
  Tuned tuned;
  tuned.start = {study.space.start, joints};
  // Before the first evaluation is done the start is all there is.
  const bool none = result.evaluations == 0;
  tuned.best = {none ? study.space.start : result.best.gains, joints};
  tuned.objective = none ? std::numeric_limits<double>::quiet_NaN() : result.best.objective;
  tuned.feasible = !none && result.best.feasible;
  tuned.reason = result.reason;
  const auto rows = static_cast<py::ssize_t>(seen.objective.size());
  tuned.objectives = owning(std::move(seen.objective), {rows});
  tuned.violations = owning(std::move(seen.violation), {rows});
  tuned.points = owning(std::move(seen.x), {rows, static_cast<py::ssize_t>(study.space.free.size())});
  return tuned;
}

/// Raises armtune.Interrupted, a KeyboardInterrupt that has what was found.
[[noreturn]] void raise_interrupted(Tuned tuned) {
  const py::object type = py::module_::import("armtune").attr("Interrupted");
  const py::object error = type("interrupted; .tuned has what was found");
  error.attr("tuned") = std::move(tuned);
  PyErr_SetObject(type.ptr(), error.ptr());
  throw py::error_already_set();
}

Tuned tune_study(const Study& given, int workers, py::object progress) {
  Work under_way;
  check_workers(workers);
  const Study study = given;
  Callback callback(std::move(progress));
  Series seen;
  TuneCallbacks callbacks;
  callbacks.evaluated = [&](const char*, const Evaluation& e) {
    seen.objective.push_back(e.objective);
    seen.violation.push_back(e.violation);
    seen.x.insert(seen.x.end(), e.x.begin(), e.x.end());
  };
  callbacks.progress = [&](const TuneProgress& p) {
    callback(p.evaluations, p.max_evaluations, p.best->objective, p.best->feasible);
  };
  const auto task = [&](const std::atomic<bool>& stop) {
    CandidateRunner runner(study.scenarios, study.stepper, workers, study.robust);
    return tune(study, runner, stop, callbacks);
  };
  const TuneResult found = interruptible(under_way, callback, task, [&](const TuneResult& so_far) {
    raise_interrupted(tuned_of(study, so_far, std::move(seen)));
  });
  return tuned_of(study, found, std::move(seen));
}

void set_seed(Study& self, std::int64_t seed) {
  if (seed < 0) throw py::value_error(fmt::format("seed: {}, must not be negative", seed));
  self.solver.seed = static_cast<std::uint64_t>(seed);
}

void set_max_evaluations(Study& self, long most) {
  if (most < 1) throw py::value_error(fmt::format("max_evaluations: {}, must be 1 or more", most));
  self.max_evaluations = most;
}

}  // namespace

void bind_tuning(py::module_& module) {
  py::class_<Study>(module, "Study", made_by_armtune(),
                    "What is tuned, over which scenarios, for what, inside which limits.")
      .def_property_readonly("name", [](const Study& self) { return as_utf8(self.name); })
      .def_readonly("scenarios", &Study::scenarios)
      .def_property(
          "max_evaluations", [](const Study& self) { return self.max_evaluations; }, &set_max_evaluations,
          "Budget, start and sweep included.")
      .def_property(
          "seed", [](const Study& self) { return self.solver.seed; }, &set_seed,
          "Of algorithms that draw random numbers.");
  module.def(
      "load_study",
      [](const std::filesystem::path& name, const std::string& controller) {
        return load_study(name.string(), controller);
      },
      py::arg("name"), py::arg("controller") = "",
      "A bundled study by name, or a file by path; with another controller than its gains are for.");

  py::class_<Tuned>(module, "Tuned", made_by_armtune(), "A search that is over.")
      .def_readonly("start", &Tuned::start, "The gains it began with.")
      .def_readonly("best", &Tuned::best, "The best gains: feasible, if any were.")
      .def_readonly("objective", &Tuned::objective, "Of the best; the start scores 1.")
      .def_readonly("feasible", &Tuned::feasible, "Whether the best keeps every limit.")
      .def_property_readonly(
          "reason", [](const Tuned& self) { return as_utf8(self.reason); }, "Why the search ended.")
      .def_readonly("objectives", &Tuned::objectives, "Of every evaluation, in order.")
      .def_readonly("violations", &Tuned::violations,
                    "Sum of relative violations of the limits; 0: feasible.")
      .def_readonly("points", &Tuned::points,
                    "Search coordinates, a row for each evaluation: 0 lower, 1 upper bound.");
  module.def(
      "tune", &tune_study, py::arg("study"), py::kw_only(), py::arg("workers") = 1,
      py::arg("progress") = py::none(),
      "Runs a study; deterministic, whatever the number of workers. progress(evaluations, most, objective, "
      "feasible) is called after each evaluation, with the best so far. Ctrl-C ends it and raises "
      "Interrupted, a "
      "KeyboardInterrupt whose `tuned` has what was found.");
}

}  // namespace armtune::python
