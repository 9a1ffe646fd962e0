#pragma once
// A rollout between its periods: what arm, controller and plant are given, and what is made of what they do.
// Where their arithmetic happens, for one arm alone or for several side by side, is not its business.
//
// A period is: sense, control, act, true state, judge, plant, moved.

#include <optional>
#include <string>

#include "sim/metrics/accumulator.hpp"
#include "sim/metrics/stimulus_response.hpp"
#include "sim/plant/sensors.hpp"
#include "sim/plant/target_camera.hpp"
#include "sim/plant/torque_delay.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/prepared_scenario.hpp"
#include "sim/rollout/rollout_result.hpp"
#include "sim/rollout/world.hpp"

namespace armtune::internal {

class RunningRollout {
 public:
  /// threshold: the gains' slerpAngularErrorThreshold [rad]. All arguments outlive this.
  RunningRollout(const PreparedScenario& prepared, double threshold, const EndLimits& limits);
  RunningRollout(const RunningRollout&) = delete;  // its parts refer to each other
  RunningRollout& operator=(const RunningRollout&) = delete;

  /// q' (n) that it starts with.
  JointVector start_velocity() const;
  bool goes_on() const { return !ended_ && k_ < periods_; }

  const Scenario& scenario() const { return scenario_; }
  /// Number of the period that begins next, from 0 on.
  int period() const { return k_; }
  /// A period begins in the world as it is in this one, with the plant at q, q' (n); all three stay where
  /// they are until it has moved.
  void sense(const JointVector& q, const JointVector& qd, const World& world);
  double time() const { return observation_.time; }  ///< [s]
  const JointState& measured() const { return measured_; }
  bool measures_exactly() const { return sensors_.exact(); }
  /// The controller knows target and arm as they are.
  bool sees_exactly() const { return sensors_.exact() && !scenario_.camera; }
  const Scene& scene() const { return scene_; }

  /// The controller's answer; the torque that acts now is in the observation, whose true state is still to
  /// be filled in. Kd (n): if the torque contains -Kd S, else null; all three stay until the plant has moved.
  Observation& act(const ControlOutput& control, const ParameterVector& theta, const JointVector* Kd);
  /// The observation is whole. False: the rollout ends with it, before the plant moves.
  bool judge(const Observer& observer);
  /// The plant is at q, q' now, or it failed (not empty: why).
  void moved(const JointVector& q, const JointVector& qd, const std::string& failure);

  /// To be asked once, when it no longer goes on.
  RolloutResult result();

 private:
  void end(RolloutStatus status, std::string reason);

  const PreparedScenario& prepared_;
  const Scenario& scenario_;
  const EndLimits& limits_;
  int periods_;
  Sensors sensors_;
  TargetCamera camera_;
  TorqueDelay delay_;
  MetricAccumulator metrics_;
  JointVector diverged_velocity_;  ///< beyond which a joint will not come back
  std::optional<StimulusResponse> response_;
  std::optional<ClearanceWatch> cell_;
  JointState measured_;
  Path path_;
  Scene scene_;
  Observation observation_;
  const JointVector* Kd_ = nullptr;
  RolloutResult result_;
  int k_ = 0;
  bool ended_ = false;
};

}  // namespace armtune::internal
