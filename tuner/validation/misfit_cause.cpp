#include "tuner/validation/misfit_cause.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>

#include "tuner/validation/residual_moments.hpp"

namespace armtune::internal {
namespace {

/// Largest number of causes; more are not understood by anyone.
constexpr std::size_t kMostCauses = 24;
/// A payload's centre is at most this far from the tool's origin [m].
constexpr double kFarthestCentre = 1.0;
/// A payload below this mass [kg] has no meaningful centre.
constexpr double kLeastMass = 0.01;
/// A slope this near to 1 is no wrong scale.
constexpr double kLeastScale = 0.02;
/// A slope below this says that the prediction has nothing to do with the torque, not that it has another
/// scale.
constexpr double kSmallestScale = 0.2;

/// A cause that may be selected: some of the unknowns of the regression.
struct Candidate {
  CauseKind kind = CauseKind::kOffset;
  int joint = -1;
  int first = 0;
  int count = 1;
};

class Selection {
 public:
  Selection(const RobotModel& model, const ResidualMoments& moments, const ValidationThresholds& thresholds)
      : model_(model), moments_(moments), thresholds_(thresholds) {
    const int n = model.n();
    for (int j = 0; j < n; ++j) {
      const int first = j * kLocalTerms;
      candidates_.push_back({CauseKind::kOffset, j, first, 1});
      candidates_.push_back({CauseKind::kCoulombFriction, j, first + 1, 1});
      candidates_.push_back({CauseKind::kViscousFriction, j, first + 2, 1});
      candidates_.push_back({CauseKind::kRotorInertia, j, first + 3, 1});
      candidates_.push_back({CauseKind::kTorqueScale, j, first + 4, 1});
    }
    candidates_.push_back({CauseKind::kPayload, -1, n * kLocalTerms, 4});
    candidates_.push_back({CauseKind::kGravityDirection, -1, n * kLocalTerms + 4, 3});
    chosen_.assign(candidates_.size(), false);
    refused_.assign(candidates_.size(), false);
  }

  Misfit run() {
    // A candidate that was dropped is not taken up again, so this ends.
    while (order_.size() < kMostCauses && add_best()) drop_useless();
    Misfit misfit;
    const ResidualFit fit = moments_.fit(unknowns(chosen_));
    misfit.left = fit.mean_square.cwiseQuotient(moments_.raw().cwiseMax(kTiny));
    for (const std::size_t c : order_) {
      MisfitCause cause = sized(c, fit.solution);
      cause.share = gain(c, fit).cwiseQuotient(moments_.raw().cwiseMax(kTiny));
      misfit.causes.push_back(std::move(cause));
    }
    return misfit;
  }

 private:
  static constexpr double kTiny = 1e-300;

  std::vector<bool> unknowns(const std::vector<bool>& chosen) const {
    std::vector<bool> used(static_cast<std::size_t>(moments_.unknowns()), false);
    for (std::size_t c = 0; c < chosen.size(); ++c) {
      const auto first = used.begin() + candidates_[c].first;
      if (chosen[c]) std::fill(first, first + candidates_[c].count, true);
    }
    return used;
  }

  /// Returns the mean square that each joint loses by the chosen candidate c, beyond the other chosen ones
  /// (n).
  JointVector gain(std::size_t c, const ResidualFit& with) const {
    std::vector<bool> others = chosen_;
    others[c] = false;
    return moments_.fit(unknowns(others)).mean_square - with.mean_square;
  }

  bool add_best() {
    double least = cost(moments_.fit(unknowns(chosen_)).mean_square);
    std::size_t best = candidates_.size();
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
      if (chosen_[c] || refused_[c]) continue;
      chosen_[c] = true;
      const ResidualFit fit = moments_.fit(unknowns(chosen_));
      const double value = cost(fit.mean_square);
      if (value < least && matters(c, fit)) {
        least = value;
        best = c;
      }
      chosen_[c] = false;
    }
    if (best == candidates_.size()) return false;
    chosen_[best] = true;
    order_.push_back(best);
    return true;
  }

