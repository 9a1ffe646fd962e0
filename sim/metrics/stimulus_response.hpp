#pragma once
// How the arm answers to its scenario's stimulus, as one scalar against another: of the tool's path the
// displacement along the stimulus, of a gaze target the angle of the tool's z axis in the plane in which the
// line from tool to target turns.

#include <optional>

#include "sim/metrics/frequency_response.hpp"
#include "sim/metrics/metric.hpp"
#include "sim/metrics/observation.hpp"
#include "sim/metrics/step_response.hpp"
#include "sim/scenario/scenario.hpp"

namespace armtune::internal {

/// The stimulus as it is asked for, and how far the arm has gone: both zero where the arm does what it would
/// do without [m, rad].
struct StimulusSignals {
  double reference = 0.0;
  double response = 0.0;
};

/// From the undisturbed position of path or target [m] and the tool's true pose. Angles are from the line
/// tool to undisturbed target towards the stimulus, both for the line to the shifted target and for tool z:
/// a tool that turns too far has gone further than the reference. Where the stimulus is along that line, it
/// does not turn: both zero.
StimulusSignals path_signals(const Stimulus& stimulus, double t, const Vec3& path, const Poses& poses);
StimulusSignals target_signals(const Stimulus& stimulus, double t, const Vec3& target, const Poses& poses);

class StimulusResponse {
 public:
  /// A scenario with a stimulus, which must outlive this.
  explicit StimulusResponse(const Scenario& scenario);

  void add(const Observation& o);
  /// Fills the metrics response/*. They stay empty if the arm was not in followTrajectory, outside a slerp,
  /// when the step came, or left that while the sines were measured.
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
