#include "core/control/gain_fields.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// Returns the field of a number from 0 to below 1, which a gains file may leave out.
constexpr GainField share(const char* name, const char* meaning, double Gains::*member) {
  GainField field{name, "1", meaning, member, false};
  field.below = 1.0;
  return field;
}

constexpr GainField of_law(GainField field) {
  field.of_law = true;
  return field;
}

constexpr GainField in_loop(GainField field) {
  field.loop = LoopGain::kFactor;
  return field;
}

constexpr auto kFactor = SearchRange::kFactor;
constexpr GainField kFields[] = {
    {"joint_space_gains_p", "1/s",
     "Kp of the joint space law, per joint; this law acts in the states leaveSingularity and followPlan",
     &Gains::joint_space_gains_p},
    {"joint_space_gains_d", "N m s/rad", "Kd of the joint space law, per joint", &Gains::joint_space_gains_d},
    in_loop(of_law({"task_space_gains_p", "1/s", "Kp of the Cartesian law: x y z, then rotation about x y z",
                    &Gains::task_space_gains_p, true, false, kFactor, 1.0 / 6.0, 6.0})),
    of_law({"task_space_gains_i", "1/s^2", "Ki of the Cartesian law: x y z, then rotation about x y z",
            &Gains::task_space_gains_i, true, false, SearchRange::kCriticalDamping}),
    in_loop(of_law({"task_space_gains_d", "N m s/rad",
                    "Kd on S, the difference between measured and reference joint velocity, per joint",
                    &Gains::task_space_gains_d, true, false, kFactor, 1.0 / 6.0, 6.0})),
    {"force_control_gains", "N",
     "repulsive force of an obstacle at zero distance on each joint origin (or link)",
     &Gains::force_control_gains},
    {"obstacleInfluenceRadius", "m", "distance below which an obstacle repels joint origins (or links)",
     &Gains::obstacleInfluenceRadius, true, true},
    {"joint_space_goal", "deg",
     "joint angles at the end of the state leaveSingularity (metres for prismatic joints); if absent, "
     "armtune computes them from the task",
     &Gains::joint_space_goal, false},
    {"joint_trajectory_duration", "s", "time from the start pose to joint_space_goal",
     &Gains::joint_trajectory_duration, true, true},
    {"trajectoryDurationErrorGain", "s/m", "duration of a return to the path, per metre of distance",
     &Gains::trajectoryDurationErrorGain, true, true, kFactor, 1.0 / 6.0, 3.0},
    {"slerpDurationErrorGain", "s/rad",
     "duration of a rotation of the tool towards a target, per radian of angle",
     &Gains::slerpDurationErrorGain, true, true, kFactor, 0.1, 3.0},
    {"slerpAngularErrorThreshold", "rad",
     "threshold of the gaze metrics; if slerp_start_angle is 0, also the gaze error above which the tool "
     "rotates towards the target by interpolation (slerp)",
     &Gains::slerpAngularErrorThreshold, true, true},
    of_law({"interpolation_gain_scale", "1",
            "factor on the rotational Kp, and on Kd of the last three joints, during a slerp",
            &Gains::interpolation_gain_scale, false}),
    of_law({"adaptation_gain", "1", "adaptation rate gamma in theta <- theta - gamma Y^T S dt",
            &Gains::adaptation_gain, false}),
    {"manipulability_threshold", "m^3", "manipulability below which the damped inverse is used",
     &Gains::manipulability_threshold, false},
    {"manipulability_damping", "m^2", "damping psi in the damped inverse J^T (J J^T + psi I)^-1",
     &Gains::manipulability_damping, false, true},
    {"joint_centering_gain", "1/s",
     "rate at which joints move to the middle of their limits, as far as the task leaves them free; 0: off",
     &Gains::joint_centering_gain, false},
    {"roll_centering_gain", "1/s",
     "rate at which the tool rolls about its z axis to bring the last joint to the middle of its limits; "
     "0: off",
     &Gains::roll_centering_gain, false},
    share("slerp_start",
          "value of the interpolation parameter at the start of a slerp (0.2 in the code of the published "
          "controller)",
          &Gains::slerp_start),
    {"release_radius", "m",
     "obstacle avoidance ends when every joint origin (or link) is at least this far from every obstacle; "
     "0: the value of obstacleInfluenceRadius",
     &Gains::release_radius, false},
    {"slerp_reference", "",
     "orientation from which a slerp interpolates: the tool's orientation at the start of the slerp "
     "('start'), or its present one ('current')",
     &Gains::slerp_reference, false},
    of_law({"adapt_while_avoiding", "", "whether the model parameters theta adapt during obstacle avoidance",
            &Gains::adapt_while_avoiding, false}),
    {"variable_damping", "",
     "whether the damping psi grows from zero as the manipulability falls below manipulability_threshold; "
     "otherwise psi has its full value whenever the manipulability is below that threshold",
     &Gains::variable_damping, false},
    {"gaze_feedforward", "",
     "whether the desired angular velocity includes the rotation of the line from tool to target; "
     "otherwise it is zero outside slerps, as published",
     &Gains::gaze_feedforward, false},
    {"slerp_start_angle", "rad",
     "gaze error above which a slerp starts; 0: the gain slerpAngularErrorThreshold is used in its place",
     &Gains::slerp_start_angle, false},
    {"joint_goal_follows_task", "",
     "whether the state leaveSingularity ends in motion along the path, with the gaze on the target; "
     "otherwise it ends at rest in joint_space_goal",
     &Gains::joint_goal_follows_task, false},
    share("velocity_margin",
          "largest reference joint velocity |qr'|, as a share of the velocity limit; faster references are "
          "slowed; 0: off",
          &Gains::velocity_margin),
    share("velocity_barrier_start",
          "share of the velocity limit above which the velocity barrier damps a joint",
          &Gains::velocity_barrier_start),
    {"velocity_barrier_gain", "1",
     "damping that the velocity barrier adds at the velocity limit, as a multiple of Kd; from "
     "velocity_barrier_start on it grows from zero to this value; 0: no barrier",
     &Gains::velocity_barrier_gain, false},
    of_law({"adaptation_leakage", "1/s", "rate at which theta returns to its start value",
            &Gains::adaptation_leakage, false}),
    of_law({"adaptation_inertia_leakage", "1/s", "rate added to adaptation_leakage for the inertias in theta",
            &Gains::adaptation_inertia_leakage, false}),
    of_law({"adaptation_filter", "Hz",
            "corner frequency of the low-pass filter on the velocities and accelerations in the regressor "
            "Y of the adaptation; 0: no filter",
            &Gains::adaptation_filter, false}),
    of_law({"adaptation_projection", "",
            "whether theta is kept physically possible: masses and inertias of real bodies, no negative "
            "friction",
            &Gains::adaptation_projection, false}),
};

