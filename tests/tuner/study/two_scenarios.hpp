#pragma once
// Rollouts of two scenarios without a simulation, and the objective over them.

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tests/core/support/refused_at.hpp"
#include "tuner/study/objective.hpp"

namespace armtune::internal::test {

/// A completed rollout with these values in every metric that the tests look at.
inline RolloutResult completed(double position, double orientation, double ratio, double clearance) {
  RolloutResult r;
  r.end_time = 10.0;
  r.metrics[Metric::kPositionMax] = position;
  r.metrics[Metric::kOrientationMax] = orientation;
  r.metrics[Metric::kJointVelocityMaxRatio] = ratio;
  r.metrics[Metric::kObstacleMinClearance] = clearance;
  return r;
}

inline RolloutResult diverged(double end_time) {
  RolloutResult r;
  r.status = RolloutStatus::kDiverged;
  r.end_time = end_time;
  r.reason = "diverged early";
  return r;
}

/// Two scenarios of 10 s: positions weigh 1 in both, orientation weighs 3 in the second.
class ObjectiveOfTwoScenarios : public testing::Test {
 protected:
  ObjectiveOfTwoScenarios() {
    scenarios_.resize(2);
    scenarios_[0].name = "plain";
    scenarios_[1].name = "hard";
    for (Scenario& s : scenarios_) s.duration = 10.0;
    scenarios_[1].obstacles.resize(1);  // there clearance is judged
  }

  Objective objective() const { return {terms_, constraints_, scenarios_, start_, "study.yaml"}; }
  InputError refusal() const {
    return input_error([&] { objective(); });
  }
  Evaluation judged(std::vector<RolloutResult> results) const {
    Evaluation e;
    e.results = std::move(results);
    objective().judge(e);
    return e;
  }

  std::vector<Scenario> scenarios_;
  std::vector<RolloutResult> start_ = {completed(0.002, 0.02, 0.4, NAN), completed(0.004, 0.04, 0.8, 0.2)};
  std::vector<ObjectiveTerm> terms_ = {{Metric::kPositionMax, 1.0, 0.0, {0, 1}},
                                       {Metric::kOrientationMax, 3.0, 0.0, {1}}};
  std::vector<Constraint> constraints_ = {{Metric::kJointVelocityMaxRatio, true, 0.9, {0, 1}},
                                          {Metric::kObstacleMinClearance, false, {}, {0, 1}}};
};

}  // namespace armtune::internal::test
