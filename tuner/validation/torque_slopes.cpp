#include "tuner/validation/torque_slopes.hpp"

#include <algorithm>
#include <cmath>

#include "tuner/validation/residual_moments.hpp"

namespace armtune::internal {
namespace {

/// A payload of more than this share of the arm's moved mass is none: arms carry at most about a third.
constexpr double kMostPayload = 0.5;
constexpr int kFewestLoaded = 2;

/// Returns true if a payload that an arm can carry explains a part of the misfit.
bool has_payload(const RobotModel& model, const Misfit& misfit) {
  double mass = 0.0;
  for (const LinkInertia& link : model.chain.link) mass += link.mass;
  for (const MisfitCause& cause : misfit.causes) {
    if (cause.kind == CauseKind::kPayload && cause.value > 0.0 && cause.value <= kMostPayload * mass)
      return true;
  }
  return false;
}

}  // namespace

JointVector torque_slopes(const TorqueRows& rows, const ValidationThresholds& thresholds) {
  const ResidualMoments moments(rows, thresholds.cause_torque);
  const auto n = static_cast<Eigen::Index>(rows.joint.size());
  std::vector<bool> own(static_cast<std::size_t>(moments.unknowns()), false);
  std::fill(own.begin(), own.begin() + n * kLocalTerms, true);
  const ResidualFit fit = moments.fit(own);
  JointVector slopes(n);
  for (Eigen::Index j = 0; j < n; ++j) slopes[j] = 1.0 + fit.solution[j * kLocalTerms + kLocalTerms - 1];
  return slopes;
}

bool suggests_another_arm(const RobotModel& model, const TorqueRows& rows, const Misfit& misfit,
                          const std::vector<bool>& matches, const ValidationThresholds& thresholds) {
  const JointVector slopes = torque_slopes(rows, thresholds);
  const JointVector effort = model.effort_limits();
  int loaded = 0;
  int lighter = 0;
  int heavier = 0;
  for (int j = 0; j < model.n(); ++j) {
    const auto joint = static_cast<std::size_t>(j);
    const double predicted =
        rows.joint[joint].col(kPredictedTorque).norm() / std::sqrt(static_cast<double>(rows.count()));
    if (predicted < thresholds.loaded * effort[j]) continue;
    ++loaded;
    if (matches[joint]) continue;
    lighter += slopes[j] > 0.0 && slopes[j] < thresholds.other_arm ? 1 : 0;
    heavier += slopes[j] > 1.0 / thresholds.other_arm ? 1 : 0;
  }
  const auto enough = [loaded](int count) { return count >= kFewestLoaded && 2 * count >= loaded; };
  return enough(lighter) || (enough(heavier) && !has_payload(model, misfit));
}

}  // namespace armtune::internal
