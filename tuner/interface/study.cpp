#include "armtune/study.hpp"

#include <fmt/format.h>

#include <limits>

#include "armtune/error.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "tuner/first_task/steady_start.hpp"
#include "tuner/interface/kept_inputs.hpp"
#include "tuner/interface/observing.hpp"
#include "tuner/interface/rollout_maker.hpp"
#include "tuner/session/controller_study_session.hpp"
#include "tuner/session/study_files.hpp"
#include "tuner/study/study.hpp"

namespace armtune {
namespace {

template <class Change>
std::shared_ptr<const internal::Study> changed(const internal::Study& study, Change change) {
  internal::Study copy = study;
  change(copy);
  return std::make_shared<const internal::Study>(std::move(copy));
}

/// Returns the scenarios of a study that was just read from files, together with the hashes of their files.
std::vector<Scenario> read_scenarios(const internal::Study& study) {
  std::vector<Scenario> scenarios;
  for (const internal::Scenario& scenario : study.scenarios) {
    scenarios.emplace_back(scenario, std::make_shared<const InputFiles>(input_files(scenario.inputs)));
  }
  return scenarios;
}

/// Returns a study that was just read from files, together with the hashes of its files.
Study with_files(internal::Study study) {
  auto scenarios = read_scenarios(study);
  auto files = std::make_shared<const InputFiles>(input_files(internal::files_of(study)));
  return {std::move(study), std::move(scenarios), std::move(files)};
}

/// Throws InputError if an option is outside its limits.
void require_between(const char* key, double value, double least, double most) {
  if (value >= least && value <= most) return;
  throw InputError(InputPlace{.key = key},
                   InputFault{fmt::format("{} is out of range", value), fmt::to_string(value),
                              fmt::format("{} to {}", least, most)});
}

void require_valid(const ControllerStudyOptions& options) {
  require_workers(options.workers);
  if (options.folder.empty())
    throw InputError(InputPlace{.key = "folder"},
                     "none is given; give a new folder for the files of the study");
  if (options.rate != 0.0) require_between("rate", options.rate, 10.0, 10000.0);
  require_between("speed", options.speed, 0.01, 10.0);
  for (const double stiffness : options.max_stiffness)
    require_between("max_stiffness", stiffness, std::numeric_limits<double>::min(), 1e9);
}

}  // namespace

Study::Study(internal::Study inside, std::vector<Scenario> scenarios, std::shared_ptr<const InputFiles> files)
    : inside_(std::make_shared<const internal::Study>(std::move(inside))),
      scenarios_(std::move(scenarios)),
      files_(std::move(files)) {}

Study Study::load(const std::string& name_or_path, const std::string& controller) {
  return with_files(internal::load_study(name_or_path, controller));
}

Study Study::from_controllers(const std::string& robot, const std::string& controllers,
                              const std::vector<std::string>& trajectories,
                              const ControllerStudyOptions& options) {
  require_valid(options);
  if (trajectories.empty())
    throw InputError(InputPlace{.key = "trajectories"}, "none are given; give at least one file of a motion");
  internal::ControllerStudyInputs inputs{robot, controllers, options.node, trajectories};
  inputs.rate = options.rate;
  inputs.speed = options.speed;
  inputs.degrees = options.degrees;
  inputs.max_stiffness = options.max_stiffness;
  inputs.kind = options.controller;
  inputs.distro = options.distro;
  Observing<internal::SessionObserver> observer(options.watch);
  const auto files = internal::make_controller_study(
      inputs, options.folder, options.planner ? *options.planner : internal::MotionPlanner(), observer,
      stop_of(options.watch));
  if (!files) throw FailedError("interrupted while a motion was planned; nothing was written");
  for (const std::string& note : files->notes) observer.warned(note);
  return with_files(internal::load_steady_study(files->study, {}, options.workers));
}

Study Study::parse(const std::string& yaml, const StudyInputs& inputs) {
  internal::StudyParts parts;
  parts.scenarios = internal_of(inputs.scenarios);
  if (inputs.start) {
    internal::validate(inputs.start->inside(), inputs.start->joints(), "gains");
    parts.start = inputs.start->inside();
    parts.joints = inputs.start->joints();
  }
  const auto names = std::make_shared<std::vector<std::string>>();  // names of the scenarios; filled in below
  if (inputs.objective) {
    parts.objective = [objective = inputs.objective,
                       names](const std::vector<internal::RolloutResult>& results) {
      std::vector<Rollout> rollouts;
      for (std::size_t s = 0; s < results.size(); ++s)
        rollouts.push_back(RolloutMaker::made({(*names)[s], results[s]}));
      return objective(rollouts);
    };
  }
  internal::Study study = internal::parse_study(yaml, parts);
  for (const internal::Scenario& scenario : study.scenarios) names->push_back(scenario.name);
  auto scenarios = inputs.scenarios.empty() ? read_scenarios(study) : inputs.scenarios;
  return {std::move(study), std::move(scenarios), nullptr};
}

const std::string& Study::name() const {
  return inside_->name;
}

Gains Study::start() const {
  return {inside_->space.start, internal::joint_names(*inside_->scenarios.front().robot)};
}

std::vector<std::string> Study::parameters() const {
  std::vector<std::string> names;
  for (const internal::Parameter& parameter : inside_->space.free) names.push_back(parameter.entry.name);
  return names;
}

long Study::max_evaluations() const {
  return inside_->max_evaluations;
}
std::uint64_t Study::seed() const {
  return inside_->solver.seed;
}

void Study::set_max_evaluations(long most) {
  if (most < 1)
    throw InputError(InputPlace{.key = "max_evaluations"}, fmt::format("{}; it must be at least 1", most))
        .with_value(std::to_string(most), "at least 1");
  inside_ = changed(*inside_, [&](internal::Study& s) { s.max_evaluations = most; });
}

void Study::set_seed(std::uint64_t seed) {
  inside_ = changed(*inside_, [&](internal::Study& s) { s.solver.seed = seed; });
}

}  // namespace armtune
