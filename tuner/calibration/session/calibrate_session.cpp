#include "tuner/calibration/session/calibrate_session.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "core/robot/urdf_writer.hpp"
#include "sim/csv/text_file.hpp"
#include "tuner/calibration/calibration_files.hpp"
#include "tuner/calibration/session/calibration_tables.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/streamed_log.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/validation/log_checks.hpp"

namespace armtune::internal {
namespace {

/// Returns what is wrong with the log itself, such as positions in degrees, as sentences.
std::vector<std::string> faults_of_log(const RobotModel& model, const JointLog& log) {
  std::vector<std::string> sentences;
  try {
    for (const LogFinding& finding : motion_findings(model, log, joint_motion(model, log)))
      sentences.push_back(to_text(finding, model));
  } catch (const InputError&) {  // too short for these checks; calibrate() says what it needs
  }
  return sentences;
}

[[noreturn]] void refuse_without_commands(const std::string& path, const JointLog& log) {
  const char* then = log.has_torques() ? "; record them, or take the measured torques with --commands torque"
                                       : "; record them beside the positions";
  throw InputError(InputPlace{path, 0, "--commands"},
                   {fmt::format("the log has no commands to the joints, which calibration simulates{}", then),
                    "none", "torque, velocity or position"});
}

}  // namespace

CalibrateSession::CalibrateSession(CalibrateSettings settings, SessionContext context,
                                   SessionObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

CalibrateOutcome CalibrateSession::run() {
  if (!settings_.folder.empty()) refuse_used_folder(settings_.folder);
  const Stopwatch watch;
  const std::vector<CommandedLog> logs = read_logs();
  observer_.part_is_over();
  if (context_.stop) return std::move(outcome_);
  outcome_.found = calibrate(*settings_.model, logs, fit_options());
  observer_.part_is_over();
  if (outcome_.found.interrupted) return std::move(outcome_);
  CalibrationFacts& facts = outcome_.facts;
  facts = calibration_facts(*settings_.model, outcome_.found);
  facts.samples = samples_;
  facts.duration = duration_;
  facts.notes = std::move(notes_);
  facts.cautions.insert(facts.cautions.end(), findings_.begin(), findings_.end());
  if (!settings_.folder.empty()) write_files(watch.seconds());
  outcome_.ending = facts.better ? Ending::kPassed : Ending::kChecksFailed;
  return std::move(outcome_);
}

std::vector<CommandedLog> CalibrateSession::read_logs() {
  std::vector<CommandedLog> logs;
  LoggedJointsOptions options = settings_.options;
  for (const std::string& path : settings_.logs) {
    if (context_.stop) break;
    observer_.progressed({"reading " + path});
    logs.push_back(read(path, options));
    options.command = logs.front().commands.kind;
  }
  return logs;
}

CommandedLog CalibrateSession::read(const std::string& path, const LoggedJointsOptions& options) {
  LoggedJoints logged = read_logged_joints(*settings_.model, {path}, options);
  const JointLog& log = logged.log;
  if (!logged.commands) refuse_without_commands(path, log);
  const std::string of_log = settings_.logs.size() > 1 ? path + ": " : "";
  for (const std::string& note : logged.notes) notes_.push_back(of_log + note);
  for (const std::string& fault : faults_of_log(*settings_.model, log)) findings_.push_back(of_log + fault);
  samples_ += log.samples();
  if (log.samples() > 0) duration_ += log.time.back() - log.time.front();
  return {std::move(logged.log), *std::move(logged.commands)};
}

CalibrationOptions CalibrateSession::fit_options() {
  CalibrationOptions options;
  options.priors = settings_.priors;
  options.stop = &context_.stop;
  options.progress = [this](const char* phase, int iteration, double /*objective*/) {
    observer_.progressed({fmt::format("fit to {} windows, iteration {}", phase, iteration)});
  };
  return options;
}

void CalibrateSession::write_files(double seconds) {
  const std::string& folder = settings_.folder;
  const RobotModel& model = *settings_.model;
  const Calibration& found = outcome_.found;
  const FolderLock lock = make_run_folder(folder);
  const auto write = [&](const char* file, const std::string& text) {
    write_text_file(folder + "/" + file, text);
    outcome_.files.emplace_back(file);
  };
  // An arm that does not predict the held-out part better must not be used in place of the robot file.
  if (outcome_.facts.better) {
    write("robot.yaml", calibrated_robot_yaml(model, found, "robot.urdf"));
    write("robot.urdf", urdf_text(calibrated_model(model, found)));
    write("uncertainty.yaml", uncertainty_yaml(found));
  }
  write("parameters.csv", parameters_csv(model, found));
  write("held_out.csv", held_out_csv(model, found));
  RunRecord record;
  record.kind = RunKind::kCalibrate;
  record.command = context_.invocation.line;
  record.wall_seconds = seconds;
  record.calibration = outcome_.facts;
  FilesRead files{model.files};
  files.inputs.insert(files.inputs.end(), settings_.files.begin(), settings_.files.end());
  for (const std::string& log : settings_.logs) add_log(log, files);
  write_run_record(folder, std::move(record), files);
  outcome_.files.emplace_back(kRunRecord);
  if (add_page(folder, observer_)) outcome_.files.emplace_back(kReport);
}

}  // namespace armtune::internal
