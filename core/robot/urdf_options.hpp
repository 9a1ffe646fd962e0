#pragma once
// Options for reading a URDF: which part of it is the arm, and the data that the file does not give.

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/common/types.hpp"
#include "core/robot/shape.hpp"

namespace armtune::internal {

/// Limits of a joint [rad, m, rad/s, m/s, N m, N, rad/s^2, m/s^2]. They replace those of the file, or add
/// limits that the file lacks.
struct GivenLimits {
  std::optional<double> lower, upper, velocity, effort, acceleration = {};
};

/// An inertia that replaces a link's inertial element, in the link's frame.
struct GivenInertia {
  double mass = 0.0;                 ///< [kg]
  Vec3 center = Vec3::Zero();        ///< centre of mass [m]
  Mat3 about_center = Mat3::Zero();  ///< [kg m^2]
};

struct UrdfOptions {
  /// Link that the arm stands on; its frame is frame 0. Empty: the root link. The root link stands upright:
  /// gravity pulls along its -z. If the base is another link, the direction of gravity follows from the
  /// orientation of that link in the root link. Joints between the two are at their held positions, or at
  /// zero if they are not held.
  std::string base_link;
  /// Link in which the tool frame is given and at which the chain of joints ends. Empty: `tool0` if there is
  /// one, else the last moving link.
  std::string tip_link;
  /// Pose of the tool frame in the tip link.
  Mat3 R_tip_T = Mat3::Identity();
  Vec3 p_tip_T = Vec3::Zero();
  std::optional<GivenInertia> tool_inertia;  ///< inertia of the tool at the tip, in the tool frame
  std::vector<Shape> tool_shapes;            ///< shapes of that tool, with poses in the tool frame
  /// Held joints, which are treated as fixed at the given position [rad, m]. Examples are the joints of a
  /// gripper, a mimic joint, or a joint of the arm itself.
  std::map<std::string, double> held;
  std::map<std::string, GivenLimits> limits;    ///< by joint
  std::map<std::string, GivenInertia> inertia;  ///< by link
  /// Shapes that replace a link's collision geometry, by link; poses in the link's frame.
  std::map<std::string, std::vector<Shape>> shapes;
};

/// A link with an inertia that no moving rigid body has, and a proposed replacement.
struct ImpossibleInertia {
  std::string link;
  int joint = 0;         ///< index of the joint that moves the link
  std::string fault;     ///< the impossible value as text, such as "mass -2 kg"
  GivenInertia nearest;  ///< the nearest possible inertia; its mass or its moments are zero if there is none
  double moved = 0.0;    ///< change of the moments, relative to those given (Frobenius norms)

  bool has_moments() const { return !nearest.about_center.isZero(0.0); }
  /// False if the user must give the mass or the moments, because none can be proposed: if the given mass is
  /// negative, or if all given moments are zero.
  bool is_complete() const { return nearest.mass > 0.0 && has_moments(); }
};

/// Data of the arm that are missing or wrong in the file, and that the options do not give either.
struct MissingData {
  std::vector<std::string> position;  ///< joints without position limits, or with two equal ones
  std::vector<std::string> velocity;  ///< joints without a velocity limit
  std::vector<std::string> effort;    ///< joints without an effort limit
  std::vector<std::string> inertia;   ///< moving links without mass, together with the links fixed to them
  std::vector<ImpossibleInertia> impossible;
  bool empty() const {
    return position.empty() && velocity.empty() && effort.empty() && inertia.empty() && impossible.empty();
  }
};

}  // namespace armtune::internal
