// Binds studies: read from files, built in code, or made from the files of a robot.

#include <fmt/format.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include "armtune/error.hpp"
#include "armtune/study.hpp"
#include "core/common/utf8.hpp"
#include "python/bindings.hpp"
#include "python/watched.hpp"

#ifdef ARMTUNE_SUITESPARSE
#include "armtune/plan.hpp"
#endif

namespace py = pybind11;

namespace armtune::internal::python {
namespace {

using armtune::Gains;
using armtune::Scenario;
using armtune::Study;

/// Converts a Python function. An exception of the function ends the search, and is raised again by the call
/// that started the search.
std::function<double(const std::vector<Rollout>&)> objective_of(py::object function) {
  if (function.is_none()) return {};
  // Threads that do not hold the GIL copy and destroy the function.
  const std::shared_ptr<py::object> kept(new py::object(std::move(function)), [](py::object* held) {
    const py::gil_scoped_acquire lock;
    delete held;
  });
  return [kept](const std::vector<Rollout>& rollouts) {
    const py::gil_scoped_acquire lock;
    try {
      return (*kept)(rollouts).cast<double>();
    } catch (const py::cast_error&) {
      throw FailedError(
          "objective: the function returned a value that is not a number; return a number above 0");
    }
  };
}

Study make_study(const py::object& description, const std::optional<std::vector<Scenario>>& scenarios,
                 const std::optional<Gains>& gains, py::object objective) {
  StudyInputs inputs;
  if (scenarios) inputs.scenarios = *scenarios;
  inputs.start = gains;
  inputs.objective = objective_of(std::move(objective));
  // JSON is also valid YAML.
  const auto text = py::isinstance<py::str>(description)
                        ? description.cast<std::string>()
                        : py::module_::import("json").attr("dumps")(description).cast<std::string>();
  return Study::parse(text, inputs);
}

/// Returns the study, or None, with which Interrupted is raised.
py::object study_from_controllers(const std::filesystem::path& robot, const MaybePath& controllers,
                                  const std::vector<std::filesystem::path>& trajectories,
                                  ControllerStudyOptions options, py::object progress) {
  std::vector<std::string> motions;
  for (const std::filesystem::path& motion : trajectories) motions.push_back(motion.string());
#ifdef ARMTUNE_SUITESPARSE
  options.planner = motion_planner();
#endif
  return py::cast(watched(std::move(progress), [&](const Watch& watch) -> std::optional<Study> {
    options.watch = watch;
    try {
      return Study::from_controllers(robot.string(), text_of(controllers), motions, options);
    } catch (const FailedError&) {
      if (*watch.stop) return std::nullopt;
      throw;
    }
  }));
}

void bind_study_from_controllers(py::module_& module) {
  module.def(
      "study_from_controllers",
      [](const std::filesystem::path& robot, const MaybePath& controllers,
         const std::vector<std::filesystem::path>& trajectories, const std::filesystem::path& folder,
         const std::string& controller, const std::string& node, const std::string& distro, double rate,
         double speed, bool degrees, const std::vector<double>& max_stiffness, int workers,
         py::object progress) {
        return study_from_controllers(
            robot, controllers, trajectories,
            {folder.string(), controller, node, distro, rate, speed, degrees, max_stiffness, workers, {}, {}},
            std::move(progress));
      },
      py::arg("robot"), py::arg("controllers"), py::arg("trajectories"), py::kw_only(), py::arg("folder"),
      py::arg("controller") = "", py::arg("node") = "", py::arg("distro") = "", py::arg("rate") = 0.0,
      py::arg("speed") = 1.0, py::arg("degrees") = false, py::arg("max_stiffness") = std::vector<double>(),
      py::arg("workers") = 1, py::arg("progress") = py::none(),
      "Makes a study from the files of a robot, as 'armtune init' does, and writes it into a new folder. "
      "robot: bundled name, robot file or URDF. controllers: ROS parameter file of the controller; None: "
      "give the name of a controller and its rate. trajectories: files of motions. The other arguments are "
      "those of 'armtune init'. Start gains that diverge or oscillate are replaced. If every check passes, "
      "tune(study, folder=...) leaves the parameter file with the tuned gains in its folder.");
}

void bind_study_class(py::module_& module) {
  py::class_<Study>(module, "Study", made_by_armtune(),
                    "The gains to tune, the scenarios, the objective and the constraints.")
      .def_property_readonly("name", [](const Study& self) { return as_utf8(self.name()); })
      .def_property_readonly("scenarios", &Study::scenarios)
      .def_property_readonly("start", &Study::start)
      .def_property_readonly("parameters", &Study::parameters,
                             "Names of the tuned gains, or of their components.")
      .def_property(
          "max_evaluations", &Study::max_evaluations, &Study::set_max_evaluations,
          "Largest number of evaluations, including the start gains and the sweep, a coarse grid around "
          "them.")
      .def_property(
          "seed", &Study::seed,
          [](Study& self, std::int64_t seed) {
            if (seed < 0) throw py::value_error(fmt::format("seed: {}; it must not be negative", seed));
            self.set_seed(static_cast<std::uint64_t>(seed));
          },
          "Seed of algorithms that use random numbers.");
}

}  // namespace

void bind_studies(py::module_& module) {
  bind_study_class(module);
  bind_study_from_controllers(module);
  module.def(
      "load_study",
      [](const std::filesystem::path& name, const std::string& controller) {
        return Study::load(name.string(), controller);
      },
      py::arg("name"), py::arg("controller") = "",
      "Loads a bundled study by name, or a study file by path. controller: name of a controller to tune "
      "instead of the study's controller.");
  module.def(
      "make_study", &make_study, py::arg("description"), py::kw_only(), py::arg("scenarios") = py::none(),
      py::arg("gains") = py::none(), py::arg("objective") = py::none(),
      "Makes a study from a dict or text with the keys of a study file. scenarios, gains: replace the keys "
      "'scenarios' and 'gains'. objective: a function that replaces the key 'objective'. It takes a list of "
      "rollouts, one for each scenario, and returns a number above zero; less is better.");
}

}  // namespace armtune::internal::python
