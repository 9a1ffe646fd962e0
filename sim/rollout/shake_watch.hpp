#pragma once
// Detects joints that shake during a rollout, that is, whose commanded torque oscillates. A torque that
// swings by half of the joint's effort limit or more, at 5 Hz or more, is hardly part of a task. The control
// loop is then near its stability limit, or it amplifies noise.

#include <optional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"

namespace armtune::internal {

/// A joint that shakes, or shook for a while.
struct Shake {
  std::string joint;
  double time = 0.0;       ///< when the shaking began [s]
  double frequency = 0.0;  ///< mean [Hz]
  double swing = 0.0;      ///< largest torque change from one turning point to the next, divided by the
                           ///< effort limit; at most 2
};

class ShakeWatch {
 public:
  /// model: the arm that is observed; no reference to it is kept.
  explicit ShakeWatch(const RobotModel& model);

  /// Checks the commanded torque, cut off at the effort limit. Call it once per control period. Allocates
  /// nothing.
  void look(const Observation& o);

  /// Returns the joint that shook first, or nothing if none did. Among joints that began at about the same
  /// time, this is the one with the highest frequency.
  std::optional<Shake> first() const;

 private:
  /// A series of turning points of the torque that follow each other fast enough.
  struct Run {
    int turns = 0;
    double began = 0.0, ended = 0.0;  ///< time of the first and the last turning point [s]
    double swing = 0.0;               ///< largest change from one to the next, as a share of the limit
    double frequency() const { return 0.5 * (turns - 1) / (ended - began); }
  };
  /// The state of the search for the turning points of a joint's torque. The torque has turned once it has
  /// moved back by the smallest swing that counts (hysteresis). While the direction is not known, `extreme`
  /// is the highest torque so far and `turned` the lowest.
  struct Turning {
    int direction = 0;     ///< 1: the torque rises, -1: it falls, 0: not known yet
    double extreme = 0.0;  ///< farthest torque since the last turn, as a share of the limit
    double at = 0.0;       ///< time of the extreme [s]
    double turned = 0.0;   ///< torque at the last turn, as a share of the limit
    Run run;               ///< the current run
    Run first;             ///< the first run that is long enough to count; turns = 0: none yet
  };
  static void turn(Turning& joint);
  void look(double time, const JointVector& commanded);

  std::vector<std::string> joints_;
  JointVector effort_;
  std::vector<Turning> turning_;
  bool looked_ = false;  ///< true after the first call of look()
};

/// Returns, for example, "wrist_3_joint shakes: its torque swings by 1.8 of its effort limit, at 41 Hz, from
/// 0.120 s on".
std::string to_string(const Shake& shake);

}  // namespace armtune::internal
