#include "tuner/validation/session/validate_session.hpp"

#include "sim/csv/text_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/streamed_log.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/validation/session/validation_files.hpp"

namespace armtune::internal {

ValidateSession::ValidateSession(ValidateSettings settings, SessionContext context, SessionObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

ValidateOutcome ValidateSession::run() {
  if (!settings_.folder.empty()) refuse_used_folder(settings_.folder);
  const Stopwatch watch;
  const RobotModel& model = *settings_.model;
  observer_.progressed({"reading the log"});
  outcome_.logged = read_logged_joints(model, settings_.logs, settings_.options);
  observer_.part_is_over();
  if (context_.stop) return std::move(outcome_);
  observer_.progressed({"comparing the log with the robot file"});
  outcome_.found = validate_log(model, outcome_.logged, settings_.thresholds);
  observer_.part_is_over();
  if (context_.stop) return std::move(outcome_);
  if (!settings_.folder.empty()) write_files(watch.seconds());
  outcome_.ending = outcome_.found.matches() ? Ending::kPassed : Ending::kChecksFailed;
  return std::move(outcome_);
}

void ValidateSession::write_files(double seconds) {
  const std::string& folder = settings_.folder;
  const RobotModel& model = *settings_.model;
  const LogValidation& found = outcome_.found;
  const FolderLock lock = make_run_folder(folder);
  if (found.torques) {
    write_text_file(folder + "/residuals.csv", residuals_csv(model, found.torques->rows));
    outcome_.files.emplace_back("residuals.csv");
  }
  if (found.motion) {
    write_text_file(folder + "/horizons.csv", horizons_csv(model, *found.motion));
    outcome_.files.emplace_back("horizons.csv");
  }
  RunRecord record;
  record.kind = RunKind::kValidate;
  record.command = context_.invocation.line;
  record.wall_seconds = seconds;
  record.validation = validation_facts(model, outcome_.logged, found);
  FilesRead files{model.files};
  files.inputs.insert(files.inputs.end(), settings_.files.begin(), settings_.files.end());
  for (const std::string& log : settings_.logs) add_log(log, files);
  write_run_record(folder, std::move(record), files);
  outcome_.files.emplace_back(kRunRecord);
  if (add_page(folder, observer_)) outcome_.files.emplace_back(kReport);
}

}  // namespace armtune::internal
