#include "tuner/session/margins_session.hpp"

#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tuner/robustness/margin_report.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"
#include "tuner/session/report_files.hpp"
#include "tuner/verdict/assumptions.hpp"
#include "tuner/verdict/search_checks.hpp"

namespace armtune::internal {

MarginsSession::MarginsSession(MarginsSettings settings, SessionContext context, SessionObserver& observer)
    : settings_(std::move(settings)), context_(std::move(context)), observer_(observer) {}

MarginsOutcome MarginsSession::run() {
  const FolderLock lock = make_run_folder(settings_.folder);
  const bool writes = !settings_.folder.empty();
  MarginOptions& options = settings_.options;
  observer_.progressed({"simulating the nominal rollouts"});
  options.progress = [this](std::size_t done, std::size_t all) {
    const double left = watch_.seconds() / static_cast<double>(done) * static_cast<double>(all - done);
    observer_.progressed({"margins", static_cast<long>(done), static_cast<long>(all), left});
  };
  if (writes) options.finished = [this](const std::vector<Margin>& so_far) { write_margins(so_far); };
  std::vector<Margin>& found = outcome_.margins;
  found = margins(settings_.scenarios, settings_.gains, options, context_.stop);
  observer_.part_is_over();
  if (!context_.stop) check();
  if (writes) write_results();
  return std::move(outcome_);
}

void MarginsSession::check() {
  SimulationVerdict& verdict = outcome_.verdict;
  add_nominal_checks(settings_.scenarios, outcome_.margins, verdict);
  verdict.not_checked = never_checked();
  add_assumptions(settings_.scenarios, settings_.options.stepper, verdict);
  add_controller_assumption(settings_.scenarios, settings_.gains, verdict);
  outcome_.ending = verdict.passed() ? Ending::kPassed : Ending::kChecksFailed;
}

void MarginsSession::write_margins(const std::vector<Margin>& found) const {
  write_text_file(settings_.folder + "/margins.csv", margins_csv(settings_.scenarios, found));
}

void MarginsSession::write_results() {
  write_margins(outcome_.margins);
  RunRecord record;
  record.kind = RunKind::kMargins;
  record.command = context_.invocation.line;
  record.wall_seconds = watch_.seconds();
  record.workers = settings_.options.workers;
  record.margins = {static_cast<long>(outcome_.margins.size()), settings_.options.stepper};
  FilesRead files;
  if (!settings_.gains_path.empty()) files.inputs = files_of_gains(settings_.gains_path);
  add_inputs(settings_.scenarios, files.inputs);
  write_run_record(settings_.folder, std::move(record), files);
  outcome_.files = {"margins.csv", kRunRecord, "inputs/"};
  if (settings_.gains_path.empty()) {
    write_text_file(settings_.folder + "/gains.yaml", gains_yaml(settings_.gains, {}));
    outcome_.files.emplace_back("gains.yaml");
  }
  if (context_.stop) return;
  write_verdict(settings_.folder, outcome_.verdict);
  outcome_.files.emplace_back("verdict.yaml");
}

}  // namespace armtune::internal
