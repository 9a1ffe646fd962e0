#include "sim/rollout/error_report.hpp"

#include <fmt/format.h>

#include "sim/csv/cell.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kJointColumn = "joint_velocity/max_ratio_joint";

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

}  // namespace

std::string errors_csv(const std::vector<ScenarioResult>& results,
                       const std::vector<FurtherColumn>& further) {
  const auto& fields = metric_fields();
  const auto ratio = static_cast<std::size_t>(Metric::kJointVelocityMaxRatio);
  std::string text;
  for (const Column& column : error_columns(further)) text += (text.empty() ? "" : ",") + cell(column.name);
  text += '\n';
  for (std::size_t r = 0; r < results.size(); ++r) {
    const ScenarioResult& row = results[r];
    text += fmt::format("{},{}", cell(row.scenario), name(row.result.status));
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const double value = row.result.metrics.value[i];
      text += ',' + cell(value);
      if (i == ratio) text += ',' + cell(row.result.metrics.max_ratio_joint);
    }
    for (const FurtherColumn& f : further) text += ',' + cell(f.values[r]);
    text += ',' + cell(row.result.reason) + '\n';
  }
  return text;
}

std::vector<Column> error_columns(const std::vector<FurtherColumn>& further) {
  std::vector<Column> columns = {{"scenario", "", "name of the scenario", {}},
                                 {"status", "", "completed, diverged, no_samples or interrupted", {}}};
  for (const Metric m : all_metrics()) {
    columns.push_back({name(m), field(m).unit, field(m).meaning, {}});
    if (m == Metric::kJointVelocityMaxRatio)
      columns.push_back({kJointColumn, "", "joint that reached joint_velocity/max_ratio", {}});
  }
  for (const FurtherColumn& f : further) columns.push_back(f.column);
  columns.push_back(
      {"reason", "", "when, in which state and why the rollout ended, if it did not complete", {}});
  return columns;
}

std::string columns_csv(const std::vector<FileColumns>& files) {
  std::string text = "file,name,unit,meaning\n";
  for (const FileColumns& f : files) {
    for (const Column& c : f.columns) {
      text += fmt::format("{},{},{},{}\n", cell(f.file), cell(c.name), cell(c.unit), quoted(c.meaning));
    }
  }
  return text;
}

}  // namespace armtune::internal