  void drop_useless() {
    for (std::size_t k = 0; k < order_.size();) {
      const std::size_t c = order_[k];
      if (matters(c, moments_.fit(unknowns(chosen_)))) {
        ++k;
        continue;
      }
      chosen_[c] = false;
      refused_[c] = true;
      order_.erase(order_.begin() + static_cast<std::ptrdiff_t>(k));
      k = 0;
    }
  }

  /// Returns twice the negative log-likelihood per row of residuals with these mean squares. Torques that do
  /// not matter are added to the noise, so that they decide nothing.
  double cost(const JointVector& mean_square) const {
    return (mean_square + moments_.floor()).array().log().sum();
  }

  /// Returns true if the chosen candidate c explains enough beyond the others, with a plausible size.
  bool matters(std::size_t c, const ResidualFit& fit) const {
    if (!plausible(sized(c, fit.solution))) return false;
    const JointVector explained = gain(c, fit);
    int joints = 0;
    for (int j = 0; j < model_.n(); ++j) {
      const double torque = thresholds_.cause_torque * thresholds_.cause_torque * moments_.torque()[j];
      joints += explained[j] >= thresholds_.cause_share * moments_.raw()[j] && explained[j] >= torque ? 1 : 0;
    }
    return joints >= (candidates_[c].joint >= 0 ? 1 : std::min(2, model_.n()));
  }

  MisfitCause sized(std::size_t c, const Eigen::VectorXd& solution) const {
    const Candidate& candidate = candidates_[c];
    MisfitCause cause;
    cause.kind = candidate.kind;
    cause.joint = candidate.joint;
    cause.value = solution[candidate.first];
    if (candidate.kind == CauseKind::kTorqueScale) cause.value += 1.0;
    if (candidate.kind == CauseKind::kPayload) {
      const Vec3 center_B = Vec3(solution.segment<3>(candidate.first + 1)) / cause.value;
      cause.vector = model_.chain.R_BT.transpose() * (center_B - model_.chain.p_BT);
    }
    if (candidate.kind == CauseKind::kGravityDirection) {
      const Vec3 fitted = model_.chain.gravity + Vec3(solution.segment<3>(candidate.first));
      cause.vector = fitted;
      cause.value = std::atan2(fitted.cross(model_.chain.gravity).norm(), fitted.dot(model_.chain.gravity));
    }
    return cause;
  }

  bool plausible(const MisfitCause& cause) const {
    switch (cause.kind) {
      case CauseKind::kTorqueScale:
        return std::abs(cause.value - 1.0) >= kLeastScale && std::abs(cause.value) >= kSmallestScale;
      case CauseKind::kPayload:
        return std::abs(cause.value) >= kLeastMass && cause.vector.norm() <= kFarthestCentre;
      case CauseKind::kGravityDirection:
        return gravity_is_plausible(cause);
      default:
        return true;
    }
  }

  bool gravity_is_plausible(const MisfitCause& cause) const {
    const double stated = model_.chain.gravity.norm();
    return std::abs(cause.vector.norm() - stated) <= thresholds_.gravity * stated &&
           cause.value >= thresholds_.tilt * M_PI / 180.0;
  }

  const RobotModel& model_;
  const ResidualMoments& moments_;
  const ValidationThresholds& thresholds_;
  std::vector<Candidate> candidates_;
  std::vector<bool> chosen_, refused_;
  std::vector<std::size_t> order_;
};

}  // namespace

const char* name(CauseKind kind) {
  constexpr std::array kNames = {"offset",       "coulomb_friction", "viscous_friction",  "rotor_inertia",
                                 "torque_scale", "payload",          "gravity_direction", ""};
  return kNames[static_cast<std::size_t>(kind)];
}

Misfit misfit_causes(const RobotModel& model, const TorqueRows& rows,
                     const ValidationThresholds& thresholds) {
  const ResidualMoments moments(rows, thresholds.cause_torque);
  return Selection(model, moments, thresholds).run();
}

}  // namespace armtune::internal
