#pragma once
// The arithmetic of several arms side by side, behind one interface for all processors and widths: numbers
// are put into lanes and taken out of them one arm at a time, and the steps between are done for all lanes at
// once. Every lane's numbers are, to the bit, those of core's kernels for that arm alone.
//
// An arm's first is start(). A control period: sense, measure, seen, follow_task or follow_joints, resolve,
// torque, adapt, observe, observed, push, step, moved. What is put and taken are structs of pointers, since
// what is compiled for one kind of processor must share no inline function with the rest
// (scripts/check-lanes).

#include <memory>

#include "core/control/inverse_damping.hpp"
#include "core/control/laws/arm_law.hpp"
#include "sim/lanes/lane_kind.hpp"
#include "sim/lanes/processor.hpp"

namespace armtune::internal {

/// An arm that begins in a lane.
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

/// Where an arm is measured to be, and the obstacles around it.
struct LaneSensed {
  const double* q;  ///< n
  const double* qd;
  const double* obstacles;  ///< 4 numbers each (center, radius)
  std::size_t obstacle_count;
};

/// Where a tool's pose (9 numbers of R, column by column, and 3) and (v, w) are to go; base frame.
struct LaneTool {
  double* R_0T;
  double* p_0T;
  double* twist;
};

/// What an ArmView shows.
struct LaneSeen {
  LaneTool tool;
  double* manipulability;
  bool* damped;
  double* obstacle_distance;
};

/// References of the task (6 each: xr', xr'') or of the joints (n each: qr', qr'').
struct LaneReference {
  const double* velocity;
  const double* acceleration;
};

/// The task's references (6 each), and what a law wants to know beside.
struct LaneTask {
  LaneReference reference;
  const double* pose_error;  ///< 6
  bool yields;               ///< to an obstacle's repulsion
};

/// The true state at the end of a period. The tool is written only if it is not what was measured.
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
  /// Puts the plant elsewhere (n each).
  virtual void place(int lane, const double* q, const double* qd) = 0;

  virtual void sense(int lane, const LaneSensed& sensed) = 0;
  virtual void measure() = 0;
  virtual void seen(int lane, const LaneSeen& seen) const = 0;

  /// This lane's joint reference is to come from the task's. Kd: n.
  virtual void follow_task(int lane, const LaneTask& task, const double* Kd) = 0;
  virtual void follow_joints(int lane, const LaneReference& joints, const double* Kd) = 0;
  /// For the lanes that follow a task since the last measure().
  virtual void resolve() = 0;
  /// The joint reference (n each), and another one in its place.
  virtual void reference(int lane, double* velocity, double* acceleration) const = 0;
  virtual void replace_reference(int lane, const LaneReference& joints) = 0;

  /// The law's torques.
  virtual void torque() = 0;
  virtual void commanded(int lane, double* torque) const = 0;

  /// theta adapts in the lanes where `adapting` is true.
  virtual void adapt(const bool* adapting) = 0;
  virtual void theta(int lane, double* theta) const = 0;
  virtual void replace_theta(int lane, const double* theta) = 0;

  /// The true state; exact: what was measured was exact in every lane, and need not be computed again.
  virtual void observe(bool exact) = 0;
  virtual void observed(int lane, const LaneObserved& observed) const = 0;

  virtual void push(int lane, const double* torque) = 0;
  /// The plants move by one control period.
  virtual void step() = 0;
  virtual void moved(int lane, double* q, double* qd) const = 0;
};

/// As many lanes as are asked for, 1 at least and most_lanes() at most: the next larger number of 2, 4 or 8.
std::unique_ptr<ArmLanes> make_arm_lanes(const LaneKind& kind, int lanes, Processor processor);

/// Most lanes that are worth it on a processor.
int most_lanes(Processor processor);

}  // namespace armtune::internal
