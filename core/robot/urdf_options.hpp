#pragma once
// What is taken out of a URDF as the arm, and what the file does not say.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/common/types.hpp"
#include "core/robot/shape.hpp"

namespace armtune::internal {

/// In place of what the file says of a joint, or where it says nothing. [rad, m, rad/s, m/s, N m, N]
struct GivenLimits {
  std::optional<double> lower, upper, velocity, effort;
};

/// In place of a link's inertial element, in the link's frame.
struct GivenInertia {
  double mass = 0.0;                 ///< [kg]
  Vec3 center = Vec3::Zero();        ///< of mass [m]
  Mat3 about_center = Mat3::Zero();  ///< [kg m^2]
};

struct UrdfOptions {
  /// Link that the arm stands on, whose frame is frame 0. Empty: the root link, which stands upright: gravity
  /// pulls along its -z, and another base feels it as it stands in the tree, with held joints where they are
  /// held and others at zero.
  std::string base_link;
  /// Link that the tool frame is given in and that the chain of joints ends at. Empty: `tool0` if there is
  /// one, else the last moving link.
  std::string tip_link;
  /// Tool frame in the tip link.
  Mat3 R_tip_T = Mat3::Identity();
  Vec3 p_tip_T = Vec3::Zero();
  std::optional<GivenInertia> tool_inertia;  ///< of what is mounted at the tip, in the tool frame
  std::vector<Shape> tool_shapes;            ///< of it, poses in the tool frame
  /// Joints that are held where they are, as if they were fixed there [rad, m]: a gripper's, a mimic's, an
  /// arm's own.
  std::map<std::string, double> held;
  std::map<std::string, GivenLimits> limits;    ///< by joint
  std::map<std::string, GivenInertia> inertia;  ///< by link
  /// In place of a link's collision geometry, by link; poses in the link's frame.
  std::map<std::string, std::vector<Shape>> shapes;
};

/// A link whose inertia no rigid body has, and a proposal for it.
struct ImpossibleInertia {
  std::string link;
  GivenInertia nearest;
  double moved = 0.0;  ///< its distance from what is given, as a share of that (Frobenius norms)
};

/// What the arm needs and neither the file nor the options say, or say wrongly.
struct MissingData {
  std::vector<std::string> position;  ///< joints without position limits, or with two equal ones
  std::vector<std::string> velocity;  ///< joints without a velocity limit
  std::vector<std::string> effort;    ///< joints without an effort limit
  std::vector<std::string> inertia;   ///< links that move and have no mass, with what is fixed to them
  std::vector<ImpossibleInertia> impossible;
  bool empty() const {
    return position.empty() && velocity.empty() && effort.empty() && inertia.empty() && impossible.empty();
  }
};

}  // namespace armtune::internal
