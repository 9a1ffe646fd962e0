#include "sim/scenario/arm_distribution.hpp"

#include <algorithm>
#include <cmath>

#include "core/control/laws/joint_drives.hpp"
#include "sim/scenario/uniform.hpp"

namespace armtune::internal {
namespace {

/// Changes the seed, so that these numbers are others than those of perturbation.cpp.
constexpr std::uint64_t kDistributionDraws = 0xC2B2AE3D27D4EB4FU;
constexpr double kLongestDelay = 1000.0;  ///< control periods

bool is_of_drives(const ArmParameter& p) {
  using enum ArmParameterKind;
  return p.kind == kVelocityGain || p.kind == kIntegralGain || p.kind == kPositionGain;
}

/// Adds a point mass [kg], which may be negative, at a point of the tool frame [m].
void add_point_mass(double mass, const Vec3& center_T, Chain& chain) {
  LinkInertia& last = chain.link[static_cast<std::size_t>(chain.n - 1)];
  const Vec3 center = chain.p_BT + chain.R_BT * center_T;
  last.mass += mass;
  last.first_moment += mass * center;
  last.inertia += mass * (center.squaredNorm() * Mat3::Identity() - center * center.transpose());
}

/// The values that belong to no single joint.
struct WholeArm {
  Payload payload;
  Payload in_robot_file;
  Vec3 tilt = Vec3::Zero();  ///< small turn of the base [rad]

  void set(const ArmParameter& p, double value) {
    const auto given = [&](double& now, double& before) {
      now = value;
      before = p.robot_file.value_or(0.0);
    };
    switch (p.kind) {
      case ArmParameterKind::kPayloadMass:
        given(payload.mass, in_robot_file.mass);
        break;
      case ArmParameterKind::kPayloadCenterX:
        given(payload.center.x(), in_robot_file.center.x());
        break;
      case ArmParameterKind::kPayloadCenterY:
        given(payload.center.y(), in_robot_file.center.y());
        break;
      case ArmParameterKind::kPayloadCenterZ:
        given(payload.center.z(), in_robot_file.center.z());
        break;
      case ArmParameterKind::kTiltX:
        tilt.x() = value;
        break;
      case ArmParameterKind::kTiltY:
        tilt.y() = value;
        break;
      default:
        break;
    }
  }

  void apply(Chain& chain) const {
    add_point_mass(-in_robot_file.mass, in_robot_file.center, chain);
    add_point_mass(std::max(0.0, payload.mass), payload.center, chain);
    // Gravity in the axes of the turned base.
    const double angle = tilt.norm();
    if (angle > 0.0) chain.gravity = Eigen::AngleAxisd(-angle, tilt / angle) * chain.gravity;
  }
};

/// Friction that the scenario adds to that of the model, or null.
JointVector* added_friction(ArmParameterKind kind, PlantConditions& plant) {
  if (kind == ArmParameterKind::kViscousFriction) return &plant.viscous_friction;
  return kind == ArmParameterKind::kCoulombFriction ? &plant.coulomb_friction : nullptr;
}

/// Gives the robot's drives the gains of the arm. They are part of the robot, not of the controller.
void give_drives(const RobotModel& arm, Scenario& scenario) {
  RobotModel robot = *scenario.robot;
  robot.drive_velocity_gain = arm.drive_velocity_gain;
  robot.drive_velocity_integral = arm.drive_velocity_integral;
  robot.drive_position_gain = arm.drive_position_gain;
  scenario.robot = std::make_shared<const RobotModel>(std::move(robot));
}

}  // namespace

JointVector* joint_values_of(ArmParameterKind kind, RobotModel& model) {
  switch (kind) {
    case ArmParameterKind::kViscousFriction:
      return &model.chain.viscous_friction;
    case ArmParameterKind::kCoulombFriction:
      return &model.chain.coulomb_friction;
    case ArmParameterKind::kRotorInertia:
      return &model.chain.rotor_inertia;
    case ArmParameterKind::kVelocityGain:
      return &model.drive_velocity_gain;
    case ArmParameterKind::kIntegralGain:
      return &model.drive_velocity_integral;
    case ArmParameterKind::kPositionGain:
      return &model.drive_position_gain;
    default:
      return nullptr;
  }
}

RobotModel with_drive_gains(const RobotModel& model) {
  RobotModel filled = model;
  const DriveGains gains = drive_gains(model);
  filled.drive_velocity_gain = gains.gain;
  filled.drive_velocity_integral = gains.integral;
  if (model.drive_position_gain.size() == 0)
    filled.drive_position_gain = JointVector::Constant(model.n(), kDrivePositionGain);
  return filled;
}

Eigen::VectorXd drawn_parameters(const ArmDistribution& distribution, std::uint64_t seed,
                                 std::uint64_t sample) {
  const auto n = static_cast<Eigen::Index>(distribution.parameters.size());
  std::mt19937_64 generator = generator_of(seed ^ kDistributionDraws, sample);
  Eigen::VectorXd z(n);
  for (double& number : z) number = standard_normal(generator);
  Eigen::VectorXd values(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const ArmParameter& p = distribution.parameters[static_cast<std::size_t>(i)];
    // The sum is a loop, so that its rounding does not depend on the processor.
    double x = p.mean;
    for (Eigen::Index k = 0; k <= i; ++k) x += distribution.factor(i, k) * z[k];
    values[i] = p.logarithmic ? std::exp(x) : x;
  }
  return values;
}

void give_parameters(const ArmDistribution& distribution, const Eigen::VectorXd& values, Scenario& scenario) {
  const auto& parameters = distribution.parameters;
  PlantConditions& plant = scenario.plant;
  const bool drives = std::any_of(parameters.begin(), parameters.end(), is_of_drives);
  const RobotModel& own = plant.arm ? *plant.arm : *scenario.robot;
  RobotModel arm = drives ? with_drive_gains(own) : own;
  WholeArm whole;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const ArmParameter& p = parameters[i];
    const double value = values[static_cast<Eigen::Index>(i)];
    if (JointVector* of_joints = joint_values_of(p.kind, arm)) {
      (*of_joints)[p.joint] = value;
      JointVector* added = added_friction(p.kind, plant);
      if (added != nullptr && added->size() > 0) (*added)[p.joint] = 0.0;
    } else if (p.kind == ArmParameterKind::kDelay) {
      const double periods = std::clamp(value / scenario.control_period, 0.0, kLongestDelay);
      plant.torque_delay_periods = static_cast<int>(std::lround(periods));
    } else if (p.kind == ArmParameterKind::kEncoderOffset) {
      if (plant.encoder_offset.size() == 0) plant.encoder_offset.setZero(arm.n());
      plant.encoder_offset[p.joint] = value;
      scenario.start_position[p.joint] += value;
    } else {
      whole.set(p, value);
    }
  }
  whole.apply(arm.chain);
  if (drives) give_drives(arm, scenario);
  plant.arm = std::make_shared<const RobotModel>(std::move(arm));
}

}  // namespace armtune::internal
