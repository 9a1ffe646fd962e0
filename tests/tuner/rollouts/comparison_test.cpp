#include "tuner/rollouts/comparison.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/sim/support/read_back.hpp"

namespace armtune::internal {
namespace comparison_test {

/// Every awkward number and every figure that there is not, each in another scenario, metric and set.
double figure(std::size_t set, std::size_t scenario, std::size_t metric) {
  const std::size_t i = 5 * set + 3 * scenario + metric;
  return i % 3 == 2 ? test::no_figures()[(i / 3) % test::no_figures().size()] : test::awkward(i);
}

std::vector<ComparedSet> awkward_sets() {
  std::vector<ComparedSet> sets;
  for (const std::string& name : {std::string("published"), test::kAwkwardText, test::kFormula}) {
    ComparedSet& set = sets.emplace_back();
    set.name = name;
    for (const std::string& scenario : {test::kAwkwardText, test::kFormula, std::string("plain")}) {
      ScenarioResult& added = set.results.emplace_back();
      added.scenario = scenario;
      for (std::size_t m = 0; m < kMetricCount; ++m) {
        added.result.metrics.value[m] = figure(sets.size() - 1, set.results.size() - 1, m);
      }
    }
  }
  return sets;
}

/// A name as the header has it.
std::string column(const std::string& name) {
  return is_formula(name) ? "'" + name : name;
}

TEST(ComparisonCsv, ReadsBackToTheBitAndIsEmptyWhereThereIsNoFigure) {
  const std::vector<ComparedSet> sets = awkward_sets();
  test::ReadBack read(comparison_csv(sets));
  std::size_t row = 0, ratios = 0;
  for (std::size_t s = 0; s < sets.front().results.size(); ++s) {
    for (std::size_t m = 0; m < kMetricCount; ++m, ++row) {
      const MetricField& field = metric_fields()[m];
      read.text(row, "scenario", sets.front().results[s].scenario);
      read.text(row, "metric", field.name);
      read.text(row, "unit", field.unit);
      const double first = sets.front().results[s].result.metrics.value[m];
      for (std::size_t i = 0; i < sets.size(); ++i) {
        const double value = sets[i].results[s].result.metrics.value[m];
        read.number(row, column(sets[i].name), value);
        if (i == 0) continue;
        // Between two figures of one sign, of which the first is not zero.
        const bool says_something =
            std::isfinite(first) && std::isfinite(value) && first > 0.0 && value >= 0.0;
        read.number(row, column(sets[i].name + "/ratio"), says_something ? value / first : NAN);
        ratios += says_something ? 1 : 0;
      }
    }
  }
  read.expect_all_seen(row);
  EXPECT_GT(ratios, kMetricCount / 2);
}

TEST(ComparisonCsv, ARatioToWhatIsNoFigureIsNone) {
  for (const double none : test::no_figures()) {
    std::vector<ComparedSet> sets(2);
    for (ComparedSet& set : sets) {
      set.name = &set == &sets.front() ? "first" : "second";
      ScenarioResult& added = set.results.emplace_back();
      added.scenario = "s";
      added.result.metrics.value.fill(&set == &sets.front() ? none : 1.0);
    }
    test::ReadBack read(comparison_csv(sets));
    for (std::size_t row = 0; row < kMetricCount; ++row) {
      read.text(row, "first", "");
      read.number(row, "second", 1.0);
      read.text(row, "second/ratio", "");
    }
  }
}

}  // namespace comparison_test
}  // namespace armtune::internal
