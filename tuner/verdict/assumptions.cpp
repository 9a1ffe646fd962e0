#include "tuner/verdict/assumptions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "core/control/laws/cartesian_impedance_law.hpp"
#include "core/control/laws/first_gains.hpp"
#include "core/control/laws/joint_drives.hpp"
#include "core/control/laws/joint_impedance_law.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/position_streaming_law.hpp"
#include "core/control/laws/velocity_drive.hpp"
#include "core/robot/friction.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/plausibility.hpp"

namespace armtune::internal {
namespace {

/// Returns the assumption about rotor inertia that a robot file marks as assumed, compared with the estimate
/// from the joints' limits (rotor_estimate.hpp).
std::string assumed_rotors_text(const RobotModel& robot) {
  RobotModel ruled = robot;
  ruled.chain.rotor_inertia.setZero();
  estimate_rotors(ruled);
  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (int i = 0; i < robot.n(); ++i) {
    if (robot.chain.rotor_inertia[i] == 0.0) continue;
    const double ratio = ruled.chain.rotor_inertia[i] / robot.chain.rotor_inertia[i];
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  return fmt::format(
      "the rotor inertias in {}'s robot file are right (nobody measured them; estimates from effort and velocity "
      "limits are {:.3g} to {:.3g} times as large)",
      robot.name, least, most);
}

/// Returns the assumption about the robot's rotor inertia.
std::string rotors_text(const RobotModel& robot) {
  if (!robot.estimated_rotors.empty()) {
    const bool all = robot.estimated_rotors.size() == static_cast<std::size_t>(robot.n());
    return fmt::format("the rotor inertia of {} is an estimate",
                       all ? "all joints of " + robot.name
                           : fmt::format("{} of {}", fmt::join(robot.estimated_rotors, ", "), robot.name));
  }
  std::vector<std::string> without;
  for (int i = 0; i < robot.n(); ++i) {
    if (robot.chain.rotor_inertia[i] == 0.0)
      without.push_back(robot.joints[static_cast<std::size_t>(i)].name);
  }
  if (without.size() == static_cast<std::size_t>(robot.n())) {
    return fmt::format("{} has no rotor inertia, because its file gives none", robot.name);
  }
  const bool marked = robot.rotor_source != ValueSource::kGiven;
  const std::string given =
      robot.rotor_source == ValueSource::kAssumed
          ? assumed_rotors_text(robot)
          : fmt::format("the {}rotor inertia that {}'s robot file gives",
                        marked ? fmt::format("{} ", name(robot.rotor_source)) : "", robot.name);
  if (without.empty()) return given;
  return fmt::format("no rotor inertia for {} of {} (the robot file gives none), and for the other joints {}",
                     fmt::join(without, ", "), robot.name, given);
}

/// Returns the assumption about the friction that the robot's files give; empty if they give none.
std::string friction_text(const RobotModel& robot) {
  std::vector<std::string> given;
  const auto add = [&given](const char* what, const JointVector& values, ValueSource source) {
    if (values.isZero(0.0)) return;
    given.push_back(source == ValueSource::kGiven ? what : fmt::format("{} {}", name(source), what));
  };
  add("viscous friction", robot.chain.viscous_friction, robot.viscous_source);
  add("Coulomb friction", robot.chain.coulomb_friction, robot.coulomb_source);
  if (given.empty()) return {};
  return fmt::format("the {} that {}'s robot file gives", fmt::join(given, " and the "), robot.name);
}

/// Returns the longest step of the simulated arm [s]. With the drives of a robot, the steps may be shorter.
double longest_step(const Scenario& scenario) {
  return scenario.control_period / steps_in(scenario.control_period, scenario.plant.rate);
}

/// Returns the joints whose friction at rest would make an explicit step of the simulated arm unstable. The
/// condition is h c > 2 d with the step h, the slope c of the friction law, and the inertia d that
/// the joint moves at the start of the scenario.
std::vector<std::string> stiff_joints(const Scenario& scenario, const RobotModel& plant) {
  const JointVector inertia = joint_inertia(plant, scenario.start_position);
  const double step = longest_step(scenario);
  std::vector<std::string> names;
  for (int i = 0; i < plant.n(); ++i) {
    const double slope = plant.chain.viscous_friction[i] + plant.chain.coulomb_friction[i] / kCoulombVelocity;
    if (step * slope > 2.0 * inertia[i]) names.push_back(plant.joints[static_cast<std::size_t>(i)].name);
  }
  return names;
}

/// Returns the parts of the arm from which its distance to obstacles is measured. Returns an empty text if
/// the distance is measured from the arm's shapes, or if no obstacle has a radius.
std::string looked_at_for_obstacles(const Scenario& scenario) {
  const bool bodies = std::any_of(scenario.obstacles.begin(), scenario.obstacles.end(),
                                  [](const MovingObstacle& obstacle) { return obstacle.radius > 0.0; });
  if (!bodies || (scenario.clearance && scenario.clearance->has(Clearance::kCell))) return {};
  return scenario.robot->chain.link_radius.size() > 0 ? "the capsules between the arm's joints and its tool"
                                                      : "the arm's joint origins and its tool";
}

/// Adds the assumptions about the shapes with which contacts are checked.
void add_contact_assumptions(const Scenario& scenario, SimulationVerdict& verdict) {
  if (!scenario.clearance) return;
  const ClearanceModel& model = *scenario.clearance;
  const std::string& robot = scenario.robot->name;
  if (const auto drawn = drawn_links(model.arm()); !drawn.empty())
    add_once(fmt::format(
                 "clearances are measured from the drawn shapes of {} of {}, which have no collision shapes",
                 fmt::join(drawn, ", "), robot),
             verdict.assumes);
  if (!model.arm().unknown.empty())
    add_once(fmt::format("nothing touches {} of {}, whose shapes are missing or unreadable",
                         fmt::join(model.arm().unknown, ", "), robot),
             verdict.assumes);
  for (const std::string& pair : model.left_out_by_their_make())
    add_once(fmt::format("{} do not touch, although their shapes overlap at nearly every position", pair),
             verdict.assumes);
}

/// Names the gains of the position loops in the robots' drives. gain: servo_position_gain [1/s].
std::string position_loops(const std::vector<Scenario>& scenarios, double gain) {
  const bool given = std::any_of(scenarios.begin(), scenarios.end(), [](const Scenario& scenario) {
    return scenario.robot->drive_position_gain.size() > 0;
  });
  if (!given) return fmt::format("a position loop with a gain of {:.3g} /s", gain);
  return fmt::format("position loops with {:.3g} times the gains that the robot's file gives",
                     gain / kDrivePositionGain);
}

}  // namespace

void add_engine_assumption(Engine engine, const std::string& which, SimulationVerdict& verdict) {
  if (engine == Engine::kSimbody) return;
  add_once(fmt::format("armtune's own dynamics for {}, which Simbody did not simulate", which),
           verdict.assumes);
}

void add_controller_assumption(const std::vector<Scenario>& scenarios, const Gains& gains,
                               SimulationVerdict& verdict) {
  for (const std::string kind : {kJointImpedance, kCartesianImpedance}) {
    if (gains.controller != kind) continue;
    const bool any_rate = own(gains, kind + "_torque_rate")[0] == 0.0;
    add_once(fmt::format("{0} as docs/{0}.md describes it: it runs at the scenarios' control period, and the "
                         "torque that holds the arm is computed from theta_start{1}",
                         kind, any_rate ? "; the robot does not limit how fast torques change" : ""),
             verdict.assumes);
  }
  const bool streams = gains.controller == kPositionStreaming;
  if (!streams && !is_joint_trajectory_controller(gains.controller)) return;
  for (const Scenario& scenario : scenarios) {
    const RobotModel& robot = *scenario.robot;
    if (streams || gains.controller == kJointTrajectoryVelocityController)
      add_once(
          robot.drive_velocity_gain.size() > 0
              ? fmt::format(
                    "the drives of {} run at no less than {:.4g} Hz, with the velocity loops that its file gives",
                    robot.name, drive_frequency(robot, scenario.plant.rate))
              : fmt::format(
                    "the drives of {} run at no less than {:.4g} Hz, with velocity loops that have a bandwidth of "
                    "{:.0f} rad/s, because its file gives none",
                    robot.name, drive_frequency(robot, scenario.plant.rate), kDriveRate),
          verdict.assumes);
    if ((streams || gains.controller == kJointTrajectoryVelocityController) && robot.drive_delay.size() == 0)
      add_once(
          fmt::format("delays inside the drives of {} (torque_delay_periods delays the commands to them)",
                      robot.name),
          verdict.not_checked);
    if (robot.compensates_gravity)
      add_once(fmt::format("{} compensates gravity itself, as its file states", robot.name), verdict.assumes);
  }
  if (streams) {
    add_once(
        fmt::format("the model of the robot's servo in docs/position_streaming.md (manufacturers publish "
                    "none), and {}",
                    position_loops(scenarios, own(gains, "servo_position_gain")[0])),
        verdict.assumes);
    return;
  }
  add_once(
      fmt::format(
          "joint_trajectory_controller of {} as docs/joint_trajectory_controller.md describes it: it runs "
          "at the scenarios' control period, interpolates points as the scenario does, and begins every "
          "motion with an empty integral",
          rules_of(jtc_distro(gains)).title),
      verdict.assumes);
}

void add_assumptions(const std::vector<Scenario>& scenarios, Stepper stepper, SimulationVerdict& verdict,
                     bool examine) {
  std::vector<std::string> no_friction;
  std::vector<std::string> no_noise;
  std::vector<std::string> points;
  for (const Scenario& scenario : scenarios) {
    const RobotModel& robot = *scenario.robot;
    add_once(rotors_text(robot), verdict.assumes);
    if (const std::string given = friction_text(robot); !given.empty()) add_once(given, verdict.assumes);
    for (const std::string& doubt : examine ? doubts(robot) : std::vector<std::string>())
      add_once(fmt::format("{}'s robot file is correct, although it looks wrong: {}", robot.name, doubt),
               verdict.assumes);
    add_contact_assumptions(scenario, verdict);
    if (const std::string bodies = looked_at_for_obstacles(scenario); !bodies.empty())
      add_once(fmt::format("in {}, parts of the arm other than {} do not touch an obstacle", scenario.name,
                           bodies),
               verdict.assumes);
    const RobotModel plant = plant_model(scenario);
    const std::vector<std::string> stiff = stiff_joints(scenario, plant);
    if (!stiff.empty() && stepper != Stepper::kReference) {
      add_once(
          fmt::format("in {}, friction stops {} within {:.3g} s, one step of the simulation, so velocity "
                      "peaks may be higher on the real arm than simulated (--stepper reference resolves "
                      "them, but is slow and may need a longer --rollout-deadline)",
                      scenario.name, fmt::join(stiff, ", "), longest_step(scenario)),
          verdict.assumes);
    }
    if (plant.chain.viscous_friction.isZero(0.0) && plant.chain.coulomb_friction.isZero(0.0)) {
      no_friction.push_back(scenario.name);
    }
    if (std::any_of(scenario.obstacles.begin(), scenario.obstacles.end(),
                    [](const MovingObstacle& obstacle) { return obstacle.radius == 0.0; })) {
      points.push_back(scenario.name);
    }
    if (scenario.plant.velocity_noise == 0.0 && scenario.plant.position_noise == 0.0) {
      no_noise.push_back(scenario.name);
    }
  }
  const auto add = [&](const char* what, const std::vector<std::string>& names) {
    if (names.empty()) return;
    const bool all = names.size() == scenarios.size();
    add_once(all ? std::string(what) : fmt::format("{} in {}", what, fmt::join(names, ", ")),
             verdict.assumes);
  };
  for (const std::string& name : points) {
    add_once(fmt::format("obstacles in {} that have no 'radius' are points, which nothing touches", name),
             verdict.assumes);
  }
  add("no joint friction", no_friction);
  add("no sensor noise", no_noise);
  add_once("rigid links and joints, and drives that give every torque up to the effort limits",
           verdict.assumes);
}

}  // namespace armtune::internal
