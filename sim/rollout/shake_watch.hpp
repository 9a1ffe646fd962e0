#pragma once
// Watches the torques of a rollout for joints that shake. A torque that swings to and fro by half of the
// joint's effort limit and more, at 5 Hz and more, is hardly the motion of a task: the loop is near its
// stability limit, or it amplifies noise.

#include <optional>
#include <string>
#include <vector>

#include "sim/metrics/observation.hpp"

namespace armtune::internal {

/// A joint that shakes, or shook for a while.
struct Shake {
  std::string joint;
  double time = 0.0;       ///< when it began [s]
  double frequency = 0.0;  ///< mean [Hz]
  double swing = 0.0;      ///< largest, from one turn to the next, over the effort limit; 2 at most
};

class ShakeWatch {
 public:
  /// model: of the arm that is observed; it is not referred to afterwards.
  explicit ShakeWatch(const RobotModel& model);

  /// To be called once per control period. Looks at the commanded torque, cut off at the effort limit.
  /// Allocates nothing.
  void look(const Observation& o);

  /// Returns the joint that shook first, of several the one that shook fastest; nothing if none did.
  std::optional<Shake> first() const;

 private:
  /// Turns that follow each other fast enough.
  struct Run {
    int turns = 0;
    double began = 0.0, ended = 0.0;  ///< first and last of them [s]
    double swing = 0.0;               ///< largest between two of them, as a share of the limit
    double frequency() const { return 0.5 * (turns - 1) / (ended - began); }
  };
  /// Where a joint's torque turns, found with a hysteresis of the smallest swing that counts.
  struct Turning {
    int direction = 0;     ///< 1: the torque rises, -1: it falls, 0: not known yet
    double extreme = 0.0;  ///< farthest since the last turn, as a share of the limit; at first the highest
    double at = 0.0;       ///< when [s]
    double turned = 0.0;   ///< the last turn; at first the lowest
    Run run;               ///< under way
    Run first;             ///< of those that are long enough; no turns: there was none
  };
  static void turn(Turning& joint);

  std::vector<std::string> joints_;
  JointVector effort_;
  std::vector<Turning> turning_;
  bool looked_ = false;  ///< before this period
};

/// Returns, for example, "wrist_3_joint shakes: its torque swings by 1.8 of its effort limit, at 41 Hz, from
/// 0.120 s on".
std::string to_string(const Shake& shake);

}  // namespace armtune::internal
