#include "tuner/planning/session/yardstick_session.hpp"

#include <fmt/format.h>

#include <filesystem>

#include "armtune/error.hpp"
#include "core/common/path_state.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/planning/session/rollout_scenarios.hpp"
#include "tuner/planning/yardstick/yardstick_file.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/session/report_files.hpp"

namespace armtune::internal {
namespace {

/// Returns the path of the record of a yardstick CSV file: the same path with the ending .json.
std::string record_path(const std::string& csv) {
  return std::filesystem::path(csv).replace_extension(".json").string();
}

}  // namespace

YardstickSession::YardstickSession(YardstickSettings settings, SessionContext context,
                                   YardstickObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

YardstickOutcome YardstickSession::run() {
  const std::string& folder = settings_.folder;
  if (folder.empty() || !is_there(folder + "/."))
    throw InputError(InputPlace{folder},
                     "is not a folder; give the run folder of 'tune' or of 'simulate --out'");
  if (!settings_.out.empty()) {
    refuse_existing(settings_.out);
    refuse_existing(record_path(settings_.out));
  }
  const Stopwatch watch;
  const std::vector<Scenario> scenarios = rollout_scenarios(folder, settings_.scenarios);
  const std::string gains = run_file(folder, "gains.yaml");
  RolloutMeasures found = measure_rollouts(
      folder, scenarios, [&gains](const Scenario& s) { return load_gains(gains, joint_names(*s.robot)); },
      settings_.options, context_.stop, observer_);
  if (!context_.stop || !found.measures.empty()) write_files(scenarios, found, watch.seconds());
  outcome_.measures = std::move(found.measures);
  if (!context_.stop) outcome_.ending = Ending::kPassed;
  return std::move(outcome_);
}

std::string YardstickSession::record_text(const std::vector<Scenario>& scenarios,
                                          const RolloutMeasures& found, double seconds) const {
  RunRecord record;
  record.kind = RunKind::kYardstick;
  record.command = context_.invocation.line;
  record.wall_seconds = seconds;
  record.yardstick = {static_cast<long>(found.measures.size()), settings_.options.velocity,
                      settings_.options.effort, settings_.options.knots};
  FilesRead files{{settings_.folder + "/gains.yaml"}, found.recordings};
  add_inputs(scenarios, files.inputs);
  return run_record_json(with_circumstances(std::move(record), files));
}

void YardstickSession::write_files(const std::vector<Scenario>& scenarios, const RolloutMeasures& found,
                                   double seconds) {
  const bool own = settings_.out.empty();
  const std::string csv = own ? settings_.folder + "/yardstick.csv" : settings_.out;
  const std::string table = yardstick_csv(found.measures);
  const std::string record = record_text(scenarios, found, seconds);
  own ? write_text_file(csv, table) : write_new_text_file(csv, table);
  own ? write_text_file(record_path(csv), record) : write_new_text_file(record_path(csv), record);
  outcome_.files = {csv, record_path(csv)};
  if (!own) return;
  const std::string run = run_folder_of(settings_.folder);
  if (const std::string columns = add_columns(run, {"yardstick.csv", yardstick_columns()}); !columns.empty())
    outcome_.files.push_back(columns);
  write_report_again(run);
}

/// Writes the report of the run again, with the new comparison, if the run has one. An error is only a
/// warning, because the comparison is written already.
void YardstickSession::write_report_again(const std::string& run) {
  const std::string page = run + "/" + kReport;
  std::error_code ignored;
  if (!std::filesystem::exists(page, ignored) || !report::available()) return;
  try {
    warn_of_left_out(report::write_report(run, page), observer_);
    outcome_.files.push_back(page);
  } catch (const std::exception& error) {
    observer_.warned(fmt::format("the report was not updated: {}", error.what()));
  }
}

}  // namespace armtune::internal
