#include "sim/scenario/scenario.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "armtune/error.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/robot/theta.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

/// Multiplies the density of the body by mass_factor, then its inertia about the centre of mass by
/// inertia_factor, and moves the centre by `offset`. A common factor on all principal moments about the
/// centre keeps the body physically possible, wherever its centre is.
LinkInertia varied(const LinkInertia& body, double mass_factor, double inertia_factor, const Vec3& offset) {
  LinkInertia result{mass_factor * body.mass, mass_factor * body.first_moment, mass_factor * body.inertia};
  if (inertia_factor == 1.0 && offset.isZero(0.0))
    return result;  // exact, without the rounding of the shifts below
  const Vec3 c = result.first_moment / result.mass;
  LinkInertia centered = in_frame(result, Mat3::Identity(), -c);
  centered.first_moment.setZero();
  centered.inertia *= inertia_factor;
  return in_frame(centered, Mat3::Identity(), c + offset);
}

void apply_factors(const PlantConditions& plant, Chain& chain) {
  const auto factor = [](const JointVector& factors, int i) { return factors.size() > 0 ? factors[i] : 1.0; };
  for (int i = 0; i < chain.n; ++i) {
    LinkInertia& link = chain.link[static_cast<std::size_t>(i)];
    const Vec3 offset = plant.center_offsets.cols() > 0 ? Vec3(plant.center_offsets.col(i)) : Vec3::Zero();
    link = varied(link, factor(plant.mass_factors, i), factor(plant.inertia_factors, i), offset);
    chain.rotor_inertia[i] *= factor(plant.rotor_factors, i);
  }
}

/// True if the scenario has a control period at or after the end of its planned motion.
bool outlasts_plan(const Scenario& scenario) {
  return scenario.start_time + (scenario.periods() - 1) * scenario.control_period >= scenario.planned->end();
}

}  // namespace

Gains with_goal(Gains gains, const Scenario& scenario) {
  if (scenario.loop_gain != 1.0) scale_loop_gains(gains, scenario.loop_gain);
  if (gains.joint_space_goal.size() > 0) return gains;
  if (scenario.goal_position.size() == 0) {
    // A planned motion comes first and leads into the task. The state leaveSingularity never occurs.
    if (scenario.planned) {
      gains.joint_space_goal = in_degrees(*scenario.robot, scenario.start_position);
      return gains;
    }
    throw InputError(
        InputPlace{scenario.source.empty() ? scenario.name : scenario.source, 0, "start_position_deg"},
        "the scenario has a start_position_deg, but the gains have no joint_space_goal; give "
        "joint_space_goal too, or remove start_position_deg, and armtune computes both")
        .with_value({}, "joint_space_goal in the gains");
  }
  gains.joint_space_goal = in_degrees(*scenario.robot, scenario.goal_position);
  return gains;
}

int Scenario::periods() const {
  return static_cast<int>(std::llround(duration / control_period));
}

bool Scenario::has_task() const {
  return !planned || (!holds_end && outlasts_plan(*this));
}

bool Scenario::holds_goal() const {
  return holds_end && outlasts_plan(*this);
}

bool Scenario::switches_target() const {
  // A planned motion can begin at a switch, so that the target before the first period counts.
  const std::size_t before = active_target(std::max(0.0, start_time - control_period));
  for (int k = 0; k < periods(); ++k) {
    if (active_target(start_time + k * control_period) != before) return true;
  }
  return false;
}

std::size_t Scenario::active_target(double t) const {
  // With a tolerance of half a period, the rounding of k * dt does not decide on which side of a switch t is.
  const double now = t + 0.5 * control_period;
  if (!schedule.empty()) {
    const auto next = std::upper_bound(schedule.begin(), schedule.end(), now,
                                       [](double time, const TargetTurn& turn) { return time < turn.at; });
    return next == schedule.begin() ? 0 : std::prev(next)->target;
  }
  if (switch_every <= 0.0 || targets.size() < 2) return 0;
  return static_cast<std::size_t>(now / switch_every) % targets.size();
}

double Scenario::next_switch(double t) const {
  const double now = t + 0.5 * control_period;
  if (!schedule.empty()) {
    const auto next = std::upper_bound(schedule.begin(), schedule.end(), now,
                                       [](double time, const TargetTurn& turn) { return time < turn.at; });
    return next == schedule.end() ? std::numeric_limits<double>::infinity() : next->at;
  }
  if (switch_every <= 0.0 || targets.size() < 2) return std::numeric_limits<double>::infinity();
  return (std::floor(now / switch_every) + 1.0) * switch_every;
}

RobotModel plant_model(const Scenario& scenario) {
  RobotModel bare = scenario.plant.arm ? *scenario.plant.arm : *scenario.robot;
  apply_factors(scenario.plant, bare.chain);
  RobotModel plant = with_payload(bare, scenario.plant.payload);
  if (scenario.plant.viscous_friction.size() > 0) {
    plant.chain.viscous_friction += scenario.plant.viscous_friction;
  }
  if (scenario.plant.coulomb_friction.size() > 0) {
    plant.chain.coulomb_friction += scenario.plant.coulomb_friction;
  }
  return plant;
}

namespace {

ParameterVector theta_from_file(const std::string& file, const RobotModel& robot) {
  const yaml::Node root = yaml::parse_file(file);
  yaml::MapReader map(root);
  const auto names = theta_names(robot);
  ParameterVector theta(static_cast<Eigen::Index>(names.size()));
  Eigen::Index i = 0;
  for (const std::string& entry : names) theta[i++] = map.number(entry);
  map.finish();
  return theta;
}

}  // namespace

ParameterVector start_theta(const Scenario& scenario) {
  ParameterVector theta = scenario.theta.file.empty()
                              ? ParameterVector(scenario.theta.model_scale * theta_of(scenario.robot->chain))
                              : scenario.theta.given;
  for (Eigen::Index i = 0; i < scenario.theta.factors.size(); ++i) {
    theta.segment<kLinkParameters>(i * kLinkParameters) *= scenario.theta.factors[i];
    theta.segment<kJointParameters>(joint_parameter_index(scenario.robot->n(), static_cast<int>(i))) *=
        scenario.theta.factors[i];
  }
  return theta;
}

void start_theta_from(const std::string& file, Scenario& scenario) {
  scenario.theta = {0.0, file, {}, theta_from_file(file, *scenario.robot)};
  scenario.inputs.push_back(file);
}

}  // namespace armtune::internal
