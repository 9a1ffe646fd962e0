#pragma once
// Simulates several scenarios at the same time with SIMD instructions, in armtune's own dynamics. A rollout
// is one simulated scenario. Each rollout has one lane, that is, one element of every vector register. It
// begins and ends independently of the other rollouts. Its result is bit-identical to that of a single
// Rollout with Engine::kNative.

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "core/control/gains.hpp"
#include "sim/lanes/arm_lanes.hpp"
#include "sim/rollout/end_limit.hpp"
#include "sim/rollout/prepared_scenario.hpp"
#include "sim/rollout/rollout_result.hpp"
#include "sim/rollout/world.hpp"

namespace armtune::internal {

/// Returns the properties that a rollout must have to be simulated together with this scenario.
/// most_obstacles: largest number of obstacles of any such rollout, at least the scenario's own. Throws
/// InputError for the stepper kReference.
LaneKind lane_kind(const Scenario& scenario, Stepper stepper, std::size_t most_obstacles,
                   ArmLawKind law = ArmLawKind::kAdaptive);

/// Returns the control law of these gains if RolloutLanes can simulate it, otherwise nothing. Rollouts with
/// any other law are simulated one at a time, by Rollout.
std::optional<ArmLawKind> lane_law(const Gains& gains);

/// One rollout that is to be simulated in a lane.
struct LaneJob {
  std::shared_ptr<const PreparedScenario> scenario;
  Gains gains;
  EndLimits limits = {};
  std::vector<Metric> series = {};  ///< metrics whose series the result shall have (rollout_series.hpp)
};

class RolloutLanes {
 public:
  using Finished = std::function<void(int lane, RolloutResult&& result)>;

  /// lanes: the wanted number of lanes, see make_arm_lanes.
  RolloutLanes(const LaneKind& kind, int lanes, Processor processor = best_processor());
  ~RolloutLanes();
  RolloutLanes(const RolloutLanes&) = delete;
  RolloutLanes& operator=(const RolloutLanes&) = delete;

  int lanes() const { return static_cast<int>(lanes_.size()); }
  int busy() const { return busy_; }
  bool is_busy(int lane) const;
  /// Returns the simulated time that the rollout in a busy lane has reached [s].
  double time(int lane) const;
  /// Returns a lane that is not busy, or -1 if all are.
  int free_lane() const;

  /// Starts a rollout in a lane that is not busy. Throws InputError if the lane is busy, if the job's
  /// scenario is not of this kind, or if lane_law() returns nothing for its gains.
  void start(int lane, LaneJob job);
  /// Computes one control period of every busy lane. Each rollout that ends with this period is passed to
  /// `finished`, which may start another rollout in the same lane. Allocates nothing except for rollouts that
  /// end.
  void step(const Finished& finished);

 private:
  struct Lane;
  const World& world_of(int lane);
  void sense();
  void control();
  /// Replaces the laws' commands by the torques of the drives that follow them.
  void begin_drives();
  void act();
  /// Moves theta to physically valid parameters in the lanes where `adapting` is true and whose gains ask for
  /// it.
  void project(const bool* adapting);
  void move();
  /// Begins the k-th period of the drives in a control period, in the lanes where `moving` is true. Ends the
  /// control period of arms whose velocities are no longer finite; they stop moving.
  void drive(int k, bool* moving);
  void end(int lane, const Finished& finished);

  LaneKind kind_;
  std::unique_ptr<ArmLanes> arms_;
  std::vector<std::unique_ptr<Lane>> lanes_;
  int busy_ = 0;
  bool exact_ = true;
};

}  // namespace armtune::internal
