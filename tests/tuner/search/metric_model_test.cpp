// The model of a study agrees with the objective itself. The metrics are made up: maxima of linear functions.

#include "tuner/search/metric_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "tests/sim/support/rollouts.hpp"
#include "tests/tuner/study/two_scenarios.hpp"

namespace armtune::internal {
namespace metric_model_test {

using Eigen::VectorXd;

constexpr double kInsideOfTest = 0.01;

/// A metric of one rollout whose samples are linear in the gains.
struct LinearMetric {
  MetricUse use;
  std::size_t arm = 0;
  MetricShape shape = MetricShape::kLargest;
  std::vector<double> values;  ///< in the native engine; the first is the extreme one
  std::vector<VectorXd> gradients;

  double at(const VectorXd& d) const {
    double extreme = values[0] + gradients[0].dot(d);
    for (std::size_t i = 1; i < values.size(); ++i) {
      const double sample = values[i] + gradients[i].dot(d);
      extreme = shape == MetricShape::kLargest ? std::max(extreme, sample) : std::min(extreme, sample);
    }
    return extreme;
  }
  MetricDerivative derivative() const {
    MetricDerivative m;
    m.use = use;
    m.arm = arm;
    m.shape = shape;
    m.value = values[0];
    m.gradient = gradients[0];
    for (std::size_t i = 0; i < values.size() && shape != MetricShape::kRms; ++i) {
      SampleRow& row = m.rows.emplace_back();
      row.time = 0.5 * static_cast<double>(i);
      row.value = values[i];
      row.gradient = gradients[i];
    }
    return m;
  }
};

class MetricModel : public test::ObjectiveOfTwoScenarios {
 protected:
  MetricModel() { std::srand(2); }

  /// Adds a metric with these samples, whose gradients are random and of the size of the first value.
  void add(Metric metric, std::size_t s, std::vector<double> values,
           MetricShape shape = MetricShape::kLargest, std::size_t arm = 0) {
    LinearMetric& m = metrics_.emplace_back(LinearMetric{{metric, s}, arm, shape, std::move(values), {}});
    for (std::size_t i = 0; i < m.values.size(); ++i)
      m.gradients.emplace_back(m.values[0] * VectorXd::Random(3));
  }
  void add_those_of_the_study() {
    add(Metric::kPositionMax, 0, {0.0015, 0.0014, 0.0012});
    add(Metric::kPositionMax, 1, {0.003, 0.0028});
    add(Metric::kOrientationMax, 1, {0.03, 0.029, 0.02});
    add(Metric::kJointVelocityMaxRatio, 0, {0.85, 0.84});
    add(Metric::kJointVelocityMaxRatio, 1, {0.88, 0.8});
    add(Metric::kObstacleMinClearance, 1, {0.21, 0.22, 0.3}, MetricShape::kSmallest);
  }

  /// Results at the step d. The engine of the search has values that are larger by `shift`, relative.
  std::vector<RolloutResult> results(const VectorXd& d, double shift) const {
    std::vector<RolloutResult> all(scenarios_.size());
    for (std::size_t s = 0; s < all.size(); ++s) {
      all[s].end_time = scenarios_[s].duration;
      all[s].metrics[Metric::kJointEffortSaturatedPeriods] = 0.0;
      for (const LinearMetric& m : metrics_) {
        if (m.use.scenario != s) continue;
        std::vector<double> of_arms;
        for (const LinearMetric& other : metrics_) {
          if (other.use == m.use) of_arms.push_back(other.at(d));
        }
        const double value = of_arms.size() == 1
                                 ? of_arms[0]
                                 : measured(*study_.robust, larger_is_better(m.use.metric), of_arms);
        all[s].metrics[m.use.metric] = value + shift * std::abs(m.values[0]);
      }
    }
    return all;
  }
  Evaluation judged_at(const VectorXd& d) const { return judged(results(d, 0.02)); }

  MinimaxModel model() const {
    MetricDerivatives derivatives;
    for (const LinearMetric& m : metrics_) derivatives.metrics.push_back(m.derivative());
    derivatives.results = results(VectorXd::Zero(3), 0.0);
    return metric_model(study_, objective(), judged_at(VectorXd::Zero(3)), derivatives, kInsideOfTest);
  }

  /// Expects the model to be what the objective says at random steps of this size.
  void expect_exact(double size, double tolerance) const {
    const MinimaxModel model = this->model();
    const VectorXd here = VectorXd::Zero(3);
    const Evaluation at = judged_at(here);
    ASSERT_EQ(model.constraints.size(), constraints_.size());
    for (int k = 0; k < 50; ++k) {
      const VectorXd d = size * VectorXd::Random(3);
      const Evaluation there = judged_at(d);
      EXPECT_NEAR(objective_at(model, d) - objective_at(model, here), there.objective - at.objective,
                  tolerance);
      for (std::size_t c = 0; c < constraints_.size(); ++c) {
        const LinearRow& largest = largest_row(model.constraints[c], d);
        EXPECT_NEAR(largest.value + largest.gradient.dot(d), there.relative[c] + kInsideOfTest, tolerance)
            << c;
      }
    }
  }

