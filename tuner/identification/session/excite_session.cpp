#include "tuner/identification/session/excite_session.hpp"

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"
#include "tuner/run/run_folder.hpp"

namespace armtune::internal {
namespace {

constexpr double kTrajectoryPeriod = 0.002;  ///< time between rows of trajectory.csv [s]
constexpr long kShownEvery = 200;            ///< evaluations between two progress reports

}  // namespace

ExciteSession::ExciteSession(ExciteSettings settings, SessionContext context, ExciteObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

ExciteOutcome ExciteSession::run() {
  refuse_used_folder(settings_.folder);  // before the work, not after it
  const Stopwatch watch;
  find_trajectory();
  const FolderLock lock = make_run_folder(settings_.folder);
  write_trajectory();
  observer_.designed(outcome_);
  for (const Scenario& scenario : settings_.scenarios) {
    if (context_.stop || !write_log(scenario)) break;
  }
  Provenance p;
  p.command = context_.invocation.line;
  p.inputs = settings_.model->files;
  add_inputs(settings_.scenarios, p.inputs);
  if (!settings_.trajectory.empty()) p.inputs.push_back(settings_.trajectory);
  p.seed = settings_.design.seed;
  p.wall_seconds = watch.seconds();
  write_provenance(settings_.folder, p);
  outcome_.files.push_back("run.yaml");
  if (!context_.stop) outcome_.ending = Ending::kPassed;
  return std::move(outcome_);
}

void ExciteSession::find_trajectory() {
  const RobotModel& model = *settings_.model;
  if (!settings_.trajectory.empty()) {
    outcome_.excitation = load_excitation(settings_.trajectory, joint_names(model));
    outcome_.use = use_of(outcome_.excitation, model, base_parameters(model));
    return;
  }
  settings_.design.progress = [this](long evaluations, double condition) {
    if (evaluations % kShownEvery != 0) return;
    observer_.progressed({"design", evaluations, settings_.design.evaluations, NAN,
                          fmt::format("condition number {:.4g}", condition)});
  };
  outcome_.design = design_excitation(model, settings_.design, context_.stop);
  outcome_.excitation = outcome_.design->excitation;
  outcome_.use = outcome_.design->use;
  observer_.part_is_over();
}

void ExciteSession::write_trajectory() {
  const auto joints = joint_names(*settings_.model);
  write_text_file(settings_.folder + "/excitation.yaml", excitation_yaml(outcome_.excitation, joints));
  write_text_file(settings_.folder + "/trajectory.csv",
                  excitation_csv(outcome_.excitation, joints, kTrajectoryPeriod));
  outcome_.files = {"excitation.yaml", "trajectory.csv"};
}

bool ExciteSession::write_log(const Scenario& scenario) {
  const ExcitationLog log = simulate_excitation(scenario, outcome_.excitation, settings_.log, context_.stop);
  if (log.interrupted) return false;
  const std::string name = "log_" + scenario.name + ".csv";
  write_text_file(settings_.folder + "/" + name, log_csv(*settings_.model, log));
  outcome_.files.push_back(name);
  observer_.logged(scenario, log);
  return true;
}

}  // namespace armtune::internal
