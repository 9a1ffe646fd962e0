#include "core/control/gain_fields.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"

namespace armtune::internal {
namespace {

/// A number in 0 .. 1, 1 excluded, that a gains file may leave out.
GainField share(const char* name, const char* meaning, double Gains::*member) {
  GainField field{name, "1", meaning, member, false};
  field.below = 1.0;
  return field;
}

GainField of_law(GainField field) {
  field.of_law = true;
  return field;
}

GainField in_loop(GainField field) {
  field.in_loop = true;
  return field;
}

std::vector<GainField> make_fields() {
  constexpr auto kFactor = SearchRange::kFactor;
  return {
      {"joint_space_gains_p", "1/s", "Kp of the joint space law (leaveSingularity and followPlan), per joint",
       &Gains::joint_space_gains_p},
      {"joint_space_gains_d", "N m s/rad", "Kd of the joint space law, per joint",
       &Gains::joint_space_gains_d},
      in_loop(
          of_law({"task_space_gains_p", "1/s", "Kp of the Cartesian law: x y z, then rotation about x y z",
                  &Gains::task_space_gains_p, true, false, kFactor, 1.0 / 6.0, 6.0})),
      of_law({"task_space_gains_i", "1/s^2", "Ki of the Cartesian law: x y z, then rotation about x y z",
              &Gains::task_space_gains_i, true, false, SearchRange::kCriticalDamping}),
      in_loop(of_law({"task_space_gains_d", "N m s/rad", "Kd on the joint space error S, per joint",
                      &Gains::task_space_gains_d, true, false, kFactor, 1.0 / 6.0, 6.0})),
      {"force_control_gains", "N",
       "repulsive force of an obstacle at zero distance, per joint origin or link",
       &Gains::force_control_gains},
      {"obstacleInfluenceRadius", "m", "distance below which an obstacle repels joint origins, or links",
       &Gains::obstacleInfluenceRadius, true, true},
      {"joint_space_goal", "deg",
       "joint angles at the end of leaveSingularity (metres for prismatic joints); if absent, armtune "
       "computes them from the task",
       &Gains::joint_space_goal, false},
      {"joint_trajectory_duration", "s", "time from the start pose to joint_space_goal",
       &Gains::joint_trajectory_duration, true, true},
      {"trajectoryDurationErrorGain", "s/m", "duration of a return to the path, per metre of distance",
       &Gains::trajectoryDurationErrorGain, true, true, kFactor, 1.0 / 6.0, 3.0},
      {"slerpDurationErrorGain", "s/rad", "duration of a turn to a target, per radian of angle",
       &Gains::slerpDurationErrorGain, true, true, kFactor, 0.1, 3.0},
      {"slerpAngularErrorThreshold", "rad",
       "gaze error above which a turn is interpolated (slerp), unless slerp_start_angle is set; also the "
       "threshold of the gaze metrics",
       &Gains::slerpAngularErrorThreshold, true, true},
      of_law({"interpolation_gain_scale", "1",
              "factor on Kp of the rotations and on Kd of the last three joints during a slerp",
              &Gains::interpolation_gain_scale, false}),
      of_law({"adaptation_gain", "1", "adaptation rate gamma in theta <- theta - gamma Y^T S dt",
              &Gains::adaptation_gain, false}),
      {"manipulability_threshold", "m^3", "manipulability below which the damped inverse is used",
       &Gains::manipulability_threshold, false},
      {"manipulability_damping", "m^2", "damping psi in the damped inverse J^T (J J^T + psi I)^-1",
       &Gains::manipulability_damping, false, true},
      {"joint_centering_gain", "1/s",
       "rate at which joints move to the middle of their limits, as far as the task leaves them free; 0: no "
       "such motion",
       &Gains::joint_centering_gain, false},
      {"roll_centering_gain", "1/s",
       "rate at which the tool rolls about its z axis until the last joint is in the middle of its limits; "
       "0: no roll",
       &Gains::roll_centering_gain, false},
      share("slerp_start", "interpolation parameter at the start of a slerp (0.2 in the released code)",
            &Gains::slerp_start),
      {"release_radius", "m",
       "avoidance ends when every joint origin, or link, is at least this far from every obstacle; 0: "
       "obstacleInfluenceRadius",
       &Gains::release_radius, false},
      {"slerp_reference", "",
       "orientation from which a slerp interpolates: that at its start ('start') or the present one "
       "('current')",
       &Gains::slerp_reference, false},
      of_law({"adapt_while_avoiding", "", "whether theta adapts in avoidObstacles",
              &Gains::adapt_while_avoiding, false}),
      {"variable_damping", "",
       "whether psi grows from zero below manipulability_threshold, instead of switching on at its full "
       "value",
       &Gains::variable_damping, false},
      {"gaze_feedforward", "",
       "whether the desired orientation has the angular velocity of the line from tool to target; without "
       "this it is at rest outside slerps, as published",
       &Gains::gaze_feedforward, false},
      {"slerp_start_angle", "rad",
       "gaze error above which a slerp starts; 0: slerpAngularErrorThreshold, as published",
       &Gains::slerp_start_angle, false},
      {"joint_goal_follows_task", "",
       "whether leaveSingularity ends on the moving path and gaze, instead of at rest in joint_space_goal",
       &Gains::joint_goal_follows_task, false},
      share("velocity_margin",
            "the reference is slowed to keep every |qr'| below this share of its velocity limit; 0: not "
            "slowed",
            &Gains::velocity_margin),
      share("velocity_barrier_start", "share of its velocity limit above which the barrier damps a joint",
            &Gains::velocity_barrier_start),
      {"velocity_barrier_gain", "1",
       "damping of the velocity barrier at the limit, as a multiple of Kd; it grows from zero at "
       "velocity_barrier_start; 0: no barrier",
       &Gains::velocity_barrier_gain, false},
      of_law({"adaptation_leakage", "1/s", "rate at which theta returns to its start value",
              &Gains::adaptation_leakage, false}),
      of_law({"adaptation_inertia_leakage", "1/s",
              "rate added to adaptation_leakage for the inertias in theta",
              &Gains::adaptation_inertia_leakage, false}),
      of_law({"adaptation_filter", "Hz",
              "corner frequency of the low-pass filter for the motion in the adaptation; 0: no filter",
              &Gains::adaptation_filter, false}),
      of_law({"adaptation_projection", "",
              "whether theta is kept physically possible: masses and inertias of real bodies, no negative "
              "friction",
              &Gains::adaptation_projection, false}),
  };
}

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
  static const std::vector<GainField> fields = make_fields();
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
