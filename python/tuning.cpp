// Studies and their search.

#include <fmt/format.h>
#include <pybind11/stl.h>

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

Tuned tune_study(const Study& given, int workers, py::object progress) {
  if (workers < 1) throw py::value_error(fmt::format("workers: {}, must be 1 or more", workers));
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
  const TuneResult result = interruptible(callback, [&](const std::atomic<bool>& stop) {
    Workers crew(study.scenarios, study.stepper, workers, study.robust);
    return tune(study, crew, stop, callbacks);
  });
  const auto joints = joint_names(*study.scenarios.front().robot);
  Tuned tuned;
  tuned.start = {study.space.start, joints};
  tuned.best = {result.best.gains, joints};
  tuned.objective = result.best.objective;
  tuned.feasible = result.best.feasible;
  tuned.reason = result.reason;
  const auto rows = static_cast<py::ssize_t>(seen.objective.size());
  tuned.objectives = owning(std::move(seen.objective), {rows});
  tuned.violations = owning(std::move(seen.violation), {rows});
  tuned.points = owning(std::move(seen.x), {rows, static_cast<py::ssize_t>(study.space.free.size())});
  return tuned;
}

}  // namespace

void bind_tuning(py::module_& module) {
  py::class_<Study>(module, "Study", "What is tuned, over which scenarios, for what, inside which limits.")
      .def_readonly("name", &Study::name)
      .def_readonly("scenarios", &Study::scenarios)
      .def_readwrite("max_evaluations", &Study::max_evaluations, "Budget, start and sweep included.")
      .def_property(
          "seed", [](const Study& self) { return self.solver.seed; },
          [](Study& self, std::uint64_t seed) { self.solver.seed = seed; },
          "Of algorithms that draw random numbers.");
  module.def("load_study", &load_study, py::arg("name"), py::arg("controller") = "",
             "A bundled study by name, or a file by path; with another controller than its gains are for.");

  py::class_<Tuned>(module, "Tuned", "A search that is over.")
      .def_readonly("start", &Tuned::start, "The gains it began with.")
      .def_readonly("best", &Tuned::best, "The best gains: feasible, if any were.")
      .def_readonly("objective", &Tuned::objective, "Of the best; the start scores 1.")
      .def_readonly("feasible", &Tuned::feasible, "Whether the best keeps every limit.")
      .def_readonly("reason", &Tuned::reason, "Why the search ended.")
      .def_readonly("objectives", &Tuned::objectives, "Of every evaluation, in order.")
      .def_readonly("violations", &Tuned::violations,
                    "Sum of relative violations of the limits; 0: feasible.")
      .def_readonly("points", &Tuned::points,
                    "Search coordinates, a row for each evaluation: 0 lower, 1 upper bound.");
  module.def(
      "tune", &tune_study, py::arg("study"), py::kw_only(), py::arg("workers") = 1,
      py::arg("progress") = py::none(),
      "Runs a study; deterministic, whatever the number of workers. progress(evaluations, most, objective, "
      "feasible) is called after each evaluation, with the best so far. Ctrl-C ends it.");
}

}  // namespace armtune::python
