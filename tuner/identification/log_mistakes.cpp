#include "tuner/identification/log_mistakes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "tuner/identification/effort_words.hpp"

namespace armtune::internal {
namespace {

constexpr double kOneDegree = M_PI / 180.0;
/// Largest share of a joint's torque that the best fitting arm near the robot file may leave unexplained.
/// Friction models and noise leave less.
constexpr double kUnexplained = 0.5;
/// Largest RMS torque that the robot file's own links may leave unexplained, relative to the RMS of all
/// torques. Above it, these links need over twice the logged torque.
constexpr double kOtherArm = 1.2;
/// The corresponding limit for torques that were multiplied or divided by a thousand.
constexpr double kOtherScale = 0.6;
/// A correct log has a lower cost: about 1 with noise and friction, 2 with a tool that is missing in the
/// robot file.
constexpr double kOrdinaryCost = 3.0;
/// Standard deviation of a position [rad, m] above which mistakes in its zero, sign or column can be
/// detected.
constexpr double kLeastDeviation = 0.1;
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
  }

  void try_torques(const ArmMoments& moments) {
    const int n = model_.n();
    TorqueReading turned = TorqueReading::as_logged(n);
    turned.sign *= -1.0;
    take({.kind = MistakeKind::kAllTorqueSigns, .fit = fitter_.fit(moments, turned)});
    for (int j = 0; j < n; ++j) {
      if (!moves(j)) continue;
      TorqueReading reading = TorqueReading::as_logged(n);
      reading.sign[j] = -1.0;
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

  void try_mountings() {
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

  void try_motion(LogMistake mistake, const std::function<void(LogInstant&)>& correct) {
    std::vector<LogInstant> corrected = instants_;
    for (LogInstant& at : corrected) correct(at);
    mistake.fit = fitter_.fit(arm_moments(model_.chain, corrected), TorqueReading::as_logged(model_.n()));
    take(mistake);
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
  // If few joints move, many different zero positions explain the log equally well.
  if (explained && (found.as_logged.cost < kOrdinaryCost || !found.most_joints_move)) return found;
  // Torques that are wrong by a factor of a thousand are never explained by an arm near the robot file's.
  if (!explained) search.try_torque_scales(moments);
  search.try_torques(moments);
  search.try_motions();
  search.try_mountings();
  if (search.best()->fit.cost < kMuchBetter * found.as_logged.cost) {
    found.mistake = search.best();
  } else if (!explained) {
    found.mistake = LogMistake{.fit = found.as_logged};
  }
  return found;
}

std::string to_text(const LogMistake& mistake, const RobotModel& model) {
  const auto name = [&](int joint) { return model.joints[static_cast<std::size_t>(joint)].name; };
  const auto effort = [&](int joint) { return std::string(effort_words(model, joint).name); };
  const std::string any_effort = effort_word_of_all(model, &EffortWords::name);
  switch (mistake.kind) {
    case MistakeKind::kTorqueScale:
      return fmt::format(
          "every {} looks 1000 times too {}, as if logged in {}; set `scale: {}` for `torque` in the column "
          "map",
          any_effort, mistake.value < 1.0 ? "large" : "small",
          effort_word_of_all(model,
                             mistake.value < 1.0 ? &EffortWords::thousandth : &EffortWords::thousandfold),
          mistake.value);
    case MistakeKind::kAllTorqueSigns:
      return fmt::format(
          "every {} seems to have the wrong sign; set `scale: -1` for `torque` in the column map",
          any_effort);
    case MistakeKind::kTorqueSign:
      return fmt::format("the {} of {} seems to have the wrong sign; set its scale to -1 in the column map",
                         effort(mistake.joint), name(mistake.joint));
    case MistakeKind::kTorquesSwapped:
      return fmt::format("the {} seem to be exchanged; exchange their columns in the column map",
                         effort(mistake.joint) == effort(mistake.other)
                             ? fmt::format("{}s of {} and {}", effort(mistake.joint), name(mistake.joint),
                                           name(mistake.other))
                             : fmt::format("{} of {} and the {} of {}", effort(mistake.joint),
                                           name(mistake.joint), effort(mistake.other), name(mistake.other)));
    case MistakeKind::kDegrees:
      return "the positions seem to be in degrees; set `scale: 0.017453292519943295` for them in the column "
             "map";
    case MistakeKind::kPositionSign:
      return fmt::format(
          "the position of {} seems to have the wrong sign; set its scale to -1 in the column map",
          name(mistake.joint));
    case MistakeKind::kJointSign:
      return fmt::format(
          "position and {} of {} seem to have the wrong sign; set both scales to -1 in the column map, or "
          "turn the joint's axis in the URDF",
          effort(mistake.joint), name(mistake.joint));
    case MistakeKind::kPositionOffset:
      return fmt::format(
          "the zero position of {} seems to be wrong: its logged position plus {:.0f} degrees would fit the "
          "robot file; correct the log or the URDF",
          name(mistake.joint), mistake.value / kOneDegree);
    case MistakeKind::kPositionsSwapped:
      return fmt::format(
          "the positions of {} and {} seem to be exchanged; exchange their columns in the column map",
          name(mistake.joint), name(mistake.other));
    case MistakeKind::kMounting:
      return fmt::format(
          "the arm seems to be mounted differently: gravity would have to point along ({:.0f}, {:.0f}, "
          "{:.0f}) in the base frame; turn the arm's base in the URDF",
          mistake.direction.x() + 0.0, mistake.direction.y() + 0.0, mistake.direction.z() + 0.0);
    case MistakeKind::kAnotherArm:
      break;
  }
  return "the log is of another arm, or the masses or the friction in the robot file are far from the arm's; "
         "no single unit, sign, column, zero position or mounting explains it";
}

}  // namespace armtune::internal
