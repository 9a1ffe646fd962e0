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
  levers_hold_ = !(beyond_ || was_beyond);
  if (levers_hold_) return;
  for (Known& known : known_) known.q.resize(0);
}

void PairDistances::place() {
  if (!placed_) body_poses(model_->robot().chain, *q_, poses_);
  placed_ = true;
}

Vec3 PairDistances::part_of(const ContactPair& pair) const {
  return pair.of == Clearance::kCell ? parts_[pair.other] : Vec3::Zero();
}

const Mat3& PairDistances::away_frame(const ContactPair& pair) const {
  static const Mat3 kBase = Mat3::Identity();
  if (pair.of != Clearance::kSelf) return kBase;
  const int body = model_->arm().solids[pair.other].body;
  return body < 0 ? kBase : poses_.R_0B[static_cast<std::size_t>(body)];
}

double PairDistances::bound(std::size_t k) const {
  const Known& known = known_[k];
  if (known.q.size() == 0) return -std::numeric_limits<double>::infinity();
  const ContactPair& pair = model_->pairs()[k];
  double lost = pair.lever.dot((*q_ - known.q).cwiseAbs());
  if (pair.of == Clearance::kCell) lost += (parts_[pair.other] - known.at).norm();
  return known.least - lost;
}

bool PairDistances::at_least(std::size_t k, double limit) {
  if (bound(k) >= limit) return true;
  Known& known = known_[k];
  if (known.q.size() == 0) return false;
  place();
  const ContactPair& pair = model_->pairs()[k];
  const Vec3 at = part_of(pair);
  const double gap = model_->gap(pair, poses_, at, away_frame(pair) * known.away);
  if (!(gap >= limit)) return false;
  known.least = gap;
  known.q = *q_;
  known.at = at;
  return true;
}

const Closest& PairDistances::compute(std::size_t k) {
  place();
  const ContactPair& pair = model_->pairs()[k];
  Known& known = known_[k];
  known.at = part_of(pair);
  known.q = *q_;
  closest_ = model_->distance(pair, poses_, known.at);
  known.least = closest_.distance;
  known.away = away_frame(pair).transpose() * closest_.away;
  ++computed_;
  return closest_;
}

}  // namespace armtune::internal
