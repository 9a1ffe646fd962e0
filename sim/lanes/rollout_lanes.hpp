#pragma once
// Rollouts side by side, one per lane, in armtune's own dynamics: each begins and ends on its own and is, to
// the bit, what Rollout makes of it alone with Engine::kNative.

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

/// What may share lanes with a scenario. most_obstacles: at least its own. Throws InputError for
/// the stepper kReference.
LaneKind lane_kind(const Scenario& scenario, Stepper stepper, std::size_t most_obstacles,
                   ArmLawKind law = ArmLawKind::kAdaptive);

/// The law of these gains, where it can be simulated here: those of armtune; others run alone.
std::optional<ArmLawKind> lane_law(const Gains& gains);

struct LaneJob {
  std::shared_ptr<const PreparedScenario> scenario;
  Gains gains;
  EndLimits limits = {};
};

class RolloutLanes {
 public:
  using Finished = std::function<void(int lane, RolloutResult&& result)>;

  /// lanes: how many are wanted, see make_arm_lanes.
  RolloutLanes(const LaneKind& kind, int lanes, Processor processor = best_processor());
  ~RolloutLanes();
  RolloutLanes(const RolloutLanes&) = delete;
  RolloutLanes& operator=(const RolloutLanes&) = delete;

  int lanes() const { return static_cast<int>(lanes_.size()); }
  int busy() const { return busy_; }
  bool is_busy(int lane) const;
  /// How far the rollout in a lane has come [s].
  double time(int lane) const;
  /// A lane that is not busy; -1: none.
  int free_lane() const;

  /// In a lane that is not busy. Throws InputError if it is, if the job's scenario is not of
  /// this kind, or if its controller has no lanes.
  void start(int lane, LaneJob job);
  /// One control period of every lane that is busy. `finished` gets what ends with it; it may start another
  /// rollout in that lane. Allocates nothing but for what ends.
  void step(const Finished& finished);

 private:
  struct Lane;
  const World& world_of(int lane);
  void sense();
  void control();
  void act();
  void move();
  void end(int lane, const Finished& finished);

  LaneKind kind_;
  std::unique_ptr<ArmLanes> arms_;
  std::vector<std::unique_ptr<Lane>> lanes_;
  int busy_ = 0;
  bool exact_ = true;
};

}  // namespace armtune::internal
