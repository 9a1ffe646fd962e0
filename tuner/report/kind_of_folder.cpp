#include "tuner/report/kind_of_folder.hpp"

#include <filesystem>
#include <optional>

#include "armtune/error.hpp"
#include "core/common/path_state.hpp"
#include "tuner/journal/journal.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_record.hpp"

namespace armtune::internal::report {
namespace {

constexpr RunKind kKinds[] = {RunKind::kSimulate, RunKind::kTune, RunKind::kPareto, RunKind::kRobustness,
                              RunKind::kCompare};

/// Returns the kind by the run's record, or nothing if there is no record, a damaged one, or one of a run
/// without a page.
std::optional<RunKind> recorded_kind(const std::string& folder) {
  try {
    const auto record = find_run_record(folder);
    if (record && has_page(record->kind)) return record->kind;
  } catch (const InputError&) {  // the other files decide
  }
  return std::nullopt;
}

/// Returns the kind by the command in the journal, or nothing if there is no journal or a damaged one.
std::optional<RunKind> journal_kind(const std::string& folder) {
  try {
    const auto path = find_run_file(folder, "journal.txt");
    if (!path) return std::nullopt;
    const RunHeader header = read_run_header(*path);
    for (const RunKind kind : kKinds) {
      if (!header.arguments.empty() && header.arguments.front() == name(kind)) return kind;
    }
  } catch (const InputError&) {  // the other files decide
  }
  return std::nullopt;
}

}  // namespace

RunKind kind_of(const std::string& folder) {
  const auto has = [&folder](const char* file) {
    std::error_code ignored;
    return std::filesystem::exists(folder + "/" + file, ignored);
  };
  if (!is_there(folder + "/."))
    throw InputError(InputPlace{folder}, "there is no such folder; give the folder of an earlier run");
  if (const auto kind = recorded_kind(folder)) return *kind;
  if (const auto kind = journal_kind(folder)) return *kind;
  if (has("pareto.csv")) return RunKind::kPareto;
  if (has("samples.csv")) return RunKind::kRobustness;
  if (has("comparison.csv")) return RunKind::kCompare;
  if (has("evaluations.csv")) return RunKind::kTune;
  if (has("errors.csv")) return RunKind::kSimulate;
  if (has("motion.csv")) return RunKind::kPlan;
  if (has("residuals.csv") || has("horizons.csv")) return RunKind::kValidate;
  if (has("parameters.csv") || has("held_out.csv")) return RunKind::kCalibrate;
  throw InputError(
      InputPlace{folder},
      "contains none of errors.csv, evaluations.csv, pareto.csv, samples.csv, comparison.csv, "
      "motion.csv, residuals.csv, horizons.csv, parameters.csv and held_out.csv; give the folder "
      "of a run of simulate, tune, pareto, robustness, compare, plan, validate or calibrate");
}

}  // namespace armtune::internal::report
