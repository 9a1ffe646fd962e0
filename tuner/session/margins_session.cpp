#include "tuner/session/margins_session.hpp"

#include <algorithm>

#include "sim/controller_files/parameter_file.hpp"
#include "sim/csv/text_file.hpp"
#include "tuner/robustness/margin_report.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/write_run_record.hpp"

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
  if (writes) write_results();
  if (context_.stop) return std::move(outcome_);
  const auto holds = [](const Margin& m) { return m.stands.has_value(); };
  outcome_.ending = std::all_of(found.begin(), found.end(), holds) ? Ending::kPassed : Ending::kChecksFailed;
  return std::move(outcome_);
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
}

}  // namespace armtune::internal
