#pragma once
// The response of the arm to its scenario's stimulus, as one scalar compared with another. For a tool path
// it is the displacement along the stimulus. For a gaze target it is the angle of the tool's z axis in the
// plane in which the line from tool to target turns.

#include <optional>

#include "sim/metrics/frequency_response.hpp"
#include "sim/metrics/metric.hpp"
#include "sim/metrics/observation.hpp"
#include "sim/metrics/step_response.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The stimulus as the reference, and how far the arm has moved in response [m, rad]. The reference is zero
/// without a stimulus. The response is zero where the arm follows the undisturbed task.
struct StimulusSignals {
  double reference = 0.0;
  double response = 0.0;
};

/// Returns the signals from the undisturbed position of the path or the target [m] and the tool's true pose.
/// Angles are measured from the line between tool and undisturbed target towards the stimulus, both for the
/// line to the shifted target and for the tool's z axis. A tool that turns too far has a larger response than
/// reference. A stimulus along that line does not turn it: both signals are zero.
StimulusSignals path_signals(const Stimulus& stimulus, double t, const Vec3& path, const Poses& poses);
StimulusSignals target_signals(const Stimulus& stimulus, double t, const Vec3& target, const Poses& poses);

class StimulusResponse {
 public:
  /// scenario: has a stimulus, and must outlive this object.
  explicit StimulusResponse(const Scenario& scenario);

  void add(const Observation& o);
  /// Fills the metrics response/*. Those of a step stay empty unless the arm was in followTrajectory, outside
  /// a slerp, when the step came, and the step turned the line to its target. Those of sines stay empty
  /// unless the arm was in followTrajectory, outside a slerp, throughout the measured window.
  void write(Metrics& m) const;

 private:
  StimulusSignals signals(const Observation& o) const;

  const Scenario& scenario_;
  const Stimulus& stimulus_;
  std::optional<StepResponse> step_;
  std::optional<FrequencyResponse> sines_;
  bool started_ = false;
  bool valid_ = true;
  bool was_tracking_ = false;
  double start_ = 0.0;  ///< first period in which the stimulus acts [s]
  long window_periods_ = 0;
};

}  // namespace armtune::internal
