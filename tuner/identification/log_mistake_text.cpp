#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "tuner/identification/effort_words.hpp"
#include "tuner/identification/log_mistakes.hpp"

namespace armtune::internal {
namespace {

std::string name_of(const RobotModel& model, int joint) {
  return model.joints[static_cast<std::size_t>(joint)].name;
}

std::string effort_of(const RobotModel& model, int joint) {
  return effort_words(model, joint).name;
}

std::string torque_unit_text(const LogMistake& mistake, const RobotModel& model) {
  const bool large = mistake.value < 1.0;
  if (mistake.joint >= 0) {
    return fmt::format(
        "the {} of {} looks 1000 times too {} beside those of the other joints; set its scale to {} in the "
        "column map",
        effort_of(model, mistake.joint), name_of(model, mistake.joint), large ? "large" : "small",
        mistake.value);
  }
  return fmt::format(
      "every {} looks 1000 times too {}, as if logged in {}; set `scale: {}` for `torque` in the column map",
      effort_word_of_all(model, &EffortWords::name), large ? "large" : "small",
      effort_word_of_all(model, large ? &EffortWords::thousandth : &EffortWords::thousandfold),
      mistake.value);
}

/// Returns the sentence for a mistake in the torques alone.
std::string torque_text(const LogMistake& mistake, const RobotModel& model) {
  const std::string any_effort = effort_word_of_all(model, &EffortWords::name);
  switch (mistake.kind) {
    case MistakeKind::kTorqueScale:
      return torque_unit_text(mistake, model);
    case MistakeKind::kAllTorqueSigns:
      return fmt::format(
          "every {} seems to have the wrong sign; set `scale: -1` for `torque` in the column map",
          any_effort);
    case MistakeKind::kTorqueSign:
      return fmt::format("the {} of {} seems to have the wrong sign; set its scale to -1 in the column map",
                         effort_of(model, mistake.joint), name_of(model, mistake.joint));
    case MistakeKind::kNoWeight:
      return fmt::format(
          "every {} seems to lack the part that holds the arm's weight, like a command to a robot that adds "
          "this part itself; log the measured ones",
          any_effort);
    default: {
      const std::string one = effort_of(model, mistake.joint);
      const std::string other = effort_of(model, mistake.other);
      return fmt::format("the {} seem to be exchanged; exchange their columns in the column map",
                         one == other
                             ? fmt::format("{}s of {} and {}", one, name_of(model, mistake.joint),
                                           name_of(model, mistake.other))
                             : fmt::format("{} of {} and the {} of {}", one, name_of(model, mistake.joint),
                                           other, name_of(model, mistake.other)));
    }
  }
}

/// Returns the sentence for a mistake in the positions.
std::string position_text(const LogMistake& mistake, const RobotModel& model) {
  const std::string joint = name_of(model, std::max(0, mistake.joint));
  switch (mistake.kind) {
    case MistakeKind::kDegrees:
      return "the positions seem to be in degrees; set `scale: 0.017453292519943295` for them in the column "
             "map";
    case MistakeKind::kMixedUnits:
      return fmt::format(
          "the position of {} seems to be in degrees and others in radians; set the scale of each in the column "
          "map",
          joint);
    case MistakeKind::kPositionSign:
      return fmt::format(
          "the position of {} seems to have the wrong sign; set its scale to -1 in the column map", joint);
    case MistakeKind::kJointSign:
      return fmt::format(
          "position and {} of {} seem to have the wrong sign; set both scales to -1 in the column map, or "
          "turn the joint's axis in the URDF",
          effort_of(model, mistake.joint), joint);
    case MistakeKind::kPositionOffset:
      return fmt::format(
          "the zero position of {} seems to be wrong: its logged position plus {:.0f} degrees would fit the "
          "robot file; correct the log or the URDF",
          joint, mistake.value * 180.0 / M_PI);
    case MistakeKind::kGearRatio:
      return fmt::format(
          "the gear ratio of {0} seems to be wrong: its position times {1:.3g} and its {2} divided by {1:.3g} "
          "would fit the robot file; set both scales in the column map, or correct the driver",
          joint, mistake.value, effort_of(model, mistake.joint));
    default:
      return fmt::format(
          "the positions of {} and {} seem to be exchanged; exchange their columns in the column map", joint,
          name_of(model, mistake.other));
  }
}

}  // namespace

const char* name(MistakeKind kind) {
  constexpr std::array kNames = {
      "torque_unit", "torque_signs",  "torque_sign", "torques_exchanged", "degrees",
      "mixed_units", "position_sign", "joint_sign",  "position_offset",   "positions_exchanged",
      "gear_ratio",  "mounting",      "no_weight",   "another_arm",       ""};
  return kNames[static_cast<std::size_t>(kind)];
}

std::string to_text(const LogMistake& mistake, const RobotModel& model) {
  switch (mistake.kind) {
    case MistakeKind::kTorqueScale:
    case MistakeKind::kAllTorqueSigns:
    case MistakeKind::kTorqueSign:
    case MistakeKind::kTorquesSwapped:
    case MistakeKind::kNoWeight:
      return torque_text(mistake, model);
    case MistakeKind::kMounting:
      return fmt::format(
          "the arm seems to be mounted differently: gravity would have to point along ({:.0f}, {:.0f}, "
          "{:.0f}) in the base frame; turn the arm's base in the URDF",
          mistake.direction.x() + 0.0, mistake.direction.y() + 0.0, mistake.direction.z() + 0.0);
    case MistakeKind::kAnotherArm:
      return "the log is of another arm, or the masses or the friction in the robot file are far from the "
             "arm's; no single unit, sign, column, zero position or mounting explains it";
    default:
      return position_text(mistake, model);
  }
}

}  // namespace armtune::internal
