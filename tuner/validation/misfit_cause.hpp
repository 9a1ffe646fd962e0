#pragma once
// Finds likely causes of the difference between measured torques and those of the unfitted model, with their
// sizes. The residual of joint j is regressed on what a robot file may have wrong:
//   r_j = offset_j + Fc_j sign(q_j') + Fv_j q_j' + D_j q_j'' + (scale_j - 1) predicted_j
//         + payload terms (m, m c) + gravity terms (change of the vector of gravity).
// The first five belong to one joint, the last two to the whole arm. Outliers are weighted down (Huber).
// Causes are selected one after the other by the decrease of the residuals (stepwise regression: Efroymson,
// Multiple regression analysis, 1960), and kept only if no other selected cause explains the same.

#include <vector>

#include "tuner/validation/torque_residuals.hpp"

namespace armtune::internal {

enum class CauseKind {
  kOffset,           ///< value: constant torque that the model lacks [N m, N]
  kCoulombFriction,  ///< value: Coulomb friction that the model lacks [N m, N]
  kViscousFriction,  ///< value: viscous friction that the model lacks [N m s, N s/m]
  kRotorInertia,     ///< value: rotor inertia that the model lacks [kg m^2, kg]
  kTorqueScale,      ///< value: measured torque over the model's torque, such as of a wrong torque constant
  kPayload,  ///< value: mass that the model lacks at the tool [kg]; vector: its centre in the tool frame [m]
  kGravityDirection,  ///< value: angle between fitted and stated gravity [rad]; vector: fitted gravity, base
                      ///< frame [m/s^2]
};

/// Returns the kind as a word for files, such as "coulomb_friction".
const char* name(CauseKind kind);

struct MisfitCause {
  CauseKind kind = CauseKind::kOffset;
  int joint = -1;      ///< -1: the whole arm
  double value = 0.0;  ///< below zero: the model has too much of it
  Vec3 vector = Vec3::Zero();
  /// Share of every joint's mean square residual that this cause explains beyond all other causes found (n).
  JointVector share = {};
};

struct Misfit {
  std::vector<MisfitCause>
      causes;        ///< in the order in which they were found: those that explain most come first
  JointVector left;  ///< share of every joint's mean square residual that all causes together leave (n)
};

/// Finds the causes. Each explains at least `cause_share` of the mean square residual of some joint, of two
/// joints if it belongs to the whole arm, and a torque of at least `cause_torque` of that joint's RMS torque.
Misfit misfit_causes(const RobotModel& model, const TorqueRows& rows,
                     const ValidationThresholds& thresholds = {});

}  // namespace armtune::internal
