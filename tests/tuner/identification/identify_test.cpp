// Arms are found from their logs, within the stated deviations.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>

#include "sim/rollout/rollout.hpp"
#include "sim/scenario/gains_file.hpp"
#include "tests/tuner/identification/identify_rig.hpp"
#include "tuner/identification/excitation_design.hpp"
#include "tuner/identification/excitation_log.hpp"
#include "tuner/identification/identification_files.hpp"
#include "tuner/identification/theta_doubts.hpp"
#include "tuner/run/file_hash.hpp"

namespace armtune::internal {
namespace identify_test {

using test::differing_arm;
using test::Identify;
using test::kNever;
using test::prediction_error;
using test::prediction_errors;
using test::PredictionError;
using test::true_theta;

constexpr int kSeeds = 20;

TEST_F(Identify, FindsADifferingArmFromNoisyLogsWithinItsStatedDeviations) {
  int within = 0;
  int all = 0;
  double squares = 0.0;
  double worst = 0.0;
  double worst_joint = 0.0;
  for (unsigned seed = 1; seed <= kSeeds; ++seed) {
    const Scenario scenario = differing_arm(seed, 1.0);
    const Identification found = identified({log(scenario, 0.5)});
    const ParameterVector truth = true_theta(scenario);
    const PredictionError prediction = prediction_errors(arm_, unseen_, found.theta, truth);
    EXPECT_LT(prediction.all, 0.02) << seed;
    worst = std::max(worst, prediction.all);
    worst_joint = std::max(worst_joint, prediction.worst_joint);
    const Eigen::VectorXd error =
        (found.estimate.theta - found.base.map * truth).cwiseQuotient(found.estimate.deviation());
    within += static_cast<int>((error.array().abs() <= 3.0).count());
    all += static_cast<int>(error.size());
    squares += error.squaredNorm();
  }
  // A normal error lies within three deviations in 99.73 % of the cases: neither fewer nor more may.
  EXPECT_GE(within, 0.985 * all) << within << " of " << all;
  EXPECT_LE(within, 0.999 * all) << within << " of " << all;
  const double rms = std::sqrt(squares / all);
  // The last wrist moves half a newton metre, as much as the noise.
  EXPECT_LT(worst_joint, 0.05);
  RecordProperty("worst_prediction_error", fmt::format("{:.4f}, of one joint {:.4f}", worst, worst_joint));
  RecordProperty("rms_of_normalised_errors", std::to_string(rms));
  RecordProperty("within_three_deviations", std::to_string(static_cast<double>(within) / all));
  EXPECT_GT(rms, 0.93);
  EXPECT_LT(rms, 1.07);
}

TEST_F(Identify, WithoutNoiseFindsTheArmItself) {
  const Scenario scenario = differing_arm(31, 0.0);
  const Identification found = identified({log(scenario, 0.0)});
  // What is left is the torque's being held over the control period: second order in 2 ms.
  EXPECT_LT(prediction_error(arm_, unseen_, found.theta, true_theta(scenario)), 1e-4);
}

TEST_F(Identify, ManyLogsAreOneAndMoreOfThemKnowMore) {
  const Scenario scenario = differing_arm(32, 1.0);
  Scenario again = scenario;
  again.seed = 77;
  const std::string first = log(scenario, 0.5, "a.csv");
  const std::string second = log(again, 0.5, "b.csv");
  const Identification one = identified({first});
  const Identification both = identified({first, second});
  const Identification turned = identified({second, first});
  EXPECT_LT((both.estimate.theta - turned.estimate.theta).norm(), 1e-9 * both.estimate.theta.norm());
  EXPECT_NEAR((both.estimate.deviation().cwiseQuotient(one.estimate.deviation())).mean(), std::sqrt(0.5),
              0.1);
  EXPECT_EQ(both.samples, 2 * one.samples);
}

TEST_F(Identify, RobustRegressionShrugsOffOutliers) {
  const Scenario scenario = differing_arm(33, 1.0);
  ExcitationLogOptions options;
  options.torque_noise = 0.5;
  ExcitationLog disturbed = simulate_excitation(scenario, exciting_, options, kNever);
  // Someone leans on the arm: 0.4 s in every 4 s.
  for (LogSample& sample : disturbed.samples) {
    if (std::fmod(sample.time, 4.0) < 0.4) sample.torque.array() += 15.0;
  }
  const std::string path = folder_.write("log.csv", log_csv(arm_, disturbed));
  IdentifyOptions robust;
  robust.robust = true;
  const ParameterVector truth = true_theta(scenario);
  const double plain_error = prediction_error(arm_, unseen_, identified({path}).theta, truth);
  const double robust_error = prediction_error(arm_, unseen_, identified({path}, robust).theta, truth);
  EXPECT_LT(robust_error, 0.5 * plain_error);
}

TEST_F(Identify, ATorqueThatActsLaterIsTakenBack) {
  Scenario scenario = differing_arm(34, 0.0);
  ExcitationLog shifted = simulate_excitation(scenario, exciting_, {}, kNever);
  // The log's torque of each instant acts 4 ms (two samples) later.
  for (std::size_t k = 0; k + 2 < shifted.samples.size(); ++k)
    shifted.samples[k].torque = shifted.samples[k + 2].torque;
  shifted.samples.resize(shifted.samples.size() - 2);
  const std::string path = folder_.write("log.csv", log_csv(arm_, shifted));
  const ParameterVector truth = true_theta(scenario);
  IdentifyOptions aware;
  aware.rows.torque_delay = 0.004;
  EXPECT_LT(prediction_error(arm_, unseen_, identified({path}, aware).theta, truth), 2e-4);
  EXPECT_GT(prediction_error(arm_, unseen_, identified({path}).theta, truth), 1e-3);
}

TEST_F(Identify, TheClosedLoopStartsFiveTimesMoreAccuratelyFromItThanFromNothing) {
  Scenario scenario = differing_arm(35, 1.0);
  const std::string theta =
      folder_.write("theta.yaml", theta_yaml(arm_, identified({log(scenario, 0.5)}).theta, {"found"}));
  scenario.duration = 18.0;  // the first lap
  const auto rms = [&] {
    const RolloutResult result =
        Rollout(scenario, Stepper::kMidpoint).run(load_gains("extended", joint_names(arm_)));
    EXPECT_EQ(result.status, RolloutStatus::kCompleted) << result.reason;
    return result.metrics[Metric::kPositionRms];
  };
  const double from_nothing = rms();
  start_theta_from(theta, scenario);
  const double from_identification = rms();
  RecordProperty("factor", std::to_string(from_nothing / from_identification));
  EXPECT_GT(from_nothing, 5.0 * from_identification);
}

TEST_F(Identify, WhatThetaLeavesUnexplainedIsMeasuredOnRowsThatItWasNotFittedTo) {
  const Scenario scenario = differing_arm(38, 1.0);
  const std::string path = log(scenario, 0.5);
  const Identification found = identified({path});
  IdentifyOptions everything;
  everything.hold_out = false;
  const Identification all = identified({path}, everything);
  EXPECT_NEAR(static_cast<double>(found.held_out.rows), 0.2 * static_cast<double>(all.fitted.rows),
              0.05 * static_cast<double>(all.fitted.rows));
  EXPECT_EQ(found.fitted.rows + found.held_out.rows, all.fitted.rows);
  EXPECT_EQ(all.held_out.rows, 0);
  for (int j = 0; j < arm_.n(); ++j) {
    // The noise of the torque sensor, 0.5 N m, passes the filters to some 5 %; the robot file lacks all
    // friction.
    EXPECT_LT(found.held_out.by_theta[j], 0.15) << j;
    EXPECT_GT(found.held_out.by_theta[j], 0.8 * found.fitted.by_theta[j]) << j;
    EXPECT_GT(found.held_out.by_file[j], 3.0 * found.held_out.by_theta[j]) << j;
  }
}

TEST_F(Identify, TheResidualsAreThoseOfTheThetaThatIsWritten) {
  const std::string path = log(differing_arm(40, 1.0), 0.5);
  IdentifyOptions everything;
  everything.hold_out = false;
  const Identification found = identified({path}, everything);
  EXPECT_TRUE(found.comparison.most_joints_move);
  ASSERT_TRUE(found.made_physical) << "the estimate itself would be written";

  const LogColumns columns = default_log_columns(arm_);
  LogFile again(path, columns);
  LogInstants unused;
  RowStream stream(arm_, found.base, again, everything.rows, unused);
  const Eigen::VectorXd written = found.base.map * found.theta;
  JointVector squares = JointVector::Zero(arm_.n());
  JointVector of_estimate = squares;
  Eigen::MatrixXd rows;
  long count = 0;
  for (; stream.next(rows); ++count) {
    const Eigen::MatrixXd Y = rows.leftCols(found.base.rank());
    squares += (rows.rightCols<1>() - Y * written).cwiseAbs2();
    of_estimate += (rows.rightCols<1>() - Y * found.estimate.theta).cwiseAbs2();
  }
  const JointVector left = (squares / static_cast<double>(count)).cwiseSqrt();
  EXPECT_LT((left - found.fitted.by_theta).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_GT(((of_estimate / static_cast<double>(count)).cwiseSqrt() - left).cwiseAbs().maxCoeff(), 1e-4)
      << "the estimate's own residuals can be told from these";
}

TEST_F(Identify, WhatOneMovingJointDoesNotExciteKeepsItsPriorAndIsListed) {
  // The other joints stand perfectly still, as encoders show it.
  const ParameterVector truth = true_theta(differing_arm(39, 1.0));
  const std::string path = folder_.write("alone.csv", log_csv(arm_, log_of_some_joints({1}, truth, 0.0)));
  const Identification found = identified({path});
  const ParameterVector file = theta_of(arm_.chain);
  EXPECT_GT(found.estimate.not_excited.size(), 20U);
  EXPECT_FALSE(found.comparison.mistake.has_value()) << to_text(*found.comparison.mistake, arm_);
  EXPECT_FALSE(found.comparison.most_joints_move);
  // Friction of joints that stood still cannot be known; that of the joint that moved is.
  for (int j = 0; j < arm_.n(); ++j) {
    const Eigen::Index friction = joint_parameter_index(arm_.n(), j) + 1;
    if (j == 1) {
      EXPECT_NEAR(found.theta[friction], truth[friction], 0.2);
    } else {
      EXPECT_NEAR(found.theta[friction], file[friction], 1e-3);
    }
  }
  // Near the prior in the table as well, and listed: every group that only still joints feel.
  const Eigen::VectorXd prior = found.base.map * file;
  const Eigen::VectorXd size = group_sizes(found.base, parameter_sizes(arm_));
  for (int b = 0; b < found.base.rank(); ++b) {
    const bool listed =
        std::count(found.estimate.not_excited.begin(), found.estimate.not_excited.end(), b) > 0;
    EXPECT_EQ(std::isinf(found.estimate.deviation()[b]), listed);
    if (listed) {
      EXPECT_LT(std::abs(found.estimate.theta[b] - prior[b]), 10.0 * size[b])
          << found.base.names[static_cast<std::size_t>(b)];
    }
    const bool of_still_joint = found.base.names[static_cast<std::size_t>(b)].find("wrist_3_joint") == 0;
    if (of_still_joint) {
      EXPECT_TRUE(listed) << found.base.names[static_cast<std::size_t>(b)];
    }
  }
}

}  // namespace identify_test
}  // namespace armtune::internal
