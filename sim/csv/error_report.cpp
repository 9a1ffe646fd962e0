#include "sim/csv/error_report.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armtune {
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

std::string errors_csv(const std::vector<ScenarioResult>& results) {
  const auto& fields = metric_fields();
  const auto ratio = static_cast<std::size_t>(Metric::kJointVelocityMaxRatio);
  std::string text = "scenario,status";
  for (std::size_t i = 0; i < fields.size(); ++i) {
    text += fmt::format(",{}", fields[i].name);
    if (i == ratio) text += fmt::format(",{}", kJointColumn);
  }
  text += '\n';
  for (const ScenarioResult& row : results) {
    text += fmt::format("{},{}", row.scenario, name(row.result.status));
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const double value = row.result.metrics.value[i];
      text += std::isnan(value) ? "," : fmt::format(",{}", value);
      if (i == ratio) text += fmt::format(",{}", row.result.metrics.max_ratio_joint);
    }
    text += '\n';
  }
  return text;
}

std::string columns_csv(const std::vector<Column>& rollout_columns,
                        const std::vector<Column>& journal_columns) {
  std::string text = "file,name,unit,meaning\n";
  const auto add = [&text](const char* file, const std::string& name, const std::string& unit,
                           const std::string& meaning) {
    text += fmt::format("{},{},{},{}\n", file, name, unit, quoted(meaning));
  };
  add("errors.csv", "scenario", "", "name of the scenario");
  add("errors.csv", "status", "", "completed, diverged, no_samples or interrupted");
  for (const MetricField& field : metric_fields()) {
    add("errors.csv", field.name, field.unit, field.meaning);
    if (&field == &metric_fields()[static_cast<std::size_t>(Metric::kJointVelocityMaxRatio)]) {
      add("errors.csv", kJointColumn, "", "joint of that ratio");
    }
  }
  for (const Column& column : rollout_columns) {
    add("rollout_*.csv", column.name, column.unit, column.meaning);
  }
  for (const Column& column : journal_columns) {
    add("evaluations.csv", column.name, column.unit, column.meaning);
  }
  return text;
}

}  // namespace armtune
