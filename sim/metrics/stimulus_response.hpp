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

/// The reference, which is the stimulus, and the response, which is the motion of the arm that it causes [m,
/// rad]. The reference is zero while the stimulus is zero. The response is zero as long as the arm follows
/// the undisturbed task exactly.
struct StimulusSignals {
  double reference = 0.0;
  double response = 0.0;
};

/// Returns the signals at t [s]. path, target: undisturbed position of the path or of the target [m]. poses:
/// true poses of the arm; only the tool's pose is used.
///
/// With a target, both signals are angles from the line between tool and undisturbed target, positive towards
/// the stimulus. The reference is the angle of the line to the shifted target, and the response is the angle
/// of the tool's z axis. The response exceeds the reference if the tool turns too far. If the stimulus is
/// parallel to the line, it does not turn the line, and both signals are zero.
StimulusSignals path_signals(const Stimulus& stimulus, double t, const Vec3& path, const Poses& poses);
StimulusSignals target_signals(const Stimulus& stimulus, double t, const Vec3& target, const Poses& poses);

class StimulusResponse {
 public:
  /// scenario: has a stimulus, and must outlive this object.
  explicit StimulusResponse(const Scenario& scenario);

  void add(const Observation& o);
  /// Writes the metrics response/*. The arm counts as tracking if it is in the state followTrajectory and not
  /// in a slerp. The metrics stay empty (NaN) in these cases:
  ///   - With a step, the arm was not tracking in the period before the step.
  ///   - With a step of a target, the step was at some time parallel to the line from tool to target. Such a
  ///     step does not turn this line.
  ///   - With sines, the arm was not always tracking in the measured window, or the rollout ended before the
  ///     window did.
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
