#pragma once
// Computes controller and dynamics of several arms at the same time with SIMD instructions. Each arm has one
// lane, that is, one element of every vector register. This interface is the same for all processors and
// register widths.
//
// Numbers are written to a lane and read from it for one arm at a time. All other steps are computed for all
// lanes at once. The results of a lane are bit-identical to those of core's functions for that arm alone.
//
// The caller calls start() once for an arm. In every control period it calls these functions in this order:
// sense, measure, seen, follow_task or follow_joints, follow_plan if there is a plan, resolve, torque, adapt,
// observe, observed, push, step, moved. If the law commands drives, the caller computes their torques for
// each arm. After torque it then calls weigh, which computes the torques that hold the arms' weights, and it
// calls push, step and moved once in every period of the drives.
//
// The arguments are structs of pointers, because code that is compiled for one kind of processor must not
// share an inline function with other code (scripts/check-lanes).

#include <memory>

#include "core/control/inverse_damping.hpp"
#include "core/control/laws/arm_law.hpp"
#include "sim/lanes/lane_kind.hpp"
#include "sim/lanes/processor.hpp"

namespace armtune::internal {

/// The models, gains and start state of an arm whose rollout starts in a lane.
struct LaneStart {
  const double* control_chain;  ///< numbers of the controller's chain, in the order of chain_numbers.hpp
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

/// The addresses to which a tool's pose (9 numbers of R, column by column, and 3 of p) and its twist (v, w)
/// are written; base frame.
struct LaneTool {
  double* R_0T;
  double* p_0T;
  double* twist;
};

/// The addresses to which quantities of the measured arm are written: the members of ArmView
/// (core/control/control_logic.hpp).
struct LaneSeen {
  LaneTool tool;
  double* manipulability;
  bool* damped;
  double* obstacle_distance;
};

/// The reference velocity and acceleration of the task (6 each: xr', xr'') or of the joints (n each: qr',
/// qr'').
struct LaneReference {
  const double* velocity;
  const double* acceleration;
};

/// The planned joint motion (n each) of this period: the members of PlannedJoints
/// (core/control/laws/planned_joints.hpp).
struct LanePlan {
  const double* position;
  const double* velocity;
  const double* fed_velocity;
};

/// The task's references (6 each), and further inputs of a law.
struct LaneTask {
  LaneReference reference;
  const double* pose_error;  ///< 6
  bool yields;               ///< true in the state avoidObstacles: the arm gives way to the repulsion
};

/// The addresses to which quantities of the true state are written at the end of a period. The tool is not
/// written after observe(true), because its true pose and twist are then the measured ones.
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

  /// Sets a task reference for this lane. resolve() then computes the joint reference from it. Kd: n.
  virtual void follow_task(int lane, const LaneTask& task, const double* Kd) = 0;
  /// Sets the joint reference of this lane directly. Kd: n.
  virtual void follow_joints(int lane, const LaneReference& joints, const double* Kd) = 0;
  /// Gives the law of this lane the planned joint motion of this period, from which the reference of
  /// follow_joints() was computed. Lanes without this call have no plan in this period.
  virtual void follow_plan(int lane, const LanePlan& plan) = 0;
  /// Computes the joint references of the lanes for which follow_task() was called since the last measure().
  virtual void resolve() = 0;
  /// Writes the joint reference (n each) to these addresses. replace_reference() sets another one.
  virtual void reference(int lane, double* velocity, double* acceleration) const = 0;
  virtual void replace_reference(int lane, const LaneReference& joints) = 0;

  /// Computes the law's torques, or its commands for the drives.
  virtual void torque() = 0;
  virtual void commanded(int lane, double* torque) const = 0;
  /// Computes the torques that hold the arms' weights, for laws that command drives.
  virtual void weigh() = 0;
  virtual void weight(int lane, double* torque) const = 0;

  /// Adapts theta in the lanes where `adapting` is true.
  virtual void adapt(const bool* adapting) = 0;
  /// Makes rotor inertia and friction of theta physically valid in the lanes where `projecting` is true, and
  /// finds the links of these lanes whose parameters are not. invalid: for each lane, bit i for link i.
  virtual void project(const bool* projecting, std::uint32_t* invalid) = 0;
  /// Writes the parameters of a link (10) to this address. replace_link_theta() sets others.
  virtual void link_theta(int lane, int link, double* parameters) const = 0;
  virtual void replace_link_theta(int lane, int link, const double* parameters) = 0;

  /// Computes quantities of the true state. exact: true if the measurement was exact in every lane. The
  /// results for the measured state are then used for the true state as well.
  virtual void observe(bool exact) = 0;
  virtual void observed(int lane, const LaneObserved& observed) const = 0;

  /// Sets the torques (n) that act on the plant.
  virtual void push(int lane, const double* torque) = 0;
  /// Moves the plants by one period of the drives, or without drives by one control period.
  virtual void step() = 0;
  virtual void moved(int lane, double* q, double* qd) const = 0;
};

/// Creates at least `lanes` lanes (2, 4 or 8), but no more than most_lanes() of the processor.
std::unique_ptr<ArmLanes> make_arm_lanes(const LaneKind& kind, int lanes, Processor processor);

/// Returns the largest useful number of lanes on a processor.
int most_lanes(Processor processor);

}  // namespace armtune::internal
