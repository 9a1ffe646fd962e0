#include "tuner/search/metric_model.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "tuner/study/term_score.hpp"

namespace armtune::internal {
namespace {

constexpr int kMostChannels = 64;

/// A limit of a metric in one scenario. The excess over it is sign * (value - bound) / scale.
struct ExcessLimit {
  Metric metric = Metric::kPositionMax;
  double sign = 1.0;  ///< 1: upper limit; -1: lower limit
  double bound = 0.0;
  double scale = 1.0;
};

/// Returns the weighted sum of the largest rows.
LinearRow sum_of(const std::vector<WeightedMaximum>& parts) {
  const Eigen::VectorXd here = Eigen::VectorXd::Zero(parts.front().rows.front().gradient.size());
  LinearRow sum = {parts.front().rows.front().series, 0.0, 0.0, here};
  for (const WeightedMaximum& part : parts) {
    const LinearRow& largest = largest_row(part.rows, here);
    sum.value += part.weight * largest.value;
    sum.gradient += part.weight * largest.gradient;
  }
  return sum;
}

class MetricModeller {
 public:
  MetricModeller(const Study& study, const Objective& objective, const Evaluation& e,
                 const MetricDerivatives& derivatives)
      : study_(study), objective_(objective), e_(e), derivatives_(derivatives) {}

  void add_terms(MinimaxModel& model) const;
  Maximum constraint(std::size_t c, double inside) const;

 private:
  /// Returns the rows of sign times one metric of one rollout. They are samples if they model it, that is, if
  /// the metric is an extreme value on the side on which the rows are; otherwise there is one row.
  Maximum rows_of(const MetricDerivative& m, double sign, double shift) const;
  /// Returns sign times the metric in one scenario, as a weighted sum of maxima; nothing if it has no value.
  std::vector<WeightedMaximum> parts_of(Metric metric, std::size_t s, double sign) const;
  /// Returns the limits that constraint c sets in scenario s.
  std::vector<ExcessLimit> limits_of(std::size_t c, std::size_t s) const;

  const Study& study_;
  const Objective& objective_;
  const Evaluation& e_;
  const MetricDerivatives& derivatives_;
};

Maximum MetricModeller::rows_of(const MetricDerivative& m, double sign, double shift) const {
  const auto arms_of_study = static_cast<int>(study_.robust ? arms(*study_.robust) : 1);
  const auto rollout = static_cast<int>(m.use.scenario) * arms_of_study + static_cast<int>(m.arm);
  const int series =
      (rollout * static_cast<int>(kMetricCount) + static_cast<int>(m.use.metric)) * kMostChannels;
  const bool samples =
      !m.rows.empty() && m.shape == (sign > 0 ? MetricShape::kLargest : MetricShape::kSmallest);
  if (!samples) return {{series, 0.0, sign * (m.value + shift), sign * m.gradient}};
  Maximum rows;
  rows.reserve(m.rows.size());
  for (const SampleRow& row : m.rows)
    rows.push_back({series + row.channel, row.time, sign * (row.value + shift), sign * row.gradient});
  return rows;
}

std::vector<WeightedMaximum> MetricModeller::parts_of(Metric metric, std::size_t s, double sign) const {
  const double shift = e_.results[s].metrics[metric] - derivatives_.results[s].metrics[metric];
  std::vector<const MetricDerivative*> of_arms;
  std::vector<double> values;
  for (const MetricDerivative& m : derivatives_.metrics) {
    if (!(m.use == MetricUse{metric, s})) continue;
    of_arms.push_back(&m);
    values.push_back(m.value);
    if (!std::isfinite(m.value + shift) || !m.gradient.allFinite()) return {};
  }
  if (of_arms.empty()) return {};
  const bool more = larger_is_better(metric);
  const bool union_of_arms =
      of_arms.size() == 1 || (study_.robust->measure == RiskMeasure::kWorst && sign == (more ? -1.0 : 1.0));
  std::vector<WeightedMaximum> parts;
  if (union_of_arms) {
    WeightedMaximum& all = parts.emplace_back();
    for (const MetricDerivative* m : of_arms) {
      Maximum rows = rows_of(*m, sign, shift);
      std::move(rows.begin(), rows.end(), std::back_inserter(all.rows));
    }
    return parts;
  }
  const std::vector<double> weights = risk_weights(*study_.robust, more, values);
  for (std::size_t k = 0; k < of_arms.size(); ++k) {
    if (weights[k] > 0.0) parts.push_back({weights[k], rows_of(*of_arms[k], sign, shift)});
  }
  return parts;
}

void MetricModeller::add_terms(MinimaxModel& model) const {
  double weights = 0.0;
  for (const ObjectiveTerm& term : objective_.terms()) weights += term.weight;
  for (const ObjectiveTerm& term : objective_.terms()) {
    for (const std::size_t s : term.scenarios) {
      // Linear in the metric: score = constant + |slope| (sign * metric).
      const double slope =
          term_slope(term.metric, e_.results[s].metrics[term.metric], objective_.reference(term, s));
      const double weight =
          std::abs(slope) * term.weight / (weights * static_cast<double>(term.scenarios.size()));
      if (!(weight > 0.0)) continue;
      for (WeightedMaximum& part : parts_of(term.metric, s, larger_is_better(term.metric) ? -1.0 : 1.0)) {
        part.weight *= weight;
        model.terms.push_back(std::move(part));
      }
    }
  }
}

std::vector<ExcessLimit> MetricModeller::limits_of(std::size_t c, std::size_t s) const {
  const Constraint& constraint = objective_.constraints()[c];
  if (!constraint.margin) {
    const double bound = objective_.limit(c, s);
    return {{constraint.metric, constraint.upper ? 1.0 : -1.0, bound, bound != 0.0 ? std::abs(bound) : 1.0}};
  }
  // The limits by which missing_to_hold (corner.hpp) judges a corner that completed, without the saturation.
  std::vector<ExcessLimit> limits;
  if (e_.results[s].status != RolloutStatus::kCompleted) return limits;
  for (const MetricDerivative& m : derivatives_.metrics) {
    if (m.use.scenario != s) continue;
    const bool more = larger_is_better(m.use.metric);  // a distance, at least 0; otherwise a ratio, at most 1
    limits.push_back({m.use.metric, more ? -1.0 : 1.0, more ? 0.0 : 1.0, 1.0});
  }
  return limits;
}

Maximum MetricModeller::constraint(std::size_t c, double inside) const {
  Maximum all;
  for (const std::size_t s : objective_.constraints()[c].scenarios) {
    for (const ExcessLimit& limit : limits_of(c, s)) {
      std::vector<WeightedMaximum> parts = parts_of(limit.metric, s, limit.sign);
      if (parts.empty()) continue;
      // A maximum over scenarios of sums over arms has one row per scenario.
      Maximum rows = parts.size() == 1 ? std::move(parts.front().rows) : Maximum{sum_of(parts)};
      for (LinearRow& row : rows) {
        row.value = (row.value - limit.sign * limit.bound) / limit.scale + inside;
        row.gradient /= limit.scale;
        all.push_back(std::move(row));
      }
    }
  }
  return all;
}

}  // namespace

MinimaxModel metric_model(const Study& study, const Objective& objective, const Evaluation& e,
                          const MetricDerivatives& derivatives, double inside) {
  const MetricModeller modeller(study, objective, e, derivatives);
  MinimaxModel model;
  modeller.add_terms(model);
  for (std::size_t c = 0; c < objective.constraints().size(); ++c)
    model.constraints.push_back(modeller.constraint(c, inside));
  return model;
}

}  // namespace armtune::internal
