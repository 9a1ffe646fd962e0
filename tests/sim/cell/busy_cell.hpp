#pragma once
// Arms with shapes, a cell about them, and a motion in which they come near to each other.

#include <memory>
#include <vector>

#include "sim/cell/clearance_model.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tests/core/support/arms.hpp"
#include "tests/core/support/states.hpp"
#include "tests/sim/cell/rods.hpp"

namespace armtune::internal::test {

inline std::vector<std::shared_ptr<const RobotModel>> shaped_arms() {
  std::vector<std::shared_ptr<const RobotModel>> arms;
  for (const RobotModel& arm : all_arms()) arms.push_back(std::make_shared<const RobotModel>(with_rods(arm)));
  for (const char* name : {"ur5e", "fr3", "iiwa14"}) arms.push_back(load_robot(name));
  return arms;
}

/// A table beside the arm, a post, and a ball that goes round.
inline Cell busy_cell() {
  Cell cell;
  cell.floor = -0.3;
  cell.parts.push_back(part("table", box({0.6, 0.8, 0.05}), {0.7, 0.0, -0.1}));
  cell.parts.push_back(part("post", capsule(0.05, 1.0), {-0.5, 0.4, 0.3}));
  cell.parts.push_back(
      {"ball", sphere(0.1), Mat3::Identity(),
       Path{Vec3(0.0, 0.0, 0.8), 1.3, 0.0, {{1, Vec3(0.6, 0.0, 0.0), Vec3(0.0, 0.6, 0.0)}}}});
  return cell;
}

/// Joint positions that swing between the limits, at different speeds.
class Swing {
 public:
  Swing(std::mt19937& generator, const RobotModel& arm)
      : center_(random_configuration(generator, arm)),
        reach_(random_vector(generator, arm.n(), 0.5)),
        pace_(random_vector(generator, arm.n(), 4.0)) {}
  JointVector at(double t) const { return center_ + reach_.cwiseProduct((pace_ * t).array().sin().matrix()); }

 private:
  JointVector center_, reach_, pace_;
};

inline Vec3 place_of(const ClearanceModel& model, const ContactPair& pair, double time) {
  return pair.of == Clearance::kCell ? model.cell().parts[pair.other].path.at(time).position
                                     : Vec3(Vec3::Zero());
}

inline double distance_at(const ClearanceModel& model, const ContactPair& pair, const JointVector& q,
                          double time) {
  return model.distance(pair, poses_at(model.robot().chain, q), place_of(model, pair, time)).distance;
}

}  // namespace armtune::internal::test
