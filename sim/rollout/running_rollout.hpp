#pragma once
// Holds the state of a rollout (one simulated scenario) while it runs: time, sensors, torque delay, metrics,
// and whether it has ended. These are the parts that all simulators share. The callers compute the controller
// and move the plant (the simulated arm), for one rollout alone (Rollout) or for several at the same time
// (RolloutLanes).
//
// In every control period, the caller does these steps in this order: it calls sense(), computes the
// controller, calls act(), fills in the true state, calls judge(), moves the plant and calls moved().

#include <optional>
#include <string>
#include <vector>

#include "core/common/delay_line.hpp"
#include "sim/metrics/accumulator.hpp"
#include "sim/metrics/goal_watch.hpp"
#include "sim/metrics/series_recorder.hpp"
#include "sim/metrics/stimulus_response.hpp"
#include "sim/plant/sensors.hpp"
#include "sim/plant/target_camera.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/prepared_scenario.hpp"
#include "sim/rollout/rollout_result.hpp"
#include "sim/rollout/world.hpp"

namespace armtune::internal {

class RunningRollout {
 public:
  /// threshold: the gains' slerpAngularErrorThreshold [rad]. torque_delay: number of control periods by which
  /// torques are delayed. drive_steps: periods of the robot's drives in a control period; 1 if it has none.
  /// All references must outlive this object.
  RunningRollout(const PreparedScenario& prepared, double threshold, const EndLimits& limits,
                 int torque_delay, int drive_steps = 1);
  RunningRollout(const RunningRollout&) = delete;  // its parts refer to each other
  RunningRollout& operator=(const RunningRollout&) = delete;

  /// Records the series behind these metrics. Call it before the first period; an empty list records nothing.
  void record(const std::vector<Metric>& metrics);

  /// Returns the joint velocities q' (n) at the start.
  JointVector start_velocity() const;
  bool goes_on() const { return !ended_ && k_ < periods_; }

  const Scenario& scenario() const { return scenario_; }
  /// Returns the number of the next period, counted from 0.
  int period() const { return k_; }
  /// Begins a control period with the plant at q, q' (n): measures the state and prepares the controller's
  /// inputs. world: targets, path and obstacles in this period. All three arguments must stay in place until
  /// moved() is called.
  void sense(const JointVector& q, const JointVector& qd, const World& world);
  double time() const { return observation_.time; }  ///< [s]
  const JointState& measured() const { return measured_; }
  bool measures_exactly() const { return sensors_.exact(); }
  /// True if the controller receives both the arm's state and the target's motion exactly.
  bool sees_exactly() const { return sensors_.exact() && !scenario_.camera; }
  const Scene& scene() const { return scene_; }

  /// Passes the controller's torque through the delay, and returns the observation with the torque that acts
  /// now. The caller then fills in the true state. Kd (n): gains of the damping term -Kd S in the torque,
  /// where S = q' - qr'; null if the torque has no such term. All three arguments must stay in place until
  /// moved() is called.
  Observation& act(const ControlOutput& control, const ParameterVector& theta, const JointVector* Kd);
  /// Updates the metrics with the complete observation, calls the observer and checks the end limits. Returns
  /// false if the rollout ends here, before the plant moves.
  bool judge(const Observer& observer);
  /// Begins the period of the robot's drives that starts the time `after` [s] after the control period, with
  /// the plant at q, q' (n). Returns the instant. The caller computes its torques from measured_by_drives().
  DriveInstant& begin_drive_period(double after, const JointVector& q, const JointVector& qd);
  const JointState& measured_by_drives() const { return between_measured_; }
  /// Ends the period with the plant at q, q' (n), and checks whether the rollout has diverged. failure: why
  /// the engine failed; empty if it did not.
  void moved(const JointVector& q, const JointVector& qd, const std::string& failure);

  /// Returns the result. Call it once, after goes_on() has become false.
  RolloutResult result();

 private:
  void end(RolloutStatus status, std::string reason);

  const PreparedScenario& prepared_;
  const Scenario& scenario_;
  const EndLimits& limits_;
  double threshold_;  ///< gaze error below which a target counts as reached [rad]
  int periods_;
  int drive_steps_;
  Sensors sensors_;
  TargetCamera camera_;
  DelayLine delay_;
  MetricAccumulator metrics_;
  JointVector diverged_velocity_;  ///< joint speeds above which the rollout has diverged
  std::optional<StimulusResponse> response_;
  std::optional<GoalWatch> goal_;
  std::optional<ClearanceWatch> cell_;
  std::optional<SeriesRecorder> series_;
  JointState measured_;
  std::vector<DriveInstant> between_;  ///< since the last call of judge()
  JointState between_measured_;
  Path path_;
  Scene scene_;
  Observation observation_;
  const JointVector* Kd_ = nullptr;
  RolloutResult result_;
  int k_ = 0;
  bool ended_ = false;
};

}  // namespace armtune::internal
