// The drives of the arms in lanes. They are those of one arm (joint_drives.hpp), computed arm by arm, as
// sensors and metrics are, because all of these need the state of each arm in every period of the drives.
// Only the dynamics between two periods are computed for all arms at once.

#include <cmath>

#include "sim/lanes/rollout_lane.hpp"

namespace armtune::internal {

void RolloutLanes::begin_drives() {
  bool some_weigh = false;
  for (const auto& lane : lanes_) some_weigh = some_weigh || (lane && lane->drives->needs_weight());
  if (some_weigh) arms_->weigh();
  for (int l = 0; l < lanes(); ++l) {
    Lane* lane = lanes_[static_cast<std::size_t>(l)].get();
    if (lane == nullptr) continue;
    if (lane->drives->needs_weight()) arms_->weight(l, lane->weight.data());
    JointVector& commanded = lane->logic.output().commanded;
    lane->drives->begin(commanded, lane->running.measured(), lane->weight);
    lane->drives->torque(lane->running.measured(), commanded);
  }
}

void RolloutLanes::drive(int k, bool* moving) {
  const double step = kind_.control_period / (kind_.drive_steps * kind_.plant_steps);
  for (int l = 0; l < lanes(); ++l) {
    if (!moving[l]) continue;
    Lane& lane = *lanes_[static_cast<std::size_t>(l)];
    arms_->moved(l, lane.q.data(), lane.qd.data());
    if (!std::isfinite(lane.qd.sum())) {
      moving[l] = false;
      lane.running.moved(lane.q, lane.qd, {});
      continue;
    }
    DriveInstant& at = lane.running.begin_drive_period(k * kind_.plant_steps * step, lane.q, lane.qd);
    lane.drives->next(lane.running.measured_by_drives(), at.commanded, at.torque);
    arms_->push(l, at.torque.data());
  }
}

}  // namespace armtune::internal
