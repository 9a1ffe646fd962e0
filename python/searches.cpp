// Binds the searches of studies, and the verdicts on the gains that were found.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "armtune/error.hpp"
#include "armtune/evaluate.hpp"
#include "armtune/front.hpp"
#include "armtune/tune.hpp"
#include "core/common/utf8.hpp"
#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/watched.hpp"

namespace py = pybind11;

namespace armtune::internal::python {
namespace {

using armtune::Gains;
using armtune::Study;

py::array numbers_of(const std::vector<TunePoint>& points, double TunePoint::*member) {
  std::vector<double> values;
  values.reserve(points.size());
  for (const TunePoint& point : points) values.push_back(point.*member);
  const auto rows = static_cast<py::ssize_t>(values.size());
  return owning(std::move(values), {rows});
}

py::array coordinates(const Tuned& tuned) {
  std::vector<double> values;
  for (const TunePoint& point : tuned.evaluations)
    values.insert(values.end(), point.x.begin(), point.x.end());
  const auto rows = static_cast<py::ssize_t>(tuned.evaluations.size());
  return owning(std::move(values), {rows, static_cast<py::ssize_t>(tuned.parameters.size())});
}

void bind_verdict(py::module_& module) {
  py::class_<Check>(module, "Check", made_by_armtune(),
                    "One simulation check, with the scenario, joint and time of its worst value.")
      .def_property_readonly("name", [](const Check& self) { return name(self.kind); })
      .def_readonly("passed", &Check::passed)
      .def_readonly("scenario", &Check::scenario)
      .def_readonly("arm", &Check::arm)
      .def_readonly("joint", &Check::joint)
      .def_readonly("time", &Check::time, "Time of the value [s]; nan if it has no time.")
      .def_readonly("value", &Check::value)
      .def_readonly("threshold", &Check::threshold)
      .def_readonly("unit", &Check::unit)
      .def_readonly("detail", &Check::detail, "Further information, such as the name of the constraint.")
      .def("__str__", [](const Check& self) { return as_utf8(to_text(self)); });
  py::class_<Verdict>(module, "Verdict", made_by_armtune(),
                      "Which simulation checks passed, what was not checked, and what the checks assume.")
      .def_property_readonly("passed", &Verdict::passed)
      .def_readonly("checks", &Verdict::checks)
      .def_readonly("not_checked", &Verdict::not_checked)
      .def_readonly("assumes", &Verdict::assumes)
      .def_readonly("notes", &Verdict::notes)
      .def("__str__", [](const Verdict& self) { return as_utf8(to_text(self)); });
}

void bind_evaluator(py::module_& module) {
  py::class_<TunePoint>(module, "TunePoint", made_by_armtune(), "One evaluated point of a study.")
      .def_readonly("x", &TunePoint::x,
                    "Coordinates, one for each parameter of the study: 0 at the lower bound, 1 at the upper.")
      .def_readonly("objective", &TunePoint::objective,
                    "Objective relative to that of the start gains; less is better.")
      .def_readonly("violation", &TunePoint::violation,
                    "Sum of the relative constraint violations; 0: feasible.")
      .def_property_readonly("feasible", [](const TunePoint& self) { return self.violation == 0.0; })
      .def_readonly(
          "constraints", &TunePoint::constraints,
          "Violation of each constraint, relative to its limit; 0 or less: the constraint is kept. One more "
          "value follows; it is 0 or less if every scenario completed.");
  py::class_<Evaluator, std::shared_ptr<Evaluator>>(
      module, "Evaluator", made_by_armtune(),
      "Simulates and scores gains of a study in the same way as its search, for an optimiser of your own.")
      .def_property_readonly("start", &Evaluator::start, "The evaluation of the start gains.")
      .def(
          "evaluate",
          [](Evaluator& self, const std::vector<std::vector<double>>& points, py::object progress) {
            return watched(std::move(progress),
                           [&](const Watch& watch) { return self.evaluate(points, watch); });
          },
          py::arg("points"), py::kw_only(), py::arg("progress") = py::none(),
          "Evaluates points, given as a list of lists or an array with one row each. Returns one TunePoint "
          "for each point, in order. Do not call it from several threads at once.")
      .def("gains_at", &Evaluator::gains_at, py::arg("point"), "Returns the gains at a point.")
      .def_property_readonly("simulated", &Evaluator::simulated,
                             "Simulated time of all rollouts so far [s].");
  module.def(
      "make_evaluator",
      [](const Study& study, const std::optional<std::string>& engine, int workers, double deadline,
         py::object progress) {
        EvaluatorOptions options{std::nullopt, workers, deadline};
        if (engine) options.engine = engine_of(*engine);
        const auto make = [&, given = study](const Watch& watch) -> std::shared_ptr<Evaluator> {
          try {
            return std::make_shared<Evaluator>(given, options, watch);
          } catch (const FailedError&) {
            if (*watch.stop) return nullptr;  // raises Interrupted with the result None
            throw;
          }
        };
        return watched(std::move(progress), make);
      },
      py::arg("study"), py::kw_only(), py::arg("engine") = py::none(), py::arg("workers") = 1,
      py::arg("deadline") = 0.0, py::arg("progress") = py::none(),
      "Makes an Evaluator, and simulates the start gains, whose objective is 1. engine: 'native' or "
      "'simbody' for all evaluations; None: the engine in which the study searches.");
}

void bind_tuned(py::module_& module) {
  py::class_<Tuned>(module, "Tuned", made_by_armtune(), "The result of a search.")
      .def_readonly("start", &Tuned::start, "The start gains.")
      .def_readonly("best", &Tuned::best, "The best gains; feasible if any evaluated gains were feasible.")
      .def_readonly("objective", &Tuned::objective,
                    "Objective of the best gains. The start gains have the objective 1.")
      .def_readonly("feasible", &Tuned::feasible, "True if the best gains keep every constraint.")
      .def_property_readonly(
          "reason", [](const Tuned& self) { return as_utf8(self.reason); }, "Why the search ended.")
      .def_property_readonly(
          "objectives", [](const Tuned& self) { return numbers_of(self.evaluations, &TunePoint::objective); },
          "Objective of every evaluation, in order.")
      .def_property_readonly(
          "violations", [](const Tuned& self) { return numbers_of(self.evaluations, &TunePoint::violation); },
          "Sum of the relative constraint violations in every evaluation; 0 for feasible gains.")
      .def_property_readonly(
          "engines",
          [](const Tuned& self) {
            std::vector<std::string> engines;
            for (const TunePoint& point : self.evaluations)
              engines.emplace_back(point.engine == armtune::Engine::kNative ? "native" : "simbody");
            return engines;
          },
          "Engine of every evaluation. Unless the search was interrupted, Tuned.objective is from Simbody.")
      .def_readonly("parameters", &Tuned::parameters,
                    "Names of the tuned gains or components, in the order of the columns of points.")
      .def_property_readonly(
          "points", &coordinates,
          "The evaluated points, one row each. A coordinate is 0 at the lower bound of its gain and 1 at the "
          "upper bound.")
      .def_readonly("before", &Tuned::before, "New rollouts of the start gains, without recordings.")
      .def_readonly("after", &Tuned::after, "New rollouts of the best gains, without recordings.")
      .def_readonly("verdict", &Tuned::verdict, "Verdict of the simulation checks.")
      .def_readonly("files", &Tuned::files, "Names of the files in the run folder.");
}

void bind_tune(py::module_& module) {
  module.def(
      "tune",
      [](const Study& study, const MaybePath& folder, bool resume, int workers, bool analysis,
         double deadline, py::object progress) {
        TuneOptions options{text_of(folder), resume, workers, analysis, deadline, {}};
        return watched(std::move(progress), [&, given = study](const Watch& watch) {
          options.watch = watch;
          return armtune::tune(given, options);
        });
      },
      py::arg("study"), py::kw_only(), py::arg("folder") = py::none(), py::arg("resume") = false,
      py::arg("workers") = 1, py::arg("analysis") = true, py::arg("deadline") = 0.0,
      py::arg("progress") = py::none(),
      "Runs a study. The result does not depend on the number of workers. folder: new folder for all files "
      "of the run. analysis: also compute margins, sensitivity, yield and endurance.");
}

void bind_front(py::module_& module) {
  py::class_<FrontPoint>(module, "FrontPoint", made_by_armtune(), "One point of a front.")
      .def_readonly("gains", &FrontPoint::gains)
      .def_readonly("values", &FrontPoint::values, "Values of the criteria, in their units.");
  py::class_<Front>(module, "Front", made_by_armtune(),
                    "A Pareto front: the trade-off between two or three criteria.")
      .def_readonly("points", &Front::points,
                    "Feasible points that no other dominates, ascending in the first criterion.")
      .def_readonly("start", &Front::start)
      .def_readonly("hypervolume", &Front::hypervolume,
                    "Hypervolume that the points dominate; the start gains give the reference point.")
      .def_readonly("files", &Front::files, "Names of the files in the run folder.");
  module.def(
      "front",
      [](const Study& study, const std::vector<std::string>& criteria, const MaybePath& folder, bool resume,
         int workers, std::size_t levels, long max_evaluations, double deadline, py::object progress) {
        FrontOptions options{text_of(folder), resume, workers, levels, max_evaluations, deadline, {}};
        return watched(std::move(progress), [&, given = study](const Watch& watch) {
          options.watch = watch;
          return armtune::front(given, criteria, options);
        });
      },
      py::arg("study"), py::arg("criteria"), py::kw_only(), py::arg("folder") = py::none(),
      py::arg("resume") = false, py::arg("workers") = 1, py::arg("levels") = 0,
      py::arg("max_evaluations") = 0, py::arg("deadline") = 0.0, py::arg("progress") = py::none(),
      "Searches for the Pareto front of two or three criteria. Each criterion is the name of a metric or "
      "'objective'. levels: number of upper bounds to try for each criterion except the first. levels and "
      "max_evaluations: 0 selects the default.");
}

}  // namespace

void bind_searches(py::module_& module) {
  bind_verdict(module);
  bind_tuned(module);
  bind_tune(module);
  bind_evaluator(module);
  bind_front(module);
}

}  // namespace armtune::internal::python
