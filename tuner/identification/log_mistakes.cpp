#include "tuner/identification/log_mistakes.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace armtune::internal {
namespace {

constexpr double kOneDegree = M_PI / 180.0;
/// Largest share of a joint's torque that the best fitting arm near the robot file may leave unexplained.
/// Friction models and noise leave less.
constexpr double kUnexplained = 0.5;
/// Largest RMS torque that the robot file's own links may leave unexplained, relative to the RMS of all
/// torques. Above it, these links need over twice the logged torque.
constexpr double kOtherArm = 1.2;
/// Below this share, the links of the robot file are those of the arm. A gear ratio that is 10 % wrong leaves
/// more.
constexpr double kRightFile = 0.05;
/// The corresponding limit for torques that were multiplied or divided by a thousand.
constexpr double kOtherScale = 0.6;
/// A correct log has a lower cost: about 1 with noise and friction, 2 with a tool that is missing in the
/// robot file.
constexpr double kOrdinaryCost = 3.0;
/// Standard deviation of a position [rad, m] above which mistakes in its zero, sign or column can be
/// detected.
constexpr double kLeastDeviation = 0.1;
/// Wrong gear ratios that are tried: powers of this factor, from one half to two. The best is refined.
constexpr double kGearStep = 1.26;
constexpr int kGearSteps = 3;
/// Relative accuracy of a gear ratio.
constexpr double kGearAccuracy = 0.005;
/// Factor on the limits of a joint up to which its positions can be radians.
constexpr double kBeyondLimits = 1.05;
/// A mistake is reported if its correction lowers the cost to less than this share.
constexpr double kMuchBetter = 0.4;

/// Corrects each possible mistake in turn, fits the corrected log, and keeps the mistake of least cost.
class Search {
 public:
  Search(const RobotModel& model, const std::vector<LogInstant>& instants, const JointVector& noise)
      : model_(model), instants_(instants), fitter_(model, noise) {}

  const ArmFitter& fitter() const { return fitter_; }
  const std::optional<LogMistake>& best() const { return best_; }
  bool most_joints_move() const {
    int moving = 0;
    for (int j = 0; j < model_.n(); ++j) moving += moves(j) ? 1 : 0;
    return 2 * moving >= model_.n();
  }

  void try_torque_scales(const ArmMoments& moments) {
    const int n = model_.n();
    for (const double scale : {1e-3, 1e3}) {
      TorqueReading reading = TorqueReading::as_logged(n);
      reading.scale = scale;
      // After scaling, the torques may nearly vanish. An arm that weighs almost nothing would fit them, so
      // the robot file's own links must explain them.
      if (fitter_.fit_joints_only(moments, reading).residual.norm() >
          kOtherScale * scale * std::sqrt(moments.torque_squares.sum()))
        continue;
      take({.kind = MistakeKind::kTorqueScale, .value = scale, .fit = fitter_.fit(moments, reading)});
    }
    for (int j = 0; j < n; ++j) {
      for (const double scale : {1e-3, 1e3}) {
        if (!moves(j)) continue;
        TorqueReading reading = TorqueReading::as_logged(n);
        reading.factor[j] = scale;
        const double torque = scale * std::sqrt(moments.torque_squares[j]);
        if (fitter_.fit_joints_only(moments, reading).residual[j] > kOtherScale * torque) continue;
        take({.kind = MistakeKind::kTorqueScale,
              .joint = j,
              .value = scale,
              .fit = fitter_.fit(moments, reading)});
      }
    }
  }

  void try_torques(const ArmMoments& moments) {
    const int n = model_.n();
    TorqueReading turned = TorqueReading::as_logged(n);
    turned.factor *= -1.0;
    take({.kind = MistakeKind::kAllTorqueSigns, .fit = fitter_.fit(moments, turned)});
    for (int j = 0; j < n; ++j) {
      if (!moves(j)) continue;
      TorqueReading reading = TorqueReading::as_logged(n);
      reading.factor[j] = -1.0;
      take({.kind = MistakeKind::kTorqueSign, .joint = j, .fit = fitter_.fit(moments, reading)});
      for (int k = j + 1; k < n; ++k) {
        if (!moves(k)) continue;
        TorqueReading swapped = TorqueReading::as_logged(n);
        std::swap(swapped.column[static_cast<std::size_t>(j)], swapped.column[static_cast<std::size_t>(k)]);
        take({.kind = MistakeKind::kTorquesSwapped,
              .joint = j,
              .other = k,
              .fit = fitter_.fit(moments, swapped)});
      }
    }
  }

