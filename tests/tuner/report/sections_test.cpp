#include "tuner/report/sections.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "tests/sim/support/files.hpp"
#include "tests/sim/support/rollouts.hpp"
#include "tuner/robustness/monte_carlo.hpp"
#include "tuner/samples/statistics.hpp"

namespace armtune::internal::report {
namespace sections_test {

using testing::ElementsAre;
using testing::HasSubstr;

CsvTable evaluations() {
  return CsvTable::parse(
      "evaluation,phase,objective,feasible,violation,status,gain/a,constraint/s/joint_velocity/max_ratio,"
      "constraint/t/joint_velocity/max_ratio\n"
      "0,start,1,0,0.2,\"completed\",5,1.1,0.9\n"
      "1,sweep,0.5,1,0,\"completed\",6,0.8,0.85\n"
      "2,search,0.4,1,0,\"completed\",7,0.7,0.6\n"
      "3,search,0.3,0,9,\"diverged, at 3 s\",8,,\n"
      "4,search,0.45,1,0,\"completed\",9,0.5,0.4\n",
      "evaluations.csv");
}

TEST(EvaluationsSection, KeepsEveryEvaluationAndFindsStartAndChosen) {
  const auto chosen_with = [](double gain) {
    return evaluations_of(evaluations(), {{"gain/a", "1", 0, 10, "log", {5.0, gain}}}).chosen;
  };
  EXPECT_EQ(chosen_with(9.0), 4) << "whose gains they are, though 2 is better";
  EXPECT_EQ(chosen_with(7.000000000000001), 2) << "but for the last bit";
  EXPECT_EQ(chosen_with(77.0), 2) << "nobody's: the best feasible one";
  const Evaluations e = evaluations_of(evaluations(), {});
  EXPECT_EQ(e.chosen, 2);
  EXPECT_EQ(e.start, 0);
  EXPECT_THAT(e.phases, ElementsAre("start", "sweep", "search"));
  EXPECT_THAT(e.of, ElementsAre(0U, 1U, 2U, 2U, 2U));
  EXPECT_THAT(e.objective, ElementsAre(1, 0.5, 0.4, 0.3, 0.45));
  EXPECT_THAT(e.feasible, ElementsAre(false, true, true, false, true));
}

TEST(EvaluationsSection, ChoosesWhatSimbodyJudgedAmongTheSameGains) {
  const CsvTable table = CsvTable::parse(
      "evaluation,phase,engine,objective,feasible,violation,gain/a\n"
      "0,start,simbody,1,1,0,5\n1,start,native,1,1,0,5\n2,search,native,0.4,1,0,7\n3,verify,simbody,0.41,1,0,"
      "7\n",
      "evaluations.csv");
  const Evaluations e = evaluations_of(table, {{"gain/a", "1", 0, 10, "log", {5.0, 7.0}}});
  EXPECT_EQ(e.start, 0);
  EXPECT_EQ(e.chosen, 3) << "though the native engine's figure is smaller";
  EXPECT_THAT(e.native, ElementsAre(false, true, true, false));
  EXPECT_TRUE(evaluations_of(evaluations(), {}).native.empty());
}

TEST(FrontSection, OfASearchIsTheObjectiveAgainstTheWorstScenario) {
  const CsvTable table = evaluations();
  const std::vector<StudyLimit> limits = {{Metric::kJointVelocityMaxRatio, true, 0.9, {"s", "t"}},
                                          {Metric::kJointVelocityMaxRatio, true, 0.8, {"t"}},
                                          {Metric::kJointVelocityMaxRatio, false, 0.1, {}},
                                          {Metric::kObstacleMinClearance, false, 0.1, {}}};
  const auto front = front_of_search(table, evaluations_of(table, {}), limits);
  ASSERT_TRUE(front);
  EXPECT_THAT(front->limits, ElementsAre(CriterionLimit{1, 0.9}));
  ASSERT_EQ(front->points.size(), 4U) << "one has no figures";
  EXPECT_THAT(front->points[0].values, ElementsAre(1.0, 1.1));
  EXPECT_THAT(front->points[1].values, ElementsAre(0.5, 0.85));
  EXPECT_EQ(front->points[0].role, "start");
  EXPECT_EQ(front->points[0].label, "start") << "as the page relies on";
  EXPECT_FALSE(front->points[0].feasible);
  EXPECT_EQ(front->points[2].role, "chosen");
  const CsvTable none =
      CsvTable::parse("evaluation,phase,objective,feasible,violation\n0,start,1,1,0\n", "t");
  EXPECT_FALSE(front_of_search(none, evaluations_of(none, {}), {}));
}

TEST(FrontSection, OfALongSearchKeepsWhatNoOtherPointDominates) {
  std::string text = "evaluation,phase,objective,feasible,violation,constraint/s/joint_velocity/max_ratio\n";
  std::mt19937 random(2);
  std::uniform_real_distribution<double> draw(0.2, 1.0);
  std::vector<std::pair<double, double>> all;
  for (int i = 0; i < 1500; ++i) {
    all.emplace_back(draw(random), draw(random));
    text += std::to_string(i) + (i == 0 ? ",start," : ",search,") + std::to_string(all.back().first) +
            ",1,0," + std::to_string(all.back().second) + "\n";
  }
  const CsvTable table = CsvTable::parse(text, "t");
  const auto front = front_of_search(table, evaluations_of(table, {}), {});
  ASSERT_TRUE(front);
  EXPECT_LT(front->points.size(), 200U);
  for (const FrontPoint& point : front->points) {
    if (point.role != "point") continue;
    for (const FrontPoint& other : front->points) {
      EXPECT_FALSE(other.values[0] < point.values[0] && other.values[1] < point.values[1]);
    }
  }
  const double best = std::min_element(all.begin(), all.end())->first;
  EXPECT_TRUE(std::any_of(front->points.begin(), front->points.end(), [best](const FrontPoint& p) {
    return std::abs(p.values[0] - best) < 1e-6;  // printed with six places
  }));
}

TEST(FrontSection, OfParetoCsvHasItsPointsAndItsStart) {
  const CsvTable table = CsvTable::parse(
      "point,kind,evaluation,dominates_start,objective,gaze/"
      "rms,g\n1,front,7,1,0.3,0.02,5\n2,front,9,0,0.4,0.01,6\n"
      ",start,0,0,1,0.05,5\n",
      "pareto.csv");
  const Front front = front_of(table, {"objective", "gaze/rms"}, "2", 0.5);
  ASSERT_EQ(front.points.size(), 3U);
  EXPECT_EQ(front.criteria[1].unit, "rad");
  EXPECT_EQ(front.points[0].role, "point");
  EXPECT_EQ(front.points[1].role, "shown");
  EXPECT_EQ(front.points[2].role, "start");
  EXPECT_THAT(front.points[1].values, ElementsAre(0.4, 0.01));
  EXPECT_THAT(test::refusal([&] { front_of(table, {"no/such"}, "", std::nullopt); }), HasSubstr("no/such"));
}

class RobustnessSection : public testing::Test {
 protected:
  RobustnessSection() : scenarios_(2, test::scenario_of("moving_target")) {
    scenarios_[0].name = "a";
    scenarios_[1].name = "b";
    std::mt19937 random(4);
    std::normal_distribution<double> draw(0.8, 0.15);
    samples_.resize(300);
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      samples_[i].number = i;
      samples_[i].results.resize(2);
      samples_[i].broken.resize(2);
      for (std::size_t s = 0; s < 2; ++s) {
        RolloutResult& result = samples_[i].results[s];
        result.metrics[Metric::kJointVelocityMaxRatio] = draw(random);
        result.metrics[Metric::kJointPositionMinMargin] = 0.5;
        result.metrics.max_ratio_joint = "elbow";
        if (i % 50 == 3) result.status = RolloutStatus::kDiverged;
        samples_[i].broken[s] = broken_limit(result, arm_limits(), scenarios_[s]);
      }
    }
    section_ = robustness_of(
        CsvTable::parse(samples_csv(scenarios_, {}, samples_), "samples.csv"),
        {{Metric::kJointVelocityMaxRatio, true, 1.0}, {Metric::kJointPositionMinMargin, false, 0.0}}, {});
  }

