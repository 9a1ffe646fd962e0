#pragma once
// Detects joints that oscillate during a rollout although their task does not require it. The control loop is
// then near its stability limit or beyond it, or it amplifies noise. There are two signs:
//
//   - a joint shakes: its commanded torque swings by half of the effort limit or more, at 5 Hz or more;
//   - an oscillation grows: at 0.5 to 10 Hz, every swing of the joint's velocity about its reference is
//     larger than the one before it in the same direction, while the arm follows its task.

#include <optional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"
#include "sim/rollout/turning_points.hpp"

namespace armtune::internal {

/// A joint that oscillates, or did for a while.
struct Shake {
  std::string joint;
  double time = 0.0;       ///< when the oscillation began [s]
  double frequency = 0.0;  ///< mean [Hz]
  double swing = 0.0;      ///< largest change from one turning point to the next: of the torque divided by
                       ///< the effort limit, or of the velocity divided by its limit; at most 2 for torques
  bool growing = false;  ///< true: the velocity oscillates more and more; false: the torque shakes
};

class ShakeWatch {
 public:
  /// model: the arm that is observed; no reference to it is kept.
  explicit ShakeWatch(const RobotModel& model);

  /// Checks the commanded torque, cut off at the effort limit, and the true velocity. Call it once per
  /// control period. Allocates nothing.
  void look(const Observation& o);

  /// Returns the joint that began to oscillate first, or nothing if none did. Among joints that began at
  /// about the same time, this is the one with the highest frequency.
  std::optional<Shake> first() const;

 private:
  /// A series of turning points that follow each other fast enough.
  struct Run {
    int turns = 0;
    double began = 0.0, ended = 0.0;  ///< time of the first and the last turning point [s]
    double swing = 0.0;               ///< largest change from one to the next, as a share of the limit
    double frequency() const { return 0.5 * (turns - 1) / (ended - began); }
  };
  /// The swings of a velocity, as long as they grow.
  struct Growth {
    Run run;
    double interval = 0.0;            ///< time between the last two turning points [s]
    double last = 0.0, before = 0.0;  ///< the last swing, and the one before it
    double first = 0.0;               ///< the first swing of the run
  };
  struct Joint {
    TurningPoints torque, velocity;
    Run run;
    Growth growth;
    Run shook;  ///< the first run of the torque that is long enough to count; turns = 0: none yet
    Run grew;   ///< the first run of growing swings that counts
  };
  static void torque_turned(Joint& joint);
  static void velocity_turned(Joint& joint);
  void look(double time, const JointVector& velocity_error, const JointVector& commanded);

  std::vector<std::string> names_;
  JointVector effort_, speed_;  ///< limits
  std::vector<Joint> joints_;
};

/// Returns, for example, "its torque swings by 1.8 of its effort limit, at 41 Hz".
std::string swing_text(const Shake& shake);

/// Returns, for example, "wrist_3_joint shakes: its torque swings by 1.8 of its effort limit, at 41 Hz, from
/// 0.120 s on".
std::string to_string(const Shake& shake);

}  // namespace armtune::internal
