#pragma once
// The arithmetic of several arms side by side, behind one interface for all processors and widths. Numbers
// are put into lanes and taken out of them one arm at a time, and the steps between are computed for all
// lanes at once. The numbers of every lane are bit-identical to those of core's kernels for that arm alone.
//
// An arm begins with start(). A control period is: sense, measure, seen, follow_task or follow_joints,
// resolve, torque, adapt, observe, observed, push, step, moved. The arguments are structs of pointers. Code
// that is compiled for one kind of processor must not share an inline function with the rest
// (scripts/check-lanes).

#include <memory>

#include "core/control/inverse_damping.hpp"
#include "core/control/laws/arm_law.hpp"
#include "sim/lanes/lane_kind.hpp"
#include "sim/lanes/processor.hpp"

namespace armtune::internal {

/// The numbers of an arm that starts in a lane.
struct LaneStart {
  const double* control_chain;  ///< every number of the controller's chain (numbers_of)
  const double* plant_chain;
  InverseDamping damping;
  LawNumbers law;
  const double* centering_middle;  ///< n
  const double* centering_rate;    ///< n
  const double* theta_true;        ///< 13 n
  const double* q;                 ///< n, of the plant
  const double* qd;
};

/// The measured state of an arm, and the obstacles around it.
struct LaneSensed {
  const double* q;  ///< n
  const double* qd;
  const double* obstacles;  ///< 4 numbers each (center, radius)
  std::size_t obstacle_count;
};

/// The destination of a tool's pose (9 numbers of R, column by column, and 3) and of (v, w); base frame.
struct LaneTool {
  double* R_0T;
  double* p_0T;
  double* twist;
};

/// The destination of the contents of an ArmView.
struct LaneSeen {
  LaneTool tool;
  double* manipulability;
  bool* damped;
  double* obstacle_distance;
};

/// The references of the task (6 each: xr', xr'') or of the joints (n each: qr', qr'').
struct LaneReference {
  const double* velocity;
  const double* acceleration;
};

/// The task's references (6 each), and further inputs of a law.
struct LaneTask {
  LaneReference reference;
  const double* pose_error;  ///< 6
  bool yields;               ///< to an obstacle's repulsion
};

/// The destination of the true state at the end of a period. The tool is written only if it differs from the
/// measured one.
struct LaneObserved {
  LaneTool tool;
  double* clearance;
  double* compensation_error;
};

class ArmLanes {
 public:
  ArmLanes() = default;
  ArmLanes(const ArmLanes&) = delete;
  ArmLanes& operator=(const ArmLanes&) = delete;
  virtual ~ArmLanes() = default;

  virtual int lanes() const = 0;

  virtual void start(int lane, const LaneStart& arm) = 0;
  /// Sets the state of the plant (n each).
  virtual void place(int lane, const double* q, const double* qd) = 0;

  virtual void sense(int lane, const LaneSensed& sensed) = 0;
  virtual void measure() = 0;
  virtual void seen(int lane, const LaneSeen& seen) const = 0;

  /// Lets this lane take its joint reference from the task's. Kd: n.
  virtual void follow_task(int lane, const LaneTask& task, const double* Kd) = 0;
  virtual void follow_joints(int lane, const LaneReference& joints, const double* Kd) = 0;
  /// Computes the joint references of the lanes that follow a task since the last measure().
  virtual void resolve() = 0;
  /// Writes the joint reference (n each). replace_reference() sets another one.
  virtual void reference(int lane, double* velocity, double* acceleration) const = 0;
  virtual void replace_reference(int lane, const LaneReference& joints) = 0;

  /// Computes the law's torques.
  virtual void torque() = 0;
  virtual void commanded(int lane, double* torque) const = 0;

  /// Adapts theta in the lanes where `adapting` is true.
  virtual void adapt(const bool* adapting) = 0;
  virtual void theta(int lane, double* theta) const = 0;
  virtual void replace_theta(int lane, const double* theta) = 0;

  /// Computes the true state. exact: true if the measurement was exact in every lane, so that its results are
  /// used again.
  virtual void observe(bool exact) = 0;
  virtual void observed(int lane, const LaneObserved& observed) const = 0;

  virtual void push(int lane, const double* torque) = 0;
  /// Moves the plants by one control period.
  virtual void step() = 0;
  virtual void moved(int lane, double* q, double* qd) const = 0;
};

/// Returns at least `lanes` lanes (2, 4 or 8), but no more than most_lanes() of the processor.
std::unique_ptr<ArmLanes> make_arm_lanes(const LaneKind& kind, int lanes, Processor processor);

/// Returns the largest useful number of lanes on a processor.
int most_lanes(Processor processor);

}  // namespace armtune::internal
