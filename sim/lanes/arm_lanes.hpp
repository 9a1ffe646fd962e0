#pragma once
// The arithmetic of several arms side by side, behind one interface for all processors and widths: numbers
// are put into lanes and taken out of them one arm at a time, and the steps between are done for all lanes at
// once. Every lane's numbers are, to the bit, those of core's kernels for that arm alone.
//
// A control period: put_measured, measure, [put_task_reference and resolve | put_joint_reference], torque,
// adapt, observe, step. An arm's first: put_chains, put_control, put_centering, put_theta, put_state.

#include <memory>

#include "core/control/inverse_damping.hpp"
#include "sim/lanes/lane_kind.hpp"
#include "sim/lanes/processor.hpp"

namespace armtune::internal {

/// What a lane's controller wants to be put in once.
struct LaneControl {
  InverseDamping damping;
  double adaptation_gain = 0.0;     ///< gamma
  double adaptation_leakage = 0.0;  ///< [1/s]
  double inertia_leakage = 0.0;     ///< the same in addition, of inertias
  double filter_share = 0.0;        ///< of the adaptation's filter; 0: none
};

/// Where a tool's pose (9 numbers of R, column by column, and 3) and (v, w) are to go; base frame.
struct LaneTool {
  double* R_0T;
  double* p_0T;
  double* twist;
};

class ArmLanes {
 public:
  ArmLanes() = default;
  ArmLanes(const ArmLanes&) = delete;
  ArmLanes& operator=(const ArmLanes&) = delete;
  virtual ~ArmLanes() = default;

  virtual int lanes() const = 0;

  /// Every number of the controller's chain and of the plant's (numbers_of).
  virtual void put_chains(int lane, const double* control, const double* plant) = 0;
  virtual void put_control(int lane, const LaneControl& control) = 0;
  /// n each.
  virtual void put_centering(int lane, const double* middle, const double* rate) = 0;
  virtual void put_theta(int lane, const double* start, const double* truth) = 0;  ///< 13 n each
  virtual void put_state(int lane, const double* q, const double* qd) = 0;         ///< of the plant
  virtual void get_state(int lane, double* q, double* qd) const = 0;

  /// Where the arm is measured to be; obstacles: 4 numbers for each of `count` (center, radius).
  virtual void put_measured(int lane, const double* q, const double* qd, const double* obstacles,
                            std::size_t count) = 0;
  virtual void measure() = 0;
  /// What an ArmView shows.
  virtual void get_measured(int lane, const LaneTool& tool, double& manipulability, bool& damped,
                            double& obstacle_distance) const = 0;

  /// Six each: xr', xr''. This lane's joint reference is to come from them.
  virtual void put_task_reference(int lane, const double* rate, const double* acceleration) = 0;
  /// For the lanes that were put a task reference since the last measure().
  virtual void resolve() = 0;
  virtual void get_joint_reference(int lane, double* velocity, double* acceleration) const = 0;
  virtual void put_joint_reference(int lane, const double* velocity, const double* acceleration) = 0;

  virtual void put_Kd(int lane, const double* Kd) = 0;
  /// Y theta - Kd S.
  virtual void torque() = 0;
  virtual void get_commanded(int lane, double* torque) const = 0;

  /// theta goes on in the lanes of which `adapting` is true.
  virtual void adapt(const bool* adapting) = 0;
  virtual void get_theta(int lane, double* theta) const = 0;
  virtual void replace_theta(int lane, const double* theta) = 0;

  /// The true state; exact: what was measured was exact in every lane, and need not be computed again.
  virtual void observe(bool exact) = 0;
  /// The tool only if it is not what was measured.
  virtual void get_observed(int lane, const LaneTool& tool, double& clearance,
                            double& compensation_error) const = 0;

  virtual void put_torque(int lane, const double* torque) = 0;
  /// The plants move by one control period.
  virtual void step() = 0;
};

/// As many lanes as are asked for, 1 at least and most_lanes() at most: the next larger number of 2, 4 or 8.
std::unique_ptr<ArmLanes> make_arm_lanes(const LaneKind& kind, int lanes, Processor processor);

/// Most lanes that are worth it on a processor.
int most_lanes(Processor processor);

}  // namespace armtune::internal
