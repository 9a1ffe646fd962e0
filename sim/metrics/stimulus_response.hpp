#pragma once
// Measures the response of the arm to a stimulus, that is, a test signal (step or sum of sines) that the
// scenario adds to the tool's path or to a gaze target. Reference and response are scalars. For a path they
// are the desired and the true displacement in the direction of the stimulus. For a target, the reference is
// the angle of the line from tool to target, and the response is the angle of the tool's z axis. Both are
// measured in the plane in which this line turns.

#include <optional>

#include "sim/metrics/frequency_response.hpp"
#include "sim/metrics/metric.hpp"
#include "sim/metrics/observation.hpp"
#include "sim/metrics/step_response.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The stimulus as the reference, and how far the arm has moved in response [m, rad]. The reference is zero
/// while the stimulus is zero. The response is zero where the arm follows the undisturbed task.
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
  /// Writes the metrics response/*. They stay empty (NaN) unless the arm was in followTrajectory and outside
  /// a slerp: for a step, just before it; for sines, during the whole measured window. They also stay empty
  /// if the step of a target ever lies along the line to it, because it then does not turn this line.
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
