#pragma once
// The model of a robot arm: its chain of joints and links, their names and their limits. It does not change
// after construction, so that all threads can share it.

#include <limits>
#include <string>
#include <vector>

#include "core/robot/chain.hpp"
#include "core/robot/shape.hpp"
#include "core/robot/urdf_interfaces.hpp"
#include "core/robot/value_source.hpp"

namespace armtune::internal {

struct JointLimits {
  bool has_position = false;  ///< false for continuous joints
  double lower = 0.0;         ///< [rad, m]
  double upper = 0.0;
  double velocity = 0.0;  ///< largest |q'| [rad/s, m/s]
  double effort = 0.0;    ///< largest |tau| [N m, N]
  bool soft = false;      ///< true if lower or upper is a limit of the URDF's safety controller
  /// largest |q''| [rad/s^2, m/s^2]; infinite if the robot file gives none
  double acceleration = std::numeric_limits<double>::infinity();
};

struct JointInfo {
  std::string name;
  std::string link;  ///< the link that this joint moves; fixed links beyond it are merged into it
  JointLimits limits;
  JointInterfaces interfaces = {};  ///< from ros2_control
};

/// The frame L of a link of the URDF. Links that are fixed to each other belong to one body, but each of them
/// has its own frame L.
struct LinkFrame {
  std::string name;
  int body = -1;                 ///< index of the joint that moves it; -1: the base
  Mat3 R_BL = Mat3::Identity();  ///< orientation in the body frame B (chain.hpp)
  Vec3 p_BL = Vec3::Zero();      ///< origin in B [m]
};

struct RobotModel {
  std::string name;
  std::string source;              ///< the URDF file, for messages
  std::vector<std::string> files;  ///< all files that it was read from: a robot YAML, if any, and the URDF
  std::string base_link;
  std::string tip_link;  ///< the link in which the tool frame is given
  std::vector<JointInfo> joints;
  std::vector<Shape> shapes;  ///< visual and collision shapes of all links; may be empty
  JointVector link_radii;     ///< radius of each joint's link [m], NaN if not known; empty: none is known
  std::vector<std::string>
      estimated_rotors;  ///< joints whose rotor inertia is an estimate (rotor_estimate.hpp)
  ValueSource rotor_source = ValueSource::kGiven;    ///< origin of the rotor inertia of the other joints
  ValueSource viscous_source = ValueSource::kGiven;  ///< origin of the viscous friction
  ValueSource coulomb_source = ValueSource::kGiven;  ///< origin of the Coulomb friction
  /// True if the robot itself adds the torque that holds its weight to the commands of a controller without a
  /// gravity model (joint_trajectory_law.hpp). That torque still counts towards the effort limits.
  bool compensates_gravity = false;
  /// Gains of the joints' drives, n each, for velocity commands (velocity_drive.hpp). Empty: not known.
  JointVector drive_velocity_gain, drive_velocity_integral;
  JointVector
      drive_position_gain;  ///< of the loops in front of them, n [1/s] (joint_drives.hpp); may be empty
  /// Largest change of each drive's torque per second, n [N m/s, N/s], and the delay after which it acts, n
  /// [s] (drive_output.hpp). Empty: no limit, no delay.
  JointVector drive_torque_rate, drive_delay;
  double drive_rate = 0.0;  ///< lowest rate of the drives [Hz]; 0: not known
  Chain chain;
  std::vector<LinkFrame> links;  ///< all links of the arm, in the order of their names; empty without a URDF

  int n() const { return chain.n; }
  /// Returns the index of a joint by name. If no joint has this name, it throws InputError that lists all
  /// joints.
  int joint_index(const std::string& joint) const;
  JointVector velocity_limits() const;
  JointVector effort_limits() const;
  /// Returns the acceleration limits (n) [rad/s^2, m/s^2]; infinite for joints without one.
  JointVector acceleration_limits() const;
  /// Returns the position limits; infinite for joints without them.
  JointVector lower_limits() const;
  JointVector upper_limits() const;
};

/// Converts joint positions (n) from [rad, m] to [deg, m], the units of files, and back.
JointVector in_degrees(const RobotModel& model, const JointVector& q);
JointVector in_si(const RobotModel& model, const JointVector& degrees);

/// Returns the names of the joints, in order.
std::vector<std::string> joint_names(const RobotModel& model);

/// Returns a name for every entry of theta, in its order: `upper_arm_link/mass`, `.../mx`, `.../ixx`,
/// `elbow_joint/rotor_inertia`, `.../viscous_friction`, `.../coulomb_friction`.
std::vector<std::string> theta_names(const RobotModel& model);

/// Returns an upper bound of the distance from the first joint's origin to the tool's origin [m]. The bound
/// is the sum of the distances between neighbouring joint origins and from the last one to the tool, plus the
/// largest displacement of each prismatic joint from zero. The distance from the base frame to the first
/// joint is not included.
double reach(const RobotModel& model);

/// Returns the inertia of a body with frame B, about the origin of frame A and in A's axes. R_AB, p_AB [m]:
/// pose of B in A. Inertias in the same frame can be added entry by entry.
LinkInertia in_frame(const LinkInertia& body_B, const Mat3& R_AB, const Vec3& p_AB);

/// A point mass held at the tool: mass [kg] with its centre at `center` [m] in the tool frame.
struct Payload {
  double mass = 0.0;
  Vec3 center = Vec3::Zero();
};

/// Returns the same arm with a payload merged into its last link. Throws InputError if the mass is negative
/// or a number is not finite.
RobotModel with_payload(const RobotModel& model, const Payload& payload);

/// Throws InputError naming link or joint, value and limit if the model cannot be simulated: no joints or too
/// many, numbers that are not finite, mass not positive, inertia not physically valid, limits missing or
/// crossed, negative rotor inertia or friction, names that would break a CSV header. The inertia about the
/// centre of mass may miss physical validity by 1e-4 of its largest principal moment, since vendors round to
/// five digits.
void validate(const RobotModel& model);

}  // namespace armtune::internal
