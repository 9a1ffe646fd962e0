#include "sim/cell/clearance_model.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/control/pose_search.hpp"

namespace armtune::internal {
namespace {

constexpr unsigned kPositions = 200;  // joint positions at which a pair of bodies is tested
constexpr unsigned kFewest = 3;       // two links that are free of contact at fewer of these are not checked

/// Returns an upper bound of the motion of any point of the solid per radian or metre of each of the joints
/// first .. body (n) [m/rad, m/m]. It is valid at all positions within the joints' limits. The elements of
/// the other joints are zero.
JointVector levers(const RobotModel& robot, const PlacedSolid& placed, int body, int first) {
  JointVector lever = JointVector::Zero(robot.n());
  double from_origin = farthest(placed, Vec3::Zero());  // largest distance of a point
  for (int i = body; i >= first; --i) {
    const auto k = static_cast<std::size_t>(i);
    const bool slides = robot.chain.motion[k] == JointMotion::kPrismatic;
    const double about_axis = i == body ? farthest_from_z(placed) : from_origin;
    lever[i] = slides ? 1.0 : about_axis;
    const JointLimits& limits = robot.joints[k].limits;
    from_origin += robot.chain.p_PB0[k].norm();
    if (slides) from_origin += std::max(std::abs(limits.lower), std::abs(limits.upper));
  }
  return lever;
}

/// The pose of a solid.
struct Placement {
  Mat3 R;
  Vec3 p;
};

Placement placed(const ArmSolid& solid, const Poses& poses) {
  const PlacedSolid& on = solid.placed;
  if (solid.body < 0) return {on.R_BS, on.p_BS};
  const auto k = static_cast<std::size_t>(solid.body);
  return {poses.R_0B[k] * on.R_BS, poses.p_0B[k] + poses.R_0B[k] * on.p_BS};
}

/// Returns the largest d . x over the points x of a solid at that pose. d: unit vector.
double support(const Solid& solid, const Placement& at, const Vec3& d) {
  return d.dot(at.p) + support(solid, at.R.transpose() * d);
}

}  // namespace

ClearanceModel::ClearanceModel(std::shared_ptr<const RobotModel> robot, Cell cell)
    : robot_(std::move(robot)),
      cell_(std::move(cell)),
      up_(-robot_->chain.gravity.normalized()),
      arm_(arm_solids(*robot_)) {
  add_self_pairs();
  add_cell_pairs();
  add_floor_pairs();
}

bool ClearanceModel::has(Clearance kind) const {
  return std::any_of(pairs_.begin(), pairs_.end(),
                     [kind](const ContactPair& pair) { return pair.of == kind; });
}

ContactPair ClearanceModel::pair(Clearance of, std::size_t solid, std::size_t other) const {
  const ArmSolid& moved = arm_.solids[solid];
  const int first = of == Clearance::kSelf ? arm_.solids[other].body + 1 : 0;
  const JointVector any_way = levers(*robot_, moved.placed, moved.body, first);
  return {of, solid, other, of == Clearance::kFloor ? floor_levers(any_way) : any_way};
}

/// Makes the levers of a pair with the floor smaller. Only vertical motion counts: of a turn about an axis,
/// the part with the sine of the axis' angle to the vertical, and of a slide the part with its cosine. The
/// angle is known up to the first joint that turns about an axis that is not vertical.
JointVector ClearanceModel::floor_levers(JointVector lever) const {
  constexpr double kVertical = 1e-12;
  Mat3 R = Mat3::Identity();
  for (int i = 0; i < robot_->n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    R = R * robot_->chain.R_PB0[k];
    const Vec3 axis = R.col(2);
    if (robot_->chain.motion[k] == JointMotion::kPrismatic) {
      lever[i] *= std::abs(axis.dot(up_));
      continue;
    }
    const double sine = axis.cross(up_).norm();
    lever[i] *= sine;
    if (sine > kVertical) break;
  }
  return lever;
}

bool ClearanceModel::is_free_at(unsigned fewest, const ContactPair& pair, std::vector<Poses>& sampled) const {
  unsigned free = 0;
  for (unsigned sample = 0; sample < kPositions && free < fewest; ++sample) {
    if (sample == sampled.size())
      forward_kinematics(robot_->chain, sample_position(*robot_, sample), sampled.emplace_back());
    if (distance(pair, sampled[sample], Vec3::Zero()).distance > 0.0) ++free;
  }
  return free >= fewest;
}

void ClearanceModel::add_self_pairs() {
  const auto& solids = arm_.solids;
  std::vector<LinkPair> left_out;
  std::vector<Poses> sampled;
  for (std::size_t b = 0; b < solids.size(); ++b) {
    for (std::size_t a = 0; a < b; ++a) {
      if (solids[a].body == solids[b].body) continue;
      const ContactPair both = pair(Clearance::kSelf, b, a);
      if (solids[b].body - solids[a].body > 1 && is_free_at(kFewest, both, sampled)) {
        pairs_.push_back(both);
      } else {
        left_out.push_back({solids[a].link, solids[b].link});
      }
    }
  }
  for (const LinkPair& links : left_out) {
    // If the links have several shapes, another pair of their shapes may be checked.
    const bool looked_at = std::any_of(pairs_.begin(), pairs_.end(), [&](const ContactPair& pair) {
      return solids[pair.other].link == links[0] && solids[pair.solid].link == links[1];
    });
    if (!looked_at && std::find(left_out_.begin(), left_out_.end(), links) == left_out_.end())
      left_out_.push_back(links);
  }
}

void ClearanceModel::add_cell_pairs() {
  for (std::size_t s = 0; s < arm_.solids.size(); ++s) {
    if (arm_.solids[s].body < 0) continue;
    for (std::size_t p = 0; p < cell_.parts.size(); ++p) pairs_.push_back(pair(Clearance::kCell, s, p));
  }
}

void ClearanceModel::add_floor_pairs() {
  if (!cell_.floor) return;
  std::vector<Poses> sampled;
  for (std::size_t s = 0; s < arm_.solids.size(); ++s) {
    const int body = arm_.solids[s].body;
    if (body < 0) continue;
    const ContactPair both = pair(Clearance::kFloor, s, 0);
    // The first link may always touch the floor on which the arm is mounted. It is then not checked.
    if (body > 0 || is_free_at(1, both, sampled)) pairs_.push_back(both);
  }
}

ClearanceModel ClearanceModel::with_obstacles_on(const std::vector<Path>& paths) const {
  ClearanceModel model = *this;
  std::size_t next = 0;
  for (CellPart& part : model.cell_.parts) {
    if (part.is_obstacle) part.path = paths.at(next++);
  }
  return model;
}

ClearanceModel ClearanceModel::without_obstacles() const {
  ClearanceModel model = *this;
  std::erase_if(model.pairs_, [&model](const ContactPair& pair) {
    return pair.of == Clearance::kCell && model.cell_.parts[pair.other].is_obstacle;
  });
  return model;
}

Closest ClearanceModel::distance(const ContactPair& pair, const Poses& poses, const Vec3& at) const {
  const ArmSolid& solid = arm_.solids[pair.solid];
  const auto [R_0S, p_0S] = placed(solid, poses);
  if (pair.of == Clearance::kFloor) {
    const Vec3 down = -(R_0S.transpose() * up_);
    Closest found;
    found.on_a = p_0S + R_0S * extreme_of_core(solid.placed.solid, down) - solid.placed.solid.radius * up_;
    found.distance = up_.dot(found.on_a) - *cell_.floor;
    found.on_b = found.on_a - found.distance * up_;
    found.away = up_;
    return found;
  }
  if (pair.of == Clearance::kCell) {
    const CellPart& part = cell_.parts[pair.other];
    return closest(solid.placed.solid, R_0S, p_0S, part.solid, part.R_0S, at);
  }
  const ArmSolid& other = arm_.solids[pair.other];
  const auto [R_0O, p_0O] = placed(other, poses);
  return closest(solid.placed.solid, R_0S, p_0S, other.placed.solid, R_0O, p_0O);
}

double ClearanceModel::gap(const ContactPair& pair, const Poses& poses, const Vec3& at,
                           const Vec3& away) const {
  const ArmSolid& solid = arm_.solids[pair.solid];
  const double nearest = -support(solid.placed.solid, placed(solid, poses), -away);
  if (pair.of == Clearance::kFloor) return nearest - *cell_.floor;
  if (pair.of == Clearance::kCell) {
    const CellPart& part = cell_.parts[pair.other];
    return nearest - support(part.solid, {part.R_0S, at}, away);
  }
  const ArmSolid& other = arm_.solids[pair.other];
  return nearest - support(other.placed.solid, placed(other, poses), away);
}

double ClearanceModel::most_unseen(double period) const {
  // At any time between, one of the two times is at most half of the period away.
  const JointVector travel = 0.5 * period * robot_->velocity_limits();
  double most = 0.0;
  for (const ContactPair& pair : pairs_) most = std::max(most, pair.lever.dot(travel));
  return most;
}

std::string ClearanceModel::name(const ContactPair& pair) const {
  const std::string& link = arm_.solids[pair.solid].link;
  if (pair.of == Clearance::kFloor) return link + " and the floor";
  return fmt::format(
      "{} and {}", link,
      pair.of == Clearance::kSelf ? arm_.solids[pair.other].link : cell_.parts[pair.other].name);
}

std::vector<std::string> ClearanceModel::left_out_by_their_make() const {
  const auto body_of = [this](const std::string& link) {
    const auto found = std::find_if(arm_.solids.begin(), arm_.solids.end(),
                                    [&link](const ArmSolid& solid) { return solid.link == link; });
    return found->body;
  };
  std::vector<std::string> names;
  for (const auto& [a, b] : left_out_) {
    if (body_of(b) - body_of(a) > 1) names.push_back(fmt::format("{} and {}", a, b));
  }
  return names;
}

}  // namespace armtune::internal
