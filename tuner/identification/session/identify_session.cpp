#include "tuner/identification/session/identify_session.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/identification/identification_files.hpp"
#include "tuner/identification/theta_doubts.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"

namespace armtune::internal {
namespace {

constexpr long kSamplesShown = 20000;  ///< samples between two progress reports

/// Returns the reasons why the logs may not be of this arm. If there is a likely mistake, it is returned
/// alone, because everything else follows from it. Otherwise these are the doubts about the result.
std::vector<std::string> find_doubts(const RobotModel& model, const Identification& found) {
  if (found.comparison.mistake) return {to_text(*found.comparison.mistake, model)};
  return theta_doubts(model, found);
}

/// Returns the rms torque of every joint, and the rms errors of the models.
std::vector<JointTorqueFact> torques_of(const RobotModel& model, const Identification& found) {
  std::vector<JointTorqueFact> torques;
  for (int j = 0; j < model.n(); ++j) {
    JointTorqueFact& torque = torques.emplace_back();
    torque.joint = model.joints[static_cast<std::size_t>(j)].name;
    torque.rms = found.fitted.torque[j];
    torque.fitted = found.fitted.by_theta[j];
    if (found.held_out.rows > 0) torque.held_out = found.held_out.by_theta[j];
    torque.robot_file = found.fitted.by_file[j];
  }
  return torques;
}

/// Removes the folder if it is empty. It is made before the logs are read, because reading can take minutes.
void remove_if_empty(const std::string& folder) {
  std::error_code ignored;
  if (!folder.empty()) std::filesystem::remove(folder, ignored);
}

}  // namespace

IdentifySession::IdentifySession(IdentifySettings settings, SessionContext context, SessionObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

IdentifyOutcome IdentifySession::run() {
  const std::string& folder = settings_.folder;
  const FolderLock lock = make_run_folder(folder);
  settings_.options.progress = [this, shown = -1L](int pass, std::size_t log, long samples) mutable {
    if (samples / kSamplesShown == shown) return;
    shown = samples / kSamplesShown;
    observer_.progressed({fmt::format("pass {}, log {} of {}, {} samples", pass + 1, log + 1,
                                      settings_.logs.size(), samples)});
  };
  const Stopwatch watch;
  try {
    outcome_.found =
        identify(*settings_.model, settings_.logs, settings_.columns, settings_.options, context_.stop);
  } catch (const InputError&) {
    remove_if_empty(folder);
    throw;
  }
  observer_.part_is_over();
  if (outcome_.found.interrupted) return std::move(outcome_);
  outcome_.seconds = watch.seconds();
  outcome_.doubts = find_doubts(*settings_.model, outcome_.found);
  if (!folder.empty() && (outcome_.doubts.empty() || settings_.accept)) {
    write_files();
  } else {
    remove_if_empty(folder);
  }
  outcome_.ending = outcome_.doubts.empty() ? Ending::kPassed : Ending::kChecksFailed;
  return std::move(outcome_);
}

void IdentifySession::write_files() {
  const std::string& folder = settings_.folder;
  const RobotModel& model = *settings_.model;
  const Identification& found = outcome_.found;
  const std::vector<std::string>& doubts = outcome_.doubts;
  const RobotModel identified = with_theta(model, found.theta);
  std::vector<std::string> header = {
      fmt::format("theta of {}, identified by armtune from {} samples", model.name, found.samples),
      "to start a scenario's controller with this theta: `theta_start: {file: theta.yaml}`"};
  for (const std::string& doubt : doubts) header.push_back("ACCEPTED ALTHOUGH " + doubt);
  write_text_file(folder + "/theta.yaml", theta_yaml(model, found.theta, header));
  write_text_file(folder + "/base_parameters.csv", base_parameters_csv(model, found));
  write_text_file(folder + "/robot.urdf", urdf_text(identified));
  write_text_file(folder + "/robot.yaml", identified_robot_yaml(identified, "robot.urdf"));
  write_record();
  outcome_.files = {"theta.yaml", "base_parameters.csv", "robot.urdf", "robot.yaml", kRunRecord};
}

void IdentifySession::write_record() const {
  const RobotModel& model = *settings_.model;
  const Identification& found = outcome_.found;
  RunRecord record;
  record.kind = RunKind::kIdentify;
  record.command = context_.invocation.line;
  record.wall_seconds = outcome_.seconds;
  record.identification = {static_cast<long>(found.samples), static_cast<long>(found.base.rank()),
                           found.estimate.condition,         found.made_physical,
                           torques_of(model, found),         outcome_.doubts};
  FilesRead files{model.files};
  if (!settings_.columns_path.empty()) files.inputs.push_back(settings_.columns_path);
  for (std::size_t i = 0; i < settings_.logs.size(); ++i)
    files.streamed.emplace_back(settings_.logs[i], found.log_hashes[i]);
  write_run_record(settings_.folder, std::move(record), files);
}

}  // namespace armtune::internal