template <typename G>
auto numbers_of(G& gains, const GainField& field) {
  using Number = std::conditional_t<std::is_const_v<G>, const double, double>;
  return std::visit(
      [&gains](auto member) -> std::span<Number> {
        if constexpr (std::is_same_v<decltype(member), OwnGain>) {
          if (member.place >= gains.own.size()) return {};
          auto& own = gains.own[member.place];
          return {own.data(), static_cast<std::size_t>(own.size())};
        } else {
          using Value = std::remove_cvref_t<decltype(gains.*member)>;
          if constexpr (std::is_same_v<Value, double>) {
            return {&(gains.*member), 1};
          } else if constexpr (std::is_same_v<Value, Vec6> || std::is_same_v<Value, JointVector> ||
                               std::is_same_v<Value, ForceGains>) {
            return {(gains.*member).data(), static_cast<std::size_t>((gains.*member).size())};
          } else {
            return {};
          }
        }
      },
      field.member);
}

}  // namespace

const std::vector<GainField>& gain_fields() {
  static const std::vector<GainField> fields(std::begin(kFields), std::end(kFields));
  return fields;
}

std::span<double> numbers(Gains& gains, const GainField& field) {
  return numbers_of(gains, field);
}
std::span<const double> numbers(const Gains& gains, const GainField& field) {
  return numbers_of(gains, field);
}

Eigen::Index size_of(GainShape shape, int n) {
  switch (shape) {
    case GainShape::kTask:
      return 6;
    case GainShape::kJoints:
      return n;
    case GainShape::kScalar:
      break;
  }
  return 1;
}

std::vector<std::string> component_names(const GainField& field, const std::vector<std::string>& joints) {
  const auto* own = std::get_if<OwnGain>(&field.member);
  const auto is = [own](GainShape shape) { return own != nullptr && own->shape == shape; };
  if (std::holds_alternative<Vec6 Gains::*>(field.member) || is(GainShape::kTask)) {
    return {"x", "y", "z", "rx", "ry", "rz"};
  }
  if (std::holds_alternative<JointVector Gains::*>(field.member) || is(GainShape::kJoints)) return joints;
  if (std::holds_alternative<ForceGains Gains::*>(field.member)) return joints;
  return {""};
}

std::vector<std::string> component_names(const Gains& gains, const GainField& field,
                                         const std::vector<std::string>& joints) {
  const auto* force = std::get_if<ForceGains Gains::*>(&field.member);
  if (force == nullptr || !is_per_joint(gains.**force, static_cast<int>(joints.size()))) {
    return component_names(field, joints);
  }
  std::vector<std::string> names;
  names.reserve(joints.size() * joints.size());
  for (const std::string& point : joints) {
    for (const std::string& joint : joints) names.push_back(fmt::format("{}/{}", point, joint));
  }
  return names;
}

}  // namespace armtune::internal
