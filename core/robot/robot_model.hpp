#pragma once
// An arm: the chain, its names and its limits. Immutable after construction and shared by all workers.

#include <string>
#include <vector>

#include "core/robot/chain.hpp"
#include "core/robot/shape.hpp"
#include "core/robot/urdf_interfaces.hpp"

namespace armtune::internal {

struct JointLimits {
  bool has_position = false;  ///< false for continuous joints
  double lower = 0.0;         ///< [rad, m]
  double upper = 0.0;
  double velocity = 0.0;  ///< largest |q'| [rad/s, m/s]
  double effort = 0.0;    ///< largest |tau| [N m, N]
  bool soft = false;      ///< lower or upper is that of the URDF's safety controller
};

struct JointInfo {
  std::string name;
  std::string link;  ///< the link this joint moves (fixed links beyond it are merged into it)
  JointLimits limits;
  JointInterfaces interfaces = {};  ///< that ros2_control gives it
};

struct RobotModel {
  std::string name;
  std::string source;  ///< the file it came from
  std::string base_link;
  std::string tip_link;  ///< the link the tool frame is given in
  std::vector<JointInfo> joints;
  std::vector<Shape> shapes;  ///< of all links, for drawing; may be empty
  JointVector link_radii;     ///< of each joint's link [m], NaN where not known; empty: none is
  std::vector<std::string>
      estimated_rotors;  ///< joints whose rotor inertia is an estimate (rotor_estimate.hpp)
  /// Whether the robot adds the torque that holds its own weight to what a controller commands that knows no
  /// weight (joint_trajectory_law.hpp). It bears part of the effort limits all the same.
  bool compensates_gravity = false;
  /// Of drives that are commanded velocities (velocity_drive.hpp), (n); empty: not known.
  JointVector drive_velocity_gain, drive_velocity_integral;
  Chain chain;

  int n() const { return chain.n; }
  /// Index of a joint by name. Throws InputError that lists the joints.
  int joint_index(const std::string& joint) const;
  JointVector velocity_limits() const;
  JointVector effort_limits() const;
  /// Infinite for joints without position limits, which are infinitely far from them.
  JointVector lower_limits() const;
  JointVector upper_limits() const;
};

/// Joint positions (n) from [rad, m] to [deg, m], the units of files, and back.
JointVector in_degrees(const RobotModel& model, const JointVector& q);
JointVector in_si(const RobotModel& model, const JointVector& degrees);

/// Names of the joints, in order.
std::vector<std::string> joint_names(const RobotModel& model);

/// A name for every entry of theta, in its order: `upper_arm_link/mass`, `.../mx`, `.../ixx`,
/// `elbow_joint/rotor_inertia`, `.../viscous_friction`, `.../coulomb_friction`.
std::vector<std::string> theta_names(const RobotModel& model);

/// Returns the sum of the distances from the first joint's origin over all other joint origins to the tool's,
/// plus the travel of prismatic joints [m]. The tool's origin is never farther from the first joint's. Where
/// the arm stands does not count.
double reach(const RobotModel& model);

/// The inertia of a body with frame B as seen from frame A: about A's origin, in A's axes. R_AB, p_AB [m]:
/// pose of B in A. Inertias that share a frame add up entry by entry.
LinkInertia in_frame(const LinkInertia& body_B, const Mat3& R_AB, const Vec3& p_AB);

/// A point mass held at the tool: mass [kg] with its centre at `center` [m] in the tool frame.
struct Payload {
  double mass = 0.0;
  Vec3 center = Vec3::Zero();
};

/// The same arm with a payload merged into its last link. Throws InputError if the mass is negative or a
/// number is not finite.
RobotModel with_payload(const RobotModel& model, const Payload& payload);

/// Throws InputError naming link or joint, value and limit if the model cannot be simulated: no joints, too
/// many, non-finite numbers, mass not positive, inertia not physically valid, limits missing or crossed,
/// negative rotor inertia or friction, names that would break a CSV header. The inertia about the centre of
/// mass may miss physical validity by 1e-4 of its largest principal moment: vendors round to five digits.
void validate(const RobotModel& model);

}  // namespace armtune::internal