  void try_motions() {
    try_motion({.kind = MistakeKind::kDegrees}, [this](LogInstant& at) {
      for (int j = 0; j < model_.n(); ++j) {
        if (model_.chain.motion[static_cast<std::size_t>(j)] != JointMotion::kRevolute) continue;
        for (JointVector* x : {&at.q, &at.qd, &at.qdd}) (*x)[j] *= kOneDegree;
      }
    });
    for (int j = 0; j < model_.n(); ++j) {
      if (!moves(j)) continue;
      const auto turn = [j](LogInstant& at) {
        for (JointVector* x : {&at.q, &at.qd, &at.qdd}) (*x)[j] *= -1.0;
      };
      try_motion({.kind = MistakeKind::kPositionSign, .joint = j}, turn);
      try_motion({.kind = MistakeKind::kJointSign, .joint = j}, [turn, j](LogInstant& at) {
        turn(at);
        at.torque[j] *= -1.0;
      });
      for (int k = j + 1; k < model_.n(); ++k) {
        if (!moves(k)) continue;
        try_motion({.kind = MistakeKind::kPositionsSwapped, .joint = j, .other = k}, [j, k](LogInstant& at) {
          for (JointVector* x : {&at.q, &at.qd, &at.qdd}) std::swap((*x)[j], (*x)[k]);
        });
      }
      if (model_.chain.motion[static_cast<std::size_t>(j)] != JointMotion::kRevolute) continue;
      for (const int degrees : {30, -30, 45, -45, 60, -60, 90, -90, 180}) {
        const double offset = kOneDegree * degrees;
        try_motion({.kind = MistakeKind::kPositionOffset, .joint = j, .value = offset},
                   [j, offset](LogInstant& at) { at.q[j] += offset; });
      }
    }
  }

  /// Tries whether positions that were read as degrees are in radians, except those that are too large.
  void try_mixed_units() {
    std::vector<bool> radians(static_cast<std::size_t>(model_.n()), false);
    int in_degrees = -1;
    for (int j = model_.n() - 1; j >= 0; --j) {
      if (model_.chain.motion[static_cast<std::size_t>(j)] != JointMotion::kRevolute) continue;
      const JointLimits& limits = model_.joints[static_cast<std::size_t>(j)].limits;
      const double most =
          limits.has_position ? std::max(std::abs(limits.lower), std::abs(limits.upper)) : 2.0 * M_PI;
      double largest = 0.0;
      for (const LogInstant& at : instants_) largest = std::max(largest, std::abs(at.q[j]));
      radians[static_cast<std::size_t>(j)] = largest <= kOneDegree * kBeyondLimits * most;
      if (!radians[static_cast<std::size_t>(j)]) in_degrees = j;
    }
    if (in_degrees < 0 || std::find(radians.begin(), radians.end(), true) == radians.end()) return;
    try_motion({.kind = MistakeKind::kMixedUnits, .joint = in_degrees}, [&](LogInstant& at) {
      for (int j = 0; j < model_.n(); ++j) {
        if (!radians[static_cast<std::size_t>(j)]) continue;
        for (JointVector* x : {&at.q, &at.qd, &at.qdd}) (*x)[j] /= kOneDegree;
      }
    });
  }

  /// Tries gear ratios. Drives compute the position from the motor's by dividing by the ratio, and the torque
  /// by multiplying with it. So a wrong ratio scales both, inversely to each other.
  void try_gear_ratios() {
    LogMistake best;
    best.fit.cost = std::numeric_limits<double>::infinity();
    const auto try_ratio = [&](int joint, double factor) {
      LogMistake mistake = fitted({.kind = MistakeKind::kGearRatio, .joint = joint, .value = factor},
                                  [joint, factor](LogInstant& at) {
                                    for (JointVector* x : {&at.q, &at.qd, &at.qdd}) (*x)[joint] *= factor;
                                    at.torque[joint] /= factor;
                                  });
      if (mistake.fit.cost < best.fit.cost) best = std::move(mistake);
    };
    for (int j = 0; j < model_.n(); ++j) {
      for (int k = -kGearSteps; moves(j) && k <= kGearSteps; ++k) {
        if (k != 0) try_ratio(j, std::pow(kGearStep, k));
      }
    }
    if (best.joint < 0) return;
    for (double step = 0.5 * std::log(kGearStep); step > kGearAccuracy; step *= 0.5) {
      const double middle = best.value;
      for (const double sign : {1.0, -1.0}) try_ratio(best.joint, middle * std::exp(sign * step));
    }
    take(best);
  }

