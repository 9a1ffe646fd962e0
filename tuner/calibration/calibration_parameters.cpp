#include "tuner/calibration/calibration_parameters.hpp"

#include <algorithm>
#include <cmath>

namespace armtune::internal {
namespace {

/// Medians of what the robot file does not give, relative to the limits of the joint.
constexpr double kCoulombShare = 0.01;  ///< of the effort limit
constexpr double kViscousShare = 0.01;  ///< of the effort limit, at the velocity limit
constexpr double kRotorShare = 1e-3;    ///< of the effort limit [s^2]

/// Collects the parameters of an arm.
class ParameterList {
 public:
  explicit ParameterList(const RobotModel& model) : model_(model) {}

  /// Adds the logarithm of a positive value of every joint. fallback(joint): median where the value is zero.
  template <typename Fallback>
  void add_logarithms(ParameterKind kind, const char* what, const char* unit, const JointVector& values,
                      double known, double unknown, Fallback fallback) {
    for (int j = 0; j < model_.n(); ++j) {
      const bool given = values[j] > 0.0;
      const double deviation = given ? known : unknown;
      if (deviation <= 0.0) continue;
      found_.push_back({kind, j, name_of(j, what), unit, true, std::log(given ? values[j] : fallback(j)),
                        deviation, values[j]});
    }
  }
  void add_joints(ParameterKind kind, const char* what, const char* unit, double deviation) {
    for (int j = 0; j < model_.n() && deviation > 0.0; ++j)
      found_.push_back({kind, j, name_of(j, what), unit, false, 0.0, deviation, 0.0});
  }
  void add(ParameterKind kind, const char* name, const char* unit, double deviation) {
    if (deviation > 0.0) found_.push_back({kind, -1, name, unit, false, 0.0, deviation, 0.0});
  }
  std::vector<CalibrationParameter> list() && { return std::move(found_); }

 private:
  std::string name_of(int joint, const char* what) const {
    return model_.joints[static_cast<std::size_t>(joint)].name + "/" + what;
  }

  const RobotModel& model_;
  std::vector<CalibrationParameter> found_;
};

double link_masses(const Chain& chain) {
  double sum = 0.0;
  for (int i = 0; i < chain.n; ++i) sum += chain.link[static_cast<std::size_t>(i)].mass;
  return sum;
}

/// Adds a point mass [kg] at a point of the tool frame [m].
void add_payload(double mass, const Vec3& center_T, Chain& chain) {
  LinkInertia& last = chain.link[static_cast<std::size_t>(chain.n - 1)];
  const Vec3 center = chain.p_BT + chain.R_BT * center_T;
  last.mass += mass;
  last.first_moment += mass * center;
  last.inertia += mass * (center.squaredNorm() * Mat3::Identity() - center * center.transpose());
}

/// What belongs to no single joint.
struct WholeArmValues {
  double mass = 0.0;           ///< of the payload [kg]
  Vec3 center = Vec3::Zero();  ///< of the payload, tool frame [m]
  Vec3 tilt = Vec3::Zero();    ///< small turn of the base [rad]

