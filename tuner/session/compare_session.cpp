#include "tuner/session/compare_session.hpp"

#include <filesystem>

#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/rollouts/recording_memory.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/session/task_notes.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/rollout_checks.hpp"

namespace armtune::internal {

CompareSession::CompareSession(RolloutSettings settings, std::vector<GainsToSimulate> sets,
                               SessionContext context, SessionObserver& observer)
    : settings_(std::move(settings)),
      sets_(std::move(sets)),
      context_(std::move(context)),
      observer_(observer) {}

CompareOutcome CompareSession::run() {
  for (const GainsToSimulate& set : sets_) {
    for (const Scenario& s : settings_.scenarios) refuse_winding(s, set.gains_of(s));
  }
  const std::string& folder = settings_.folder;
  if (!folder.empty())
    require_recording_memory(settings_.scenarios, settings_.record_every, settings_.workers);
  const FolderLock lock = make_run_folder(folder);
  if (!simulate_sets()) return std::move(outcome_);
  if (!folder.empty()) write_files();  // before the endurance, which may take hours
  check();
  if (!folder.empty()) write_conclusion();
  if (!context_.stop) {
    outcome_.ending = outcome_.verdict.passed() ? Ending::kPassed : Ending::kChecksFailed;
  }
  return std::move(outcome_);
}

/// Returns the folder of a set's gains and recordings.
std::string CompareSession::recordings_of(const std::string& set) const {
  return settings_.folder + "/rollouts_" + set;
}

/// Simulates all gain sets. If interrupted, removes their files and returns false.
bool CompareSession::simulate_sets() {
  for (const GainsToSimulate& set : sets_) {
    const std::string below = settings_.folder.empty() ? "" : recordings_of(set.name);
    if (!below.empty()) make_folder(below);
    outcome_.sets.push_back(
        {set.name, simulate(settings_.scenarios, set.gains_of,
                            simulate_options(settings_, below, set.name, observer_), context_.stop)});
    if (context_.stop) break;
  }
  observer_.part_is_over();
  if (!context_.stop) return true;
  std::error_code ignored;
  for (const ComparedSet& set : outcome_.sets) {
    if (!settings_.folder.empty()) std::filesystem::remove_all(recordings_of(set.name), ignored);
  }
  outcome_.sets.clear();
  return false;
}

/// Checks all gain sets in one verdict. Each failure names its gain set.
void CompareSession::check() {
  bool extended = true;
  for (std::size_t i = 0; i < sets_.size(); ++i) {
    outcome_.endured.push_back(extended ? extend_scenarios(settings_, sets_[i], observer_, context_.stop)
                                        : std::nullopt);
    extended = check_rollouts(settings_, outcome_.sets[i].results, outcome_.endured.back(), sets_[i].name,
                              outcome_.verdict);
  }
  add_unchecked(settings_.scenarios, extended, outcome_.verdict);
  add_engine_assumption(settings_.engine, "the scenarios", outcome_.verdict);
  add_assumptions(settings_.scenarios, settings_.stepper, outcome_.verdict);
}

void CompareSession::write_files() const {
  write_text_file(settings_.folder + "/comparison.csv", comparison_csv(outcome_.sets));
  for (const ComparedSet& set : outcome_.sets) {
    write_text_file(settings_.folder + "/errors_" + set.name + ".csv", errors_csv(set.results));
  }
  RunRecord record;
  record.kind = RunKind::kCompare;
  record.command = context_.invocation.line;
  record.workers = settings_.workers;
  record.simulation = {settings_.stepper, settings_.engine, {}};
  record.compare.emplace();
  FilesRead files;
  for (const GainsToSimulate& set : sets_) {
    record.compare->sets.push_back(set.name);
    for (const std::string& file : files_of_gains(set.path)) files.inputs.push_back(file);
  }
  add_inputs(settings_.scenarios, files.inputs);
  write_run_record(settings_.folder, std::move(record), files);
}

report::Scene CompareSession::scene() const {
  const Scenario& first = settings_.scenarios.front();
  std::vector<report::SceneSet> shown;
  shown.reserve(sets_.size());
  for (const GainsToSimulate& set : sets_) {
    write_text_file(recordings_of(set.name) + "/gains.yaml",
                    gains_yaml(set.gains_of(first), {"from " + set.name}));
    shown.push_back({set.name, "rollouts_" + set.name, "errors_" + set.name + ".csv"});
  }
  return report::scene_of(settings_.scenarios, std::move(shown),
                          sets_.front().gains_of(first).obstacleInfluenceRadius);
}

void CompareSession::write_conclusion() {
  outcome_.files = {"comparison.csv", "errors_<set>.csv", "rollouts_<set>/", kRunRecord, "inputs/"};
  if (!context_.stop) {
    write_verdict(settings_.folder, outcome_.verdict);
    outcome_.files.emplace_back("verdict.yaml");
  }
  const auto pages = add_report(
      settings_.folder, [this] { return scene(); }, observer_);
  outcome_.files.insert(outcome_.files.end(), pages.begin(), pages.end());
}

}  // namespace armtune::internal