  std::vector<Scenario> scenarios_;
  std::vector<MonteCarloSample> samples_;
  Robustness section_;
};

TEST_F(RobustnessSection, HasTheYieldOfTheSamplesThemselves) {
  const auto kept = static_cast<std::size_t>(std::count_if(
      samples_.begin(), samples_.end(), [](const MonteCarloSample& sample) { return sample.keeps_all(); }));
  ASSERT_GT(kept, 0U);
  ASSERT_LT(kept, samples_.size());
  EXPECT_EQ(section_.samples, samples_.size());
  EXPECT_EQ(section_.kept, kept);
  EXPECT_EQ(section_.interval, wilson_interval(kept, samples_.size()));
}

TEST_F(RobustnessSection, CountsEveryCompletedSampleInTheBinItFallsInto) {
  ASSERT_EQ(section_.histograms.size(), 4U) << "two metrics have values, in two scenarios";
  for (const Histogram& h : section_.histograms) {
    const std::size_t s = h.scenario == "a" ? 0 : 1;
    std::vector<double> values;
    for (const MonteCarloSample& sample : samples_) {
      if (sample.results[s].status == RolloutStatus::kCompleted)
        values.push_back(sample.results[s].metrics[h.metric]);
    }
    ASSERT_EQ(h.edges.size(), h.counts.size() + 1);
    EXPECT_EQ(h.failed, samples_.size() - values.size());
    EXPECT_TRUE(std::is_sorted(h.edges.begin(), h.edges.end()));
    EXPECT_EQ(std::accumulate(h.counts.begin(), h.counts.end(), std::size_t{0}), values.size());
    EXPECT_EQ(h.edges.front(), *std::min_element(values.begin(), values.end()));
    EXPECT_EQ(h.edges.back(), *std::max_element(values.begin(), values.end()));
    for (std::size_t b = 1; b < h.counts.size(); ++b) {
      const auto below = static_cast<std::size_t>(
          std::count_if(values.begin(), values.end(), [&](double v) { return v < h.edges[b]; }));
      EXPECT_EQ(std::accumulate(h.counts.begin(), h.counts.begin() + static_cast<std::ptrdiff_t>(b),
                                std::size_t{0}),
                below);
    }
    EXPECT_EQ(h.limit, h.metric == Metric::kJointVelocityMaxRatio ? 1.0 : 0.0);
  }
}

TEST_F(RobustnessSection, PutsTheWorstArmsAndTheLimitMostOftenBrokenFirst) {
  ASSERT_GE(section_.broken.size(), 2U);
  for (std::size_t i = 1; i < section_.broken.size(); ++i) {
    EXPECT_GE(section_.broken[i - 1].second, section_.broken[i].second);
  }
  ASSERT_FALSE(section_.worst.empty());
  const auto& first = samples_[static_cast<std::size_t>(section_.worst.front().sample)];
  double largest = 0.0;
  for (const MonteCarloSample& sample : samples_) {
    for (std::size_t s = 0; s < 2; ++s) {
      if (!sample.broken[s].text.empty()) {
        largest = std::max(largest, sample.results[s].metrics[Metric::kJointVelocityMaxRatio]);
      }
    }
  }
  EXPECT_EQ(std::max(first.results[0].metrics[Metric::kJointVelocityMaxRatio],
                     first.results[1].metrics[Metric::kJointVelocityMaxRatio]),
            largest);
}

TEST(MarginsSection, PutsTheSetsSideBySideAlsoWhereOneHasNoFile) {
  const CsvTable table = CsvTable::parse(
      "margin,unit,scenario,nominal,stands,fails,reason\ngain_factor,1,a,1,1.8,1.9,\"torque, saturated\"\n"
      "gain_factor,1,all,1,,1.9,a: x\n"
      "gain_factor,1,b,1,100,,\ncontrol_rate,Hz,b,500,10,,\n",
      "margins.csv");
  const auto rows = margins_of({std::nullopt, table});
  ASSERT_EQ(rows.size(), 4U);
  EXPECT_TRUE(std::isnan(rows[0].values[0]));
  EXPECT_EQ(rows[0].values[1], 1.8);
  EXPECT_THAT(rows[0].reason, ElementsAre("", "torque, saturated"));
  EXPECT_TRUE(std::isnan(rows[1].values[1])) << "not even the nominal value stands";
  EXPECT_THAT(rows[0].text, ElementsAre("", "1.8"));
  EXPECT_THAT(rows[1].text, ElementsAre("", "none"));
  EXPECT_THAT(rows[2].text, ElementsAre("", "≥ 100")) << "nothing failed";
  EXPECT_THAT(rows[3].text, ElementsAre("", "≤ 10"));
}

}  // namespace sections_test
}  // namespace armtune::internal::report
