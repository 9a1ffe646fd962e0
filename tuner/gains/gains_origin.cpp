#include "tuner/gains/gains_origin.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/common/file_path.hpp"
#include "sim/csv/csv_table.hpp"
#include "sim/metrics/metric.hpp"
#include "tuner/report/provenance.hpp"
#include "tuner/run/file_hash.hpp"
#include "tuner/run/run_file.hpp"
#include "tuner/run/run_folder.hpp"
#include "tuner/verdict/verdict.hpp"

namespace armtune::internal {
namespace {

namespace fs = std::filesystem;

using Rows = std::vector<std::pair<std::string, std::string>>;

/// Keys of run.yaml, and the names that they have here.
constexpr std::pair<const char*, const char*> kOfRun[] = {{"command", "command"},
                                                          {"study", "study"},
                                                          {"seed", "seed"},
                                                          {"date", "date"},
                                                          {"start", "start gains"},
                                                          {"evaluations", "evaluations"},
                                                          {"objective", "objective"},
                                                          {"feasible", "feasible"},
                                                          {"engine", "engine"},
                                                          {"versions/armtune", "version"},
                                                          {"arithmetic/fingerprint", "arithmetic"}};

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
    if (has(folder / "run.yaml") && has(folder / "study.yaml")) return folder.string();
  }
  return {};
}

Rows origin_of_run(const std::string& folder, bool with_figures) {
  Rows rows;
  const auto run = find_run_file(folder, "run.yaml");
  const Rows all = run ? report::read_provenance(*run) : Rows{};
  const auto gains = find_run_file(folder, "gains.yaml");
  const std::string hash = gains ? hash_of_input(*gains) : std::string();
  const auto is_changed = [&hash](const auto& entry) {
    return entry.first == "gains_file" && !hash.empty() && entry.second != hash;
  };
  const bool changed = std::any_of(all.begin(), all.end(), is_changed);
  const bool figures = with_figures && !changed;
  if (changed) {
    rows.emplace_back("warning",
                      "gains.yaml was changed after the run, so objective, limits and margins of the run do "
                      "not apply; simulate these gains");
  }
  for (const auto& [key, what] : kOfRun) {
    const bool of_best = std::string_view(key) == "objective" || std::string_view(key) == "feasible";
    for (const auto& [name, value] : all) {
      if (name == key && (figures || !of_best)) rows.emplace_back(what, value);
    }
  }
  if (figures && !all.empty()) {
    add_checks(folder, rows);
    add_limits(folder, rows);
    add_margins(folder, rows);
  }
  if (!hash.empty()) rows.emplace_back("gains file", hash);
  constexpr std::string_view kInput = "inputs/";
  for (const auto& [name, value] : all) {
    if (name.starts_with(kInput)) rows.emplace_back("input " + name.substr(kInput.size()), value);
  }
  return rows;
}

Rows origin_of_files(const std::vector<std::string>& files) {
  Rows rows = {{"version", versions().front().second}};
  for (const auto& [file, hash] : hashes(files)) rows.emplace_back("input " + file, hash);
  return rows;
}

}  // namespace armtune::internal