  void try_mountings() {
    Chain floating = model_.chain;
    floating.gravity.setZero();
    take({.kind = MistakeKind::kNoWeight,
          .fit = fitter_.fit(arm_moments(floating, instants_), TorqueReading::as_logged(model_.n()))});
    const double g = model_.chain.gravity.norm();
    for (int axis = 0; axis < 3; ++axis) {
      for (const double sign : {1.0, -1.0}) {
        const Vec3 direction = sign * Vec3::Unit(axis);
        if (direction.dot(model_.chain.gravity) > 0.99 * g) continue;
        Chain chain = model_.chain;
        chain.gravity = g * direction;
        const ArmMoments moments = arm_moments(chain, instants_);
        take({.kind = MistakeKind::kMounting,
              .direction = direction,
              .fit = fitter_.fit(moments, TorqueReading::as_logged(model_.n()))});
      }
    }
  }

 private:
  /// Returns true if the joint's position varies enough. If a joint stands still, its torque can be explained
  /// by some mass with any sign and any zero position.
  bool moves(int joint) const {
    double sum = 0.0;
    double squares = 0.0;
    for (const LogInstant& at : instants_) {
      sum += at.q[joint];
      squares += at.q[joint] * at.q[joint];
    }
    const auto count = static_cast<double>(instants_.size());
    return squares / count - std::pow(sum / count, 2) > kLeastDeviation * kLeastDeviation;
  }

  /// Returns the mistake with the fit of the corrected log.
  LogMistake fitted(LogMistake mistake, const std::function<void(LogInstant&)>& correct) const {
    std::vector<LogInstant> corrected = instants_;
    for (LogInstant& at : corrected) correct(at);
    mistake.fit = fitter_.fit(arm_moments(model_.chain, corrected), TorqueReading::as_logged(model_.n()));
    return mistake;
  }

  void try_motion(const LogMistake& mistake, const std::function<void(LogInstant&)>& correct) {
    take(fitted(mistake, correct));
  }

  void take(const LogMistake& mistake) {
    if (!best_ || mistake.fit.cost < best_->fit.cost) best_ = mistake;
  }

  const RobotModel& model_;
  const std::vector<LogInstant>& instants_;
  ArmFitter fitter_;
  std::optional<LogMistake> best_;
};

/// Returns the RMS of all joints' unexplained torques, as a share of the RMS of all torques.
double all_unexplained(const ArmFit& fit, const ArmMoments& moments) {
  return fit.residual.norm() / std::sqrt(moments.torque_squares.sum());
}

}  // namespace

LogComparison compare_with_robot_file(const RobotModel& model, const std::vector<LogInstant>& instants,
                                      const JointVector& noise) {
  Search search(model, instants, noise);
  const ArmMoments moments = arm_moments(model.chain, instants);
  const TorqueReading as_logged = TorqueReading::as_logged(model.n());
  LogComparison found;
  found.as_logged = search.fitter().fit(moments, as_logged);
  found.robot_file = search.fitter().fit_joints_only(moments, as_logged);
  found.most_joints_move = search.most_joints_move();
  const bool explained = found.as_logged.unexplained.maxCoeff() < kUnexplained &&
                         all_unexplained(found.robot_file, moments) < kOtherArm;
  if (explained && !found.most_joints_move) {
    // Many different zero positions would explain the log equally well. Joints may seem to stand still
    // because their positions were converted from degrees by mistake.
    search.try_mixed_units();
  } else if (explained && found.as_logged.cost < kOrdinaryCost) {
    // Other masses explain the torques of a wrong gear ratio, but not as well as the right ratio.
    if (all_unexplained(found.robot_file, moments) > kRightFile) search.try_gear_ratios();
  } else {
    // Torques that are wrong by a factor of a thousand are never explained by an arm near the robot file's.
    if (!explained) search.try_torque_scales(moments);
    search.try_torques(moments);
    search.try_motions();
    search.try_mixed_units();
    search.try_gear_ratios();
    search.try_mountings();
  }
  if (search.best() && search.best()->fit.cost < kMuchBetter * found.as_logged.cost) {
    found.mistake = search.best();
  } else if (!explained) {
    found.mistake = LogMistake{.fit = found.as_logged};
  }
  return found;
}

}  // namespace armtune::internal
