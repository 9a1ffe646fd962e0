#pragma once
// The state of a rollout between its periods: the inputs of arm, controller and plant, and the evaluation of
// their outputs. The arithmetic itself is done elsewhere, for one arm alone (Rollout) or for several side by
// side (RolloutLanes).
//
// The steps of a period are: sense, control, act, true state, judge, plant, moved.

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
  /// threshold: the gains' slerpAngularErrorThreshold [rad]. All arguments must outlive this object.
  RunningRollout(const PreparedScenario& prepared, double threshold, const EndLimits& limits);
  RunningRollout(const RunningRollout&) = delete;  // its parts refer to each other
  RunningRollout& operator=(const RunningRollout&) = delete;

  /// Returns the joint velocities q' (n) at the start.
  JointVector start_velocity() const;
  bool goes_on() const { return !ended_ && k_ < periods_; }

  const Scenario& scenario() const { return scenario_; }
  /// Returns the number of the next period, counted from 0.
  int period() const { return k_; }
  /// Begins a period in this world, with the plant at q, q' (n). All three arguments must stay in place until
  /// the plant has moved.
  void sense(const JointVector& q, const JointVector& qd, const World& world);
  double time() const { return observation_.time; }  ///< [s]
  const JointState& measured() const { return measured_; }
  bool measures_exactly() const { return sensors_.exact(); }
  /// True if the controller sees both the arm and the target exactly.
  bool sees_exactly() const { return sensors_.exact() && !scenario_.camera; }
  const Scene& scene() const { return scene_; }

  /// Takes the controller's output and returns the observation with the torque that acts now. The caller then
  /// fills in the true state. Kd (n): null unless the torque contains -Kd S. All three arguments must stay in
  /// place until the plant has moved.
  Observation& act(const ControlOutput& control, const ParameterVector& theta, const JointVector* Kd);
  /// Evaluates the complete observation. Returns false if the rollout ends with it, before the plant moves.
  bool judge(const Observer& observer);
  /// Ends the period with the plant at q, q'. failure: why the plant failed; empty if it did not.
  void moved(const JointVector& q, const JointVector& qd, const std::string& failure);

  /// Returns the result. Call it once, after goes_on() has become false.
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
  JointVector diverged_velocity_;  ///< joint speeds above which the rollout has diverged
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
