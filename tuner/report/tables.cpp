#include "tuner/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tuner/run/comparison.hpp"

namespace armtune::report {
namespace {

/// Row of the scenario in an errors.csv.
std::optional<std::size_t> row_of(const std::optional<CsvTable>& errors, const std::string& scenario) {
  if (!errors) return std::nullopt;
  const std::size_t names = errors->column("scenario");
  for (std::size_t r = 0; r < errors->rows(); ++r) {
    if (errors->text(r, names) == scenario) return r;
  }
  return std::nullopt;
}

std::vector<std::string> scenarios_in(const std::vector<std::optional<CsvTable>>& errors) {
  std::vector<std::string> names;
  for (const auto& file : errors) {
    if (!file) continue;
    const std::size_t column = file->column("scenario");
    for (std::size_t r = 0; r < file->rows(); ++r) {
      const std::string name = file->text(r, column);
      if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
  }
  return names;
}

/// "wrist_1_joint at 6.01 s"
std::string joint_and_time(const CsvTable& errors, std::size_t row) {
  const std::string joint = errors.text(row, errors.column("joint_velocity/max_ratio_joint"));
  const double time = errors.number(row, errors.column(name(Metric::kJointVelocityMaxRatioTime)));
  return joint.empty() || std::isnan(time) ? joint : fmt::format("{} at {:.2f} s", joint, time);
}

/// Headlines first.
std::vector<Metric> ordered_metrics() {
  std::vector<Metric> metrics = headline_metrics();
  for (const Metric metric : all_metrics()) {
    if (std::find(metrics.begin(), metrics.end(), metric) == metrics.end()) metrics.push_back(metric);
  }
  return metrics;
}

Table table_of(const std::vector<std::optional<CsvTable>>& errors, const std::string& scenario) {
  Table table;
  table.scenario = scenario;
  std::vector<std::optional<std::size_t>> rows;
  rows.reserve(errors.size());
  for (const auto& file : errors) {
    rows.push_back(row_of(file, scenario));
    table.status.push_back(rows.back() ? file->text(*rows.back(), file->column("status")) : std::string());
    const auto reason = rows.back() ? file->find("reason") : std::nullopt;  // older files have none
    table.reason.push_back(reason ? file->text(*rows.back(), *reason) : std::string());
  }
  for (const Metric metric : ordered_metrics()) {
    MetricRow row;
    row.metric = metric;
    bool any = false;
    for (std::size_t set = 0; set < errors.size(); ++set) {
      const auto column = rows[set] ? errors[set]->find(name(metric)) : std::nullopt;
      row.values.push_back(column ? errors[set]->number(*rows[set], *column) : NAN);
      any = any || !std::isnan(row.values.back());
      if (metric == Metric::kJointVelocityMaxRatio) {
        row.text.push_back(rows[set] ? joint_and_time(*errors[set], *rows[set]) : std::string());
      }
    }
    if (any) table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<Table> tables_of(const std::vector<std::optional<CsvTable>>& errors) {
  std::vector<Table> tables;
  for (const std::string& scenario : scenarios_in(errors)) tables.push_back(table_of(errors, scenario));
  return tables;
}

void keep_rows(std::vector<Table>& tables, const std::vector<Metric>& wanted) {
  const auto& headline = headline_metrics();
  const auto is_in = [](const std::vector<Metric>& metrics, Metric metric) {
    return std::find(metrics.begin(), metrics.end(), metric) != metrics.end();
  };
  for (Table& table : tables) {
    std::erase_if(table.rows, [&](const MetricRow& row) {
      return !is_in(headline, row.metric) && !is_in(wanted, row.metric);
    });
  }
}

double value_of(const Table& table, Metric metric, std::size_t set) {
  for (const MetricRow& row : table.rows) {
    if (row.metric == metric && set < row.values.size()) return row.values[set];
  }
  return NAN;
}

}  // namespace armtune::report
