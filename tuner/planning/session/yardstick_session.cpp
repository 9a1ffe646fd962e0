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
#include "tuner/session/report_files.hpp"

namespace armtune::internal {
namespace {

/// Returns the path of the provenance file of a yardstick CSV file: the same path with the ending .yaml.
std::string provenance_path(const std::string& csv) {
  return std::filesystem::path(csv).replace_extension(".yaml").string();
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
    refuse_existing(provenance_path(settings_.out));
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

std::string YardstickSession::provenance_text(const std::vector<Scenario>& scenarios,
                                              const RolloutMeasures& found, double seconds) const {
  Provenance p;
  p.command = context_.invocation.line;
  p.inputs = {settings_.folder + "/gains.yaml"};
  p.streamed = found.recordings;
  add_inputs(scenarios, p.inputs);
  p.wall_seconds = seconds;
  p.extra = {{"events", std::to_string(found.measures.size())},
             {"velocity", fmt::format("{}", settings_.options.velocity)},
             {"effort", fmt::format("{}", settings_.options.effort)},
             {"knots", std::to_string(settings_.options.knots)}};
  return run_yaml(p);
}

void YardstickSession::write_files(const std::vector<Scenario>& scenarios, const RolloutMeasures& found,
                                   double seconds) {
  const bool own = settings_.out.empty();
  const std::string csv = own ? settings_.folder + "/yardstick.csv" : settings_.out;
  const std::string table = yardstick_csv(found.measures);
  const std::string origin = provenance_text(scenarios, found, seconds);
  own ? write_text_file(csv, table) : write_new_text_file(csv, table);
  own ? write_text_file(provenance_path(csv), origin) : write_new_text_file(provenance_path(csv), origin);
  outcome_.files = {csv, provenance_path(csv)};
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
