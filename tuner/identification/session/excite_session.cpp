#include "tuner/identification/session/excite_session.hpp"

#include <fmt/format.h>

#include "sim/csv/text_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"

namespace armtune::internal {
namespace {

constexpr double kTrajectoryPeriod = kDistancePeriod;  ///< time between rows of trajectory.csv [s]
constexpr long kShownEvery = 200;                      ///< evaluations between two progress reports

}  // namespace

ExciteSession::ExciteSession(ExciteSettings settings, SessionContext context, ExciteObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

ExciteOutcome ExciteSession::run() {
  refuse_used_folder(settings_.folder);  // before the work, not after it
  const Stopwatch watch;
  find_trajectory();
  outcome_.contact = contact_sentences(outcome_.nearest, settings_.design.kept);
  const FolderLock lock = make_run_folder(settings_.folder);
  write_trajectory();
  observer_.designed(outcome_);
  for (const Scenario& scenario : settings_.scenarios) {
    if (context_.stop || !write_log(scenario)) break;
  }
  write_record(watch.seconds());
  if (!context_.stop) outcome_.ending = Ending::kPassed;
  return std::move(outcome_);
}

void ExciteSession::write_record(double seconds) {
  RunRecord record;
  record.kind = RunKind::kExcite;
  record.command = context_.invocation.line;
  record.wall_seconds = seconds;
  record.seed = settings_.design.seed;
  record.excitation = {settings_.trajectory.empty(), outcome_.use.condition};
  FilesRead files{settings_.model->files};
  files.inputs.insert(files.inputs.end(), settings_.cell_files.begin(), settings_.cell_files.end());
  if (const auto& model = settings_.design.kept.model)
    files.inputs.insert(files.inputs.end(), model->arm().meshes.begin(), model->arm().meshes.end());
  add_inputs(settings_.scenarios, files.inputs);
  if (!settings_.trajectory.empty()) files.inputs.push_back(settings_.trajectory);
  write_run_record(settings_.folder, std::move(record), files);
  outcome_.files.emplace_back(kRunRecord);
}

void ExciteSession::find_trajectory() {
  const RobotModel& model = *settings_.model;
  if (!settings_.trajectory.empty()) {
    outcome_.excitation = load_excitation(settings_.trajectory, joint_names(model));
    outcome_.use = use_of(outcome_.excitation, model, base_parameters(model));
    const DistancesAlong distances = distances_along(outcome_.excitation, settings_.design.kept);
    outcome_.nearest = distances.nearest;
    const std::string near = too_near_clause(distances.too_near, settings_.design.kept);
    if (!near.empty()) observer_.warned(fmt::format("{}: {}", settings_.trajectory, near));
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
  outcome_.nearest = outcome_.design->distances.nearest;
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
