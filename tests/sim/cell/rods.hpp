#pragma once
// Arms with a shape for every link, and parts of cells.

#include <Eigen/Geometry>
#include <algorithm>

#include "core/robot/robot_model.hpp"
#include "sim/cell/cell.hpp"

namespace armtune::internal::test {

/// The arm with a rod along every link, from its joint to the next one or to the tool, and a box on the last.
inline RobotModel with_rods(RobotModel arm) {
  arm.shapes.clear();
  for (int i = -1; i < arm.n(); ++i) {
    const Vec3 end = i + 1 < arm.n() ? arm.chain.p_PB0[static_cast<std::size_t>(i + 1)] : arm.chain.p_BT;
    Shape rod;
    rod.body = i;
    rod.link = i + 1;
    rod.link_name = i < 0 ? arm.base_link : arm.joints[static_cast<std::size_t>(i)].link;
    rod.collision = true;
    rod.kind = ShapeKind::kCapsule;
    rod.size = {0.03, std::max(1e-3, end.norm()), 0.0};
    rod.p_BS = 0.5 * end;
    if (end.norm() > 1e-3)
      rod.R_BS = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), end).toRotationMatrix();
    arm.shapes.push_back(rod);
  }
  Shape box;
  box.body = arm.n() - 1;
  box.link = arm.n();
  box.link_name = arm.joints.back().link;
  box.collision = true;
  box.kind = ShapeKind::kBox;
  box.size = {0.08, 0.1, 0.05};
  box.p_BS = arm.chain.p_BT;
  arm.shapes.push_back(box);
  return arm;
}

/// A part that rests.
inline CellPart part(const std::string& name, const Solid& solid, const Vec3& center) {
  return {name, solid, Mat3::Identity(), Path{center, 0.0, 0.0, {}}};
}

}  // namespace armtune::internal::test
