#include "tuner/report/tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "tuner/rollouts/comparison.hpp"

namespace armtune::internal::report {
namespace {

/// Returns the first row of each scenario in errors.csv; empty without a file.
std::map<std::string, std::size_t> rows_of(const std::optional<CsvTable>& errors) {
  std::map<std::string, std::size_t> rows;
  if (!errors) return rows;
  const std::size_t names = errors->column("scenario");
  for (std::size_t r = 0; r < errors->rows(); ++r) rows.emplace(errors->text(r, names), r);
  return rows;
}

std::vector<std::string> scenarios_in(const std::vector<std::optional<CsvTable>>& errors) {
  std::vector<std::string> names;
  std::set<std::string> known;
  for (const auto& file : errors) {
    if (!file) continue;
    const std::size_t column = file->column("scenario");
    for (std::size_t r = 0; r < file->rows(); ++r) {
      std::string name = file->text(r, column);
      if (known.insert(name).second) names.push_back(std::move(name));
    }
  }
  return names;
}

Place place_of_ratio(const CsvTable& errors, std::size_t row) {
  const std::string joint = errors.text(row, errors.column("joint_velocity/max_ratio_joint"));
  const double time = errors.number(row, errors.column(name(Metric::kJointVelocityMaxRatioTime)));
  return {joint, joint.empty() || std::isnan(time) ? "" : fmt::format(" at {:.2f} s", time)};
}

/// Returns all metrics, the headline metrics first.
std::vector<Metric> ordered_metrics() {
  std::vector<Metric> metrics = headline_metrics();
  for (const Metric metric : all_metrics()) {
    if (std::find(metrics.begin(), metrics.end(), metric) == metrics.end()) metrics.push_back(metric);
  }
  return metrics;
}

Table table_of(const std::vector<std::optional<CsvTable>>& errors,
               const std::vector<std::map<std::string, std::size_t>>& rows_by_name,
               const std::string& scenario) {
  Table table;
  table.scenario = scenario;
  std::vector<std::optional<std::size_t>> rows;
  rows.reserve(errors.size());
  for (std::size_t set = 0; set < errors.size(); ++set) {
    const auto& file = errors[set];
    const auto found = rows_by_name[set].find(scenario);
    rows.push_back(found == rows_by_name[set].end() ? std::nullopt : std::optional(found->second));
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
        row.places.push_back(rows[set] ? place_of_ratio(*errors[set], *rows[set]) : Place());
        row.text.push_back(row.places.back().joint + row.places.back().when);
      }
    }
    if (any) table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

std::vector<Table> tables_of(const std::vector<std::optional<CsvTable>>& errors) {
  std::vector<Table> tables;
  std::vector<std::map<std::string, std::size_t>> rows;
  rows.reserve(errors.size());
  for (const auto& file : errors) rows.push_back(rows_of(file));
  for (const std::string& scenario : scenarios_in(errors)) tables.push_back(table_of(errors, rows, scenario));
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

}  // namespace armtune::internal::report