  void apply(Chain& chain) const {
    // A negative payload may not take more than half of the last link.
    const double last = chain.link[static_cast<std::size_t>(chain.n - 1)].mass;
    add_payload(std::max(mass, -0.5 * last), center, chain);
    // The vector of gravity in the axes of the turned base.
    const double angle = tilt.norm();
    if (angle > 0.0) chain.gravity = Eigen::AngleAxisd(-angle, tilt / angle) * chain.gravity;
  }
};

}  // namespace

double CalibrationParameter::value(double z) const {
  const double x = mean + deviation * z;
  return logarithmic ? std::exp(x) : x;
}

double CalibrationParameter::slope(double z) const {
  return logarithmic ? deviation * value(z) : deviation;
}

std::vector<CalibrationParameter> calibration_parameters(const RobotModel& model, CommandKind kind,
                                                         const CalibrationPriors& priors) {
  using enum ParameterKind;
  const ShootingArm arm = shooting_arm(model);
  const JointVector effort = model.effort_limits();
  const JointVector speed = model.velocity_limits();
  ParameterList list(model);
  const auto add = [&](ParameterKind what, const char* name, const char* unit, const JointVector& values,
                       auto fallback) {
    list.add_logarithms(what, name, unit, values, priors.known, priors.unknown, fallback);
  };
  add(kViscousFriction, "viscous_friction", "N m s/rad, N s/m", model.chain.viscous_friction,
      [&](int j) { return kViscousShare * effort[j] / speed[j]; });
  add(kCoulombFriction, "coulomb_friction", "N m, N", model.chain.coulomb_friction,
      [&](int j) { return kCoulombShare * effort[j]; });
  add(kRotorInertia, "rotor_inertia", "kg m^2, kg", model.chain.rotor_inertia,
      [&](int j) { return kRotorShare * effort[j]; });
  const auto none = [](int) { return 1.0; };
  const auto add_gains = [&](ParameterKind what, const char* name, const char* unit,
                             const JointVector& values) {
    list.add_logarithms(what, name, unit, values, priors.drive_gains, 0.0, none);
  };
  if (kind != CommandKind::kTorque) {
    add_gains(kVelocityGain, "drive_velocity_gain", "N m s/rad, N s/m", arm.model.drive_velocity_gain);
    add_gains(kIntegralGain, "drive_velocity_integral", "N m/rad, N/m", arm.model.drive_velocity_integral);
  }
  if (kind == CommandKind::kPosition)
    add_gains(kPositionGain, "drive_position_gain", "1/s", arm.model.drive_position_gain);
  if (kind == CommandKind::kTorque)
    list.add_logarithms(kTorqueFactor, "torque_factor", "1", JointVector::Ones(model.n()),
                        priors.torque_factor, 0.0, none);
  list.add(kDelay, "delay", "s", priors.delay);
  const double mass = priors.payload * link_masses(model.chain);
  const double center = mass > 0.0 ? priors.payload_center : 0.0;
  list.add(kPayloadMass, "payload/mass", "kg", mass);
  list.add(kPayloadCenterX, "payload/center_x", "m", center);
  list.add(kPayloadCenterY, "payload/center_y", "m", center);
  list.add(kPayloadCenterZ, "payload/center_z", "m", center);
  list.add(kTiltX, "base/tilt_x", "rad", priors.tilt);
  list.add(kTiltY, "base/tilt_y", "rad", priors.tilt);
  list.add_joints(kEncoderOffset, "encoder_offset", "rad, m", priors.encoder_offset);
  return std::move(list).list();
}

ShootingArm arm_at(const ShootingArm& nominal, const std::vector<CalibrationParameter>& parameters,
                   const Eigen::VectorXd& z) {
  ShootingArm arm = nominal;
  Chain& chain = arm.model.chain;
  WholeArmValues whole;
  for (std::size_t i = 0; i < parameters.size(); ++i) {
    const CalibrationParameter& p = parameters[i];
    const double value = p.value(z[static_cast<Eigen::Index>(i)]);
    switch (p.kind) {
      case ParameterKind::kViscousFriction:
        chain.viscous_friction[p.joint] = value;
        break;
      case ParameterKind::kCoulombFriction:
        chain.coulomb_friction[p.joint] = value;
        break;
      case ParameterKind::kRotorInertia:
        chain.rotor_inertia[p.joint] = value;
        break;
      case ParameterKind::kVelocityGain:
        arm.model.drive_velocity_gain[p.joint] = value;
        break;
      case ParameterKind::kIntegralGain:
        arm.model.drive_velocity_integral[p.joint] = value;
        break;
      case ParameterKind::kPositionGain:
        arm.model.drive_position_gain[p.joint] = value;
        break;
      case ParameterKind::kTorqueFactor:
        arm.torque_factor[p.joint] = value;
        break;
      case ParameterKind::kDelay:
        arm.delay = std::max(0.0, value);
        break;
      case ParameterKind::kPayloadMass:
        whole.mass = value;
        break;
      case ParameterKind::kPayloadCenterX:
        whole.center.x() = value;
        break;
      case ParameterKind::kPayloadCenterY:
        whole.center.y() = value;
        break;
      case ParameterKind::kPayloadCenterZ:
        whole.center.z() = value;
        break;
      case ParameterKind::kTiltX:
        whole.tilt.x() = value;
        break;
      case ParameterKind::kTiltY:
        whole.tilt.y() = value;
        break;
      case ParameterKind::kEncoderOffset:
        arm.offset[p.joint] = value;
        break;
    }
  }
  whole.apply(chain);
  return arm;
}

}  // namespace armtune::internal
