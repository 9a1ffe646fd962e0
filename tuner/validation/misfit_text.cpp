#include "tuner/validation/misfit_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace armtune::internal {
namespace {

/// Returns a clause about a quantity that the model has too little or too much of.
std::string missing_or_extra(const char* sign, const char* quantity, double value, const char* unit) {
  return value >= 0.0 ? fmt::format("the residual follows {}, so {} of about {:.2g} {} is missing", sign,
                                    quantity, value, unit)
                      : fmt::format("the residual opposes {}, so the model has about {:.2g} {} too much {}",
                                    sign, -value, unit, quantity);
}

std::string payload_text(const MisfitCause& cause) {
  const Vec3& c = cause.vector;
  return fmt::format(
      "a mass at the tool explains it: about {:.2g} kg with its centre at ({:.2f}, {:.2f}, {:.2f}) m in the tool "
      "frame {}",
      std::abs(cause.value), c.x(), c.y(), c.z(),
      cause.value >= 0.0 ? "are missing" : "are too much in the model");
}

}  // namespace

std::string to_text(const MisfitCause& cause, const RobotModel& model) {
  const bool turns =
      cause.joint < 0 || model.chain.motion[static_cast<std::size_t>(cause.joint)] == JointMotion::kRevolute;
  switch (cause.kind) {
    case CauseKind::kOffset:
      return fmt::format("the measured torque has a constant offset of about {:.2g} {}", cause.value,
                         turns ? "N m" : "N");
    case CauseKind::kCoulombFriction:
      return missing_or_extra("the sign of the velocity", "Coulomb friction", cause.value,
                              turns ? "N m" : "N");
    case CauseKind::kViscousFriction:
      return missing_or_extra("the velocity", "viscous friction", cause.value, turns ? "N m s" : "N s/m");
    case CauseKind::kRotorInertia:
      // Sensors behind the gear measure the torque of the links alone.
      return missing_or_extra("the acceleration", "rotor inertia", cause.value, turns ? "kg m^2" : "kg") +
             (cause.value < 0.0 ? ", or the torques were measured behind the gear" : "");
    case CauseKind::kTorqueScale:
      return fmt::format(
          "the measured torque is about {:.2f} times the predicted one; check torque constant and gear ratio",
          cause.value);
    case CauseKind::kPayload:
      return payload_text(cause);
    case CauseKind::kGravityDirection: {
      const Vec3 direction = cause.vector.normalized();
      return fmt::format(
          "gravity along ({:.2f}, {:.2f}, {:.2f}) in the base frame explains it, {:.0f} degrees from the robot "
          "file's; check the mounting",
          direction.x(), direction.y(), direction.z(), cause.value * 180.0 / M_PI);
    }
  }
  return {};
}

std::string joint_text(const RobotModel& model, int joint, const JointResidual& residual,
                       const Misfit& misfit, double least_share) {
  const double percent = 100.0 * residual.explained;
  std::string text =
      fmt::format("{}: {:.{}f} % explained", model.joints[static_cast<std::size_t>(joint)].name, percent,
                  percent > 99.0 ? 1 : 0);
  for (const MisfitCause& cause : misfit.causes) {
    // A cause in another joint can change this one's residual through those of the whole arm.
    const bool own = cause.joint < 0 || cause.joint == joint;
    if (own && cause.share[joint] >= least_share) text += "; " + to_text(cause, model);
  }
  return text;
}

}  // namespace armtune::internal