  Study study_;
  std::vector<LinearMetric> metrics_;
};

TEST_F(MetricModel, IsTheObjectiveItselfWhereMetricsAreMaximaOfLinearFunctions) {
  add_those_of_the_study();
  expect_exact(0.5, 1e-12);
}

TEST_F(MetricModel, AnRmsValueIsItsGradient) {
  terms_.push_back({Metric::kGazeRms, 2.0, 0.001, {0}});
  add_those_of_the_study();
  add(Metric::kGazeRms, 0, {0.002}, MetricShape::kRms);
  expect_exact(0.5, 1e-12);
}

TEST_F(MetricModel, OfAMetricThatMustGrowIsRightToFirstOrder) {
  start_[1].metrics[Metric::kObstacleMinClearance] = 0.3;
  terms_.push_back({Metric::kObstacleMinClearance, 2.0, 0.0, {1}});
  add_those_of_the_study();
  expect_exact(1e-4, 1e-6);
}

TEST_F(MetricModel, ALimitOnTheOtherSideOfAnExtremeValueIsItsGradient) {
  constraints_ = {{Metric::kPositionMax, false, 0.001, {0}}, {Metric::kObstacleMinClearance, true, 0.5, {1}}};
  add_those_of_the_study();
  expect_exact(1e-5, 1e-12);
  for (const Maximum& rows : model().constraints) EXPECT_EQ(rows.size(), 1U);
}

TEST_F(MetricModel, ACandidateThatDoesNotCompleteHasNoRowsWhereItHasNoValues) {
  add_those_of_the_study();
  metrics_[0].values[0] = NAN;
  EXPECT_EQ(model().terms.size(), 2U) << "three maxima without one";
  EXPECT_FALSE(model().constraints[0].empty());
}

class MetricModelOfArms : public MetricModel, public testing::WithParamInterface<RiskMeasure> {};

TEST_P(MetricModelOfArms, CombinesTheArmsAsTheStudyDoes) {
  study_.robust.emplace();
  study_.robust->samples = 2;
  study_.robust->measure = GetParam();
  study_.robust->level = 0.5;
  for (std::size_t arm = 0; arm < 3; ++arm) {
    const double more = 0.1 * static_cast<double>((arm + 1) % 3);
    add(Metric::kPositionMax, 0, {0.0015 + 0.001 * more, 0.0014}, MetricShape::kLargest, arm);
    add(Metric::kPositionMax, 1, {0.003 + 0.001 * more, 0.0028}, MetricShape::kLargest, arm);
    add(Metric::kOrientationMax, 1, {0.03 + 0.01 * more, 0.029}, MetricShape::kLargest, arm);
    add(Metric::kJointVelocityMaxRatio, 0, {0.8 + 0.1 * more, 0.79}, MetricShape::kLargest, arm);
    add(Metric::kJointVelocityMaxRatio, 1, {0.85 + 0.1 * more, 0.8}, MetricShape::kLargest, arm);
    add(Metric::kObstacleMinClearance, 1, {0.21 + 0.1 * more, 0.5}, MetricShape::kSmallest, arm);
  }
  // The order of the arms, on which all measures but the worst value depend, stays the same for small steps.
  const bool worst = GetParam() == RiskMeasure::kWorst;
  expect_exact(worst ? 0.5 : 1e-3, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Measures, MetricModelOfArms,
                         testing::Values(RiskMeasure::kWorst, RiskMeasure::kMean, RiskMeasure::kQuantile,
                                         RiskMeasure::kConditionalValueAtRisk),
                         [](const auto& measure) {
                           return std::string(risk_measure_names()[static_cast<std::size_t>(measure.param)]);
                         });

TEST_F(MetricModel, AStabilityMarginIsTheWorstLimitOfItsCorner) {
  const Scenario own = test::scenario_of("moving_target");
  const MarginDemand demand{MarginKind::kTorqueDelay, 2.0};
  scenarios_ = {own, own, corner_of(own, demand)};
  start_[1].metrics[Metric::kObstacleMinClearance] = NAN;
  start_.push_back(start_[0]);
  constraints_ = {{Metric::kJointVelocityMaxRatio, true, 0.9, {0, 1}}};
  Constraint margin;
  margin.scenarios = {2};
  margin.margin = demand;
  constraints_.push_back(margin);
  add_those_of_the_study();
  metrics_.pop_back();
  add(Metric::kJointVelocityMaxRatio, 2, {0.95, 0.94, 0.9});
  add(Metric::kJointPositionMinMargin, 2, {0.06, 0.07}, MetricShape::kSmallest);
  expect_exact(0.05, 1e-12);
}

}  // namespace metric_model_test
}  // namespace armtune::internal
