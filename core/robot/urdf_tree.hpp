#pragma once
// The complete content of a URDF file: all its links and joints. The model of the arm is built from it
// (urdf_arm.hpp).

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/robot/shape.hpp"
#include "core/robot/urdf_interfaces.hpp"

namespace armtune::internal {

enum class UrdfMotion { kFixed, kRevolute, kContinuous, kPrismatic, kOther };

struct UrdfJoint {
  struct Limits {
    double lower = 0.0;  ///< [rad, m]
    double upper = 0.0;
    double velocity = 0.0;  ///< [rad/s, m/s]
    double effort = 0.0;    ///< [N m, N]
    bool soft = false;      ///< true if lower or upper is a limit of a safety controller
  };

  std::string name;
  UrdfMotion motion = UrdfMotion::kFixed;
  std::string parent;  ///< name of the parent link
  std::string child;
  Mat3 R_PL = Mat3::Identity();  ///< pose of the child link's frame in the parent's, at zero
  Vec3 p_PL = Vec3::Zero();
  Vec3 axis = Vec3::Zero();  ///< in the child's frame, as written in the file
  std::optional<Limits> limits;
  double damping = 0.0;        ///< [N m s/rad, N s/m]
  double friction = 0.0;       ///< [N m, N]
  double rotor_inertia = 0.0;  ///< reflected to the joint [kg m^2, kg]
  std::string mimics;          ///< the joint it follows; empty: none
  JointInterfaces interfaces;  ///< from ros2_control
};

struct UrdfInertial {
  double mass = 0.0;                 ///< [kg]
  Mat3 R_LC = Mat3::Identity();      ///< orientation of the inertial frame in the link's
  Vec3 p_LC = Vec3::Zero();          ///< centre of mass [m]
  Mat3 about_center = Mat3::Zero();  ///< in the inertial frame [kg m^2]
};

struct UrdfLink {
  std::string name;
  std::optional<UrdfInertial> inertial;
  std::vector<Shape> shapes;        ///< poses in the link's frame
  std::vector<std::string> joints;  ///< child joints, in the order of their names
};

struct UrdfTree {
  std::string name;
  std::string root;  ///< name of the root link
  std::map<std::string, UrdfLink> links;
  std::map<std::string, UrdfJoint> joints;
};

/// Throws InputError, with a message that begins with `source`, unless exactly one chain of joints leads from
/// the root to each link.
void require_tree(const UrdfTree& tree, const std::string& source);

}  // namespace armtune::internal
