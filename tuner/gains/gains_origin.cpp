#include "tuner/gains/gains_origin.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <filesystem>

#include "core/common/file_path.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/metrics/metric.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/run/run_record.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

using Rows = std::vector<std::pair<std::string, std::string>>;

bool has(const fs::path& file) {
  std::error_code ignored;
  return fs::exists(file, ignored);
}

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() || unit == "1" ? fmt::format("{:.4g}", value) : fmt::format("{:.4g} {}", value, unit);
}

/// Returns the worst value over all scenarios, such as "0.8480 in target_switch, wrist_1_joint".
std::string worst_of(const CsvTable& errors, Metric metric) {
  const auto column = errors.find(name(metric));
  if (!column) return {};
  const double sign = larger_is_better(metric) ? -1.0 : 1.0;
  std::size_t worst = errors.rows();
  for (std::size_t row = 0; row < errors.rows(); ++row) {
    const double value = errors.number(row, *column);
    if (std::isnan(value)) continue;
    if (worst == errors.rows() || sign * value > sign * errors.number(worst, *column)) worst = row;
  }
  if (worst == errors.rows()) return {};
  const auto joint = errors.find(fmt::format("{}_joint", name(metric)));
  return fmt::format("{} in {}{}", with_unit(errors.number(worst, *column), field(metric).unit),
                     errors.text(worst, errors.column("scenario")),
                     joint ? ", " + errors.text(worst, *joint) : "");
}

void add_limits(const std::string& folder, Rows& rows) {
  const auto file = find_run_file(folder, "errors.csv");
  if (!file) {
    rows.emplace_back("limits", "unknown, because the run has no errors.csv");
    return;
  }
  const CsvTable errors = CsvTable::read(*file);
  for (const Metric metric :
       {Metric::kJointVelocityMaxRatio, Metric::kJointEffortMaxRatio, Metric::kJointPositionMinMargin}) {
    const std::string words = worst_of(errors, metric);
    if (!words.empty()) rows.emplace_back(name(metric), words);
  }
}

void add_checks(const std::string& folder, Rows& rows) {
  if (!find_run_file(folder, "verdict.yaml")) {
    rows.emplace_back("simulation checks", "not made");
    return;
  }
  const std::string failed = failed_checks(folder);
  rows.emplace_back("simulation checks", failed.empty() ? "passed" : "failed: " + failed);
}

/// Adds the stability margin of each kind that every scenario has, from the rows for all scenarios.
void add_margins(const std::string& folder, Rows& rows) {
  const auto file = find_run_file(folder, "margins.csv");
  if (!file) return;
  const CsvTable table = CsvTable::read(*file);
  for (std::size_t row = 0; row < table.rows(); ++row) {
    const auto text = [&](const char* column) { return table.text(row, table.column(column)); };
    const auto number = [&](const char* column) { return table.number(row, table.column(column)); };
    if (text("scenario") != kAllScenarios) continue;
    const double stands = number("stands");
    std::string words = "none";
    if (!std::isnan(stands)) {
      const char* bound = !std::isnan(number("fails")) ? "" : stands < number("nominal") ? "<= " : ">= ";
      words = bound + with_unit(stands, text("unit"));
    }
    if (!text("reason").empty()) words += "; limited by " + text("reason");
    rows.emplace_back("margin/" + text("margin"), words);
  }
}

/// Returns the hash that gains.yaml had when the run wrote it; empty if the record does not tell it.
std::string hash_of_gains(const RunRecord& run) {
  if (run.tuned) return run.tuned->gains_hash;
  return run.simulation ? run.simulation->gains_hash : std::string();
}

/// Adds how the gains were found. with_figures: true adds what the search found about them.
void add_run(const RunRecord& run, bool with_figures, Rows& rows) {
  rows.emplace_back("command", run.command);
  rows.emplace_back("seed", fmt::format("{}", run.seed));
  rows.emplace_back("date", run.date);
  if (run.search) {
    rows.emplace_back("study", run.search->study);
    rows.emplace_back("start gains", run.search->start);
    rows.emplace_back("evaluations", fmt::format("{}", run.search->evaluations));
    rows.emplace_back("engine of the search", name(run.search->engine));
  }
  if (run.tuned && with_figures) {
    if (run.tuned->objective) rows.emplace_back("objective", fmt::format("{}", *run.tuned->objective));
    rows.emplace_back("feasible", run.tuned->feasible ? "true" : "false");
  }
  if (run.simulation) rows.emplace_back("engine", name(run.simulation->engine));
  rows.emplace_back("version", armtune_version(run));
  rows.emplace_back("arithmetic", run.arithmetic.fingerprint);
  std::erase_if(rows, [](const auto& row) { return row.second.empty(); });
}

std::pair<std::string, std::string> input_row(const std::string& path, const std::string& hash) {
  return {"input " + path, hash};
}

}  // namespace

std::string failed_checks(const std::string& folder) {
  const auto file = find_run_file(folder, "verdict.yaml");
  if (!file) return {};
  std::vector<const char*> failed;
  for (const Check& check : read_verdict(*file).checks) {
    if (!check.passed) failed.push_back(name(check.kind));
  }
  return fmt::format("{}", fmt::join(failed, ", "));
}

std::string run_above(const std::string& path) {
  constexpr int kLevels = 3;
  fs::path folder = absolute_path(path);
  for (int level = 0; level < kLevels; ++level, folder = folder.parent_path()) {
    if (has(folder / kRunRecord) && has(folder / "study.yaml")) return folder.string();
  }
  return {};
}

Rows origin_of_run(const std::string& folder, bool with_figures) {
  Rows rows;
  const auto run = find_run_record(folder);
  const auto gains = find_run_file(folder, "gains.yaml");
  const std::string hash = gains ? hash_of_input(*gains) : std::string();
  const std::string written = run ? hash_of_gains(*run) : std::string();
  const bool changed = !written.empty() && !hash.empty() && written != hash;
  const bool figures = with_figures && !changed;
  if (changed) {
    rows.emplace_back("warning",
                      "gains.yaml was changed after the run, so objective, limits and margins of the run do "
                      "not apply; simulate these gains");
  }
  if (run) add_run(*run, figures, rows);
  if (figures && run) {
    add_checks(folder, rows);
    add_limits(folder, rows);
    add_margins(folder, rows);
  }
  if (!hash.empty()) rows.emplace_back("gains file", hash);
  if (!run) return rows;
  for (const InputFact& input : run->inputs) rows.push_back(input_row(input.path, input.hash));
  return rows;
}

Rows origin_of_inputs(const std::vector<std::string>& files) {
  Rows rows;
  for (const auto& [file, hash] : hashes(files)) rows.push_back(input_row(file, hash));
  return rows;
}

Rows origin_of_files(const std::vector<std::string>& files) {
  Rows rows = origin_of_inputs(files);
  rows.insert(rows.begin(), {"version", versions().front().second});
  return rows;
}

}  // namespace armtune::internal
