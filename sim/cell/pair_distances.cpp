#include "sim/cell/pair_distances.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace armtune::internal {

PairDistances::PairDistances(std::shared_ptr<const ClearanceModel> model)
    : model_(std::move(model)), known_(model_->pairs().size()), parts_(model_->cell().parts.size()) {
  const RobotModel& robot = model_->robot();
  travel_.setConstant(robot.n(), std::numeric_limits<double>::infinity());
  for (int i = 0; i < robot.n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    const JointLimits& limits = robot.joints[k].limits;
    if (robot.chain.motion[k] == JointMotion::kPrismatic)
      travel_[i] = std::max(std::abs(limits.lower), std::abs(limits.upper));
  }
}

void PairDistances::move_to(double time, const JointVector& q) {
  const auto& parts = model_->cell().parts;
  for (std::size_t p = 0; p < parts.size(); ++p) parts_[p] = parts[p].path.at(time).position;
  q_ = &q;
  const bool was_beyond = beyond_;
  beyond_ = !(q.cwiseAbs().array() <= travel_.array()).all();
  placed_ = false;
  // The levers are not valid beyond travel_, nor for the motion back from there.
  if (beyond_ || was_beyond) {
    for (Known& known : known_) known.q.resize(0);
  }
}

double PairDistances::at_least(std::size_t k) const {
  const Known& known = known_[k];
  if (known.q.size() == 0) return -std::numeric_limits<double>::infinity();
  const ContactPair& pair = model_->pairs()[k];
  double lost = pair.lever.dot((*q_ - known.q).cwiseAbs());
  if (pair.of == Clearance::kCell) lost += (parts_[pair.other] - known.at).norm();
  return known.closest.distance - lost;
}

const Closest& PairDistances::compute(std::size_t k) {
  if (!placed_) body_poses(model_->robot().chain, *q_, poses_);
  placed_ = true;
  const ContactPair& pair = model_->pairs()[k];
  Known& known = known_[k];
  known.at = pair.of == Clearance::kCell ? parts_[pair.other] : Vec3::Zero();
  known.q = *q_;
  known.closest = model_->distance(pair, poses_, known.at);
  ++computed_;
  return known.closest;
}

}  // namespace armtune::internal
