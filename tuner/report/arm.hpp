#pragma once
// An arm as the replay draws it: joints, limits, shapes.

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"

namespace armtune::report {

struct Pose {
  Vec3 p = Vec3::Zero();  ///< [m]
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  bool operator==(const Pose&) const = default;
};

struct ArmJoint {
  std::string name;
  bool prismatic = false;
  Pose pose;  ///< of its frame in the previous joint's at q = 0; it moves about or along its z
  double velocity_limit = 0.0;  ///< [rad/s, m/s]
  double effort_limit = 0.0;    ///< [N m, N]
  std::optional<double> lower;  ///< [rad, m]
  std::optional<double> upper;
  bool operator==(const ArmJoint&) const = default;
};

struct ArmShape {
  int joint = -1;  ///< -1: the base
  Pose pose;       ///< in that joint's frame
  std::string kind;
  std::vector<double> size;  ///< as data.ts says
  std::string triangles;     ///< of a mesh: base64 of singles, nine per triangle
  bool operator==(const ArmShape&) const = default;
};

struct Arm {
  std::string name;
  std::vector<ArmJoint> joints;
  std::vector<ArmShape> shapes;
  std::size_t undrawn = 0;  ///< shapes of the URDF that could not be drawn
  Pose tool;                ///< in the last joint's frame
  bool operator==(const Arm&) const = default;
};

/// Shapes as the URDF has them: of each link what is to be seen, else what is to collide. Meshes that cannot
/// be loaded, or of which an arm has too many triangles, are left out; a moving link with no shape gets
/// capsules between joint origins.
Arm arm_of(const RobotModel& model);

/// Takes the meshes out and draws links that have no other shape as capsules. Returns the bytes of text that
/// this saves.
std::size_t draw_without_meshes(Arm& arm);

}  // namespace armtune::report
