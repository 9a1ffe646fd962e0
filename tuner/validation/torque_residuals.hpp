#pragma once
// Compares measured torques with those of the unfitted model, joint by joint and by phase of the motion. The
// residual is the measured minus the predicted torque. Its statistics are computed by TorqueMoments, as in
// identification.

#include <optional>
#include <vector>

#include "tuner/validation/torque_rows.hpp"

namespace armtune::internal {

/// Instants at which all joints are slow, so that the torques mainly hold the arm.
struct GravityPhase {
  long rows = 0;
  double rms = 0.0;         ///< of the residual [N m, N]
  double torque_rms = 0.0;  ///< of the measured torque [N m, N]
};

/// Reversals of the joint: its velocity changes sign, and Coulomb friction changes by twice its size.
struct ReversalPhase {
  long count = 0;
  /// Median of the residual's mean after a reversal minus that before it, times the new direction of motion,
  /// divided by two [N m, N]. Above zero, the model lacks friction of about this size.
  double half_step = 0.0;
};

/// Relation of the residual to the acceleration of the joint itself.
struct InertiaPhase {
  double correlation = 0.0;  ///< of the residual with q''
  double slope = 0.0;        ///< of the residual over q'' [kg m^2, kg]
};

struct JointResidual {
  double rms = 0.0;            ///< of the residual [N m, N]
  double torque_rms = 0.0;     ///< of the measured torque [N m, N]
  double predicted_rms = 0.0;  ///< of the predicted torque [N m, N]
  /// Share of the variance explained: 1 - var(residual) / var(measured torque). Both variances are taken
  /// about their own means, so a constant offset does not count. 1 is a perfect model. A model that is worse
  /// than a constant has a negative share. Zero if the measured torque is constant.
  double explained = 0.0;
  GravityPhase gravity;
  ReversalPhase reversals;
  InertiaPhase inertia;
};

struct TorqueResiduals {
  long rows = 0;                     ///< per joint
  std::vector<JointResidual> joint;  ///< n
};

TorqueResiduals torque_residuals(const TorqueRows& rows, const ValidationThresholds& thresholds = {});

/// Returns true for each joint (n) that the model matches: it explains at least `explained` of the torque's
/// variance, or the RMS of the residual is at most `negligible` times the effort limit.
std::vector<bool> matching_joints(const RobotModel& model, const TorqueResiduals& residuals,
                                  const ValidationThresholds& thresholds = {});

}  // namespace armtune::internal
