#include "sim/metrics/metric.hpp"

#include <fmt/format.h>

namespace armtune::internal {
namespace {

using enum Better;
using enum Course;

// All metrics are computed from the plant's true state. Tracking errors count in the state followTrajectory,
// from 1 s after its start and outside of slerps. Joint errors count in followPlan, until the plan ends. Gaze
// and compensation errors count in all states except leaveSingularity. Limits always count.
constexpr std::array<MetricField, kMetricCount> kFields{{
    {"error/position/x/max", "m", kLess, kOnlyWorsens, "largest position error in x",
     "largest |x - xd| of the tool while tracking"},
    {"error/position/y/max", "m", kLess, kOnlyWorsens, "largest position error in y",
     "largest |y - yd| of the tool while tracking"},
    {"error/position/z/max", "m", kLess, kOnlyWorsens, "largest position error in z",
     "largest |z - zd| of the tool while tracking"},
    {"error/position/rms", "m", kLess, kEitherWay, "RMS position error",
     "RMS of the tool's distance from its desired position while tracking"},
    {"error/position/max", "m", kLess, kOnlyWorsens, "largest position error",
     "largest distance of the tool from its desired position while tracking"},
    {"error/orientation/x/max", "rad", kLess, kOnlyWorsens, "largest orientation error about x",
     "largest |x| of the rotation vector from the tool's orientation to the desired one, while tracking"},
    {"error/orientation/y/max", "rad", kLess, kOnlyWorsens, "largest orientation error about y",
     "largest |y| of the rotation vector from the tool's orientation to the desired one, while tracking"},
    {"error/orientation/z/max", "rad", kLess, kOnlyWorsens, "largest orientation error about z",
     "largest |z| of the rotation vector from the tool's orientation to the desired one, while tracking"},
    {"error/orientation/rms", "rad", kLess, kEitherWay, "RMS orientation error",
     "RMS of the angle from the tool's orientation to the desired one, while tracking"},
    {"error/orientation/max", "rad", kLess, kOnlyWorsens, "largest orientation error",
     "largest angle from the tool's orientation to the desired one, while tracking"},
    {"error/linear_velocity/rms", "m/s", kLess, kEitherWay, "RMS linear velocity error",
     "RMS of |v - vd| of the tool while tracking"},
    {"error/linear_velocity/max", "m/s", kLess, kOnlyWorsens, "largest linear velocity error",
     "largest |v - vd| while tracking: velocity of the tool minus the desired one"},
    {"error/angular_velocity/rms", "rad/s", kLess, kEitherWay, "RMS angular velocity error",
     "RMS of |w - wd| while tracking: angular velocity of the tool minus the desired one"},
    {"error/angular_velocity/max", "rad/s", kLess, kOnlyWorsens, "largest angular velocity error",
     "largest |w - wd| while tracking: angular velocity of the tool minus the desired one"},
    {"samples", "1", kMore, kEitherWay, "tracked periods",
     "number of control periods in which tracking errors count: the state has been followTrajectory for at "
     "least 1 s, and no slerp (rotation of the tool to another target) is under way"},
    {"gaze/rms", "rad", kLess, kEitherWay, "RMS gaze angle",
     "RMS angle between the tool's z axis and the line to the target, once the arm has left its singular "
     "start pose"},
    {"gaze/max", "rad", kLess, kOnlyWorsens, "largest gaze angle",
     "largest angle between the tool's z axis and the line to the target, once the arm has left its "
     "singular start pose"},
    {"gaze/rate_error/rms", "rad/s", kLess, kEitherWay, "RMS gaze rate error",
     "RMS difference between the angular velocities of the tool's z axis and of the line to the target, "
     "once the arm has left its singular start pose"},
    {"gaze/rate_error/max", "rad/s", kLess, kOnlyWorsens, "largest gaze rate error",
     "largest difference between the angular velocities of the tool's z axis and of the line to the "
     "target, once the arm has left its singular start pose"},
    {"gaze/time_outside_threshold", "s", kLess, kOnlyWorsens, "time with the gaze off its target",
     "total time for which the gaze angle is at least the threshold slerpAngularErrorThreshold"},
    {"reacquisition/time", "s", kLess, kEitherWay, "time to the next target",
     "longest time from a target switch until the gaze angle stays below the gain "
     "slerpAngularErrorThreshold; if it never does, the time until the next switch or the "
     "end of the scenario"},
    {"joint_velocity/max_ratio", "1", kLess, kOnlyWorsens, "largest joint velocity relative to its limit",
     "largest ratio of a joint's |velocity| to its limit, of all joints, at any time"},
    {"joint_velocity/max_ratio_time", "s", kNeither, kEitherWay, "time of the largest joint velocity",
     "time at which joint_velocity/max_ratio occurred"},
    {"joint_position/min_margin", "rad", kMore, kOnlyWorsens, "smallest distance to a position limit",
     "smallest distance of any joint to a position limit; negative if a joint exceeded it"},
    {"joint_effort/rms", "N m", kLess, kEitherWay, "RMS torque",
     "RMS over time of the joint torques after saturation (norm over the joints), including those that "
     "carry the arm's weight"},
    {"joint_effort/max_ratio", "1", kLess, kOnlyWorsens, "largest torque relative to its limit",
     "largest ratio of a joint's commanded |torque| to its limit, before saturation"},
    {"joint_effort/saturated_periods", "1", kLess, kOnlyWorsens, "periods with a saturated joint",
     "number of control periods in which the commanded torque of a joint exceeded its effort limit"},
    {"joint_acceleration/max", "rad/s^2", kLess, kOnlyWorsens, "largest joint acceleration",
     "largest |acceleration| of any joint, at any time: change of its velocity in a control period (or in a "
     "period of the robot's drives), divided by the period; m/s^2 for prismatic joints"},
    {"joint_acceleration/max_ratio", "1", kLess, kOnlyWorsens,
     "largest joint acceleration relative to its limit",
     "largest ratio of a joint's |acceleration| to its limit, of all joints with an acceleration limit in the "
     "robot file, at any time; empty if no joint has one"},
    {"joint_jerk/max", "rad/s^3", kLess, kOnlyWorsens, "largest joint jerk",
     "largest |jerk| of any joint, at any time: change of its acceleration from one control period (or "
     "period of the robot's drives) to the next, divided by the period; m/s^3 for prismatic joints"},
    {"joint_error/rms", "rad", kLess, kEitherWay, "RMS joint error",
     "RMS difference between actual and planned joint positions, over joints and time, while a planned "
     "trajectory is followed; empty without one"},
    {"joint_error/max", "rad", kLess, kOnlyWorsens, "largest joint error",
     "largest difference between actual and planned position of a joint, while a planned trajectory is "
     "followed; empty without one"},
    {"tool_error/rms", "m", kLess, kEitherWay, "RMS tool error on a joint motion",
     "RMS distance of the tool from where the planned joint positions would have it, while a planned "
     "trajectory is followed; empty without one"},
    {"tool_error/max", "m", kLess, kOnlyWorsens, "largest tool error on a joint motion",
     "largest distance of the tool from where the planned joint positions would have it, while a planned "
     "trajectory is followed; empty without one"},
    {"goal/settling_time", "s", kLess, kEitherWay, "time to settle at the goal",
     "time from the end of a planned trajectory until all joints stay within the scenario's goal_tolerance "
     "of the trajectory's last position; if they never do, the time until the scenario ends; "
     "empty unless the arm stays at the end of a planned trajectory"},
    {"goal/overshoot", "rad", kLess, kEitherWay, "overshoot at the goal",
     "largest distance by which a joint passes the last position of a planned trajectory after its end, in "
     "the direction in which the joint approached it; empty unless the arm stays at the end of "
     "a planned trajectory"},
    {"effort_rate/rms", "N m/s", kLess, kEitherWay, "RMS torque rate",
     "RMS over time of the rate of change of the joint torques after saturation (norm over the joints)"},
    {"obstacle/min_clearance", "m", kMore, kOnlyWorsens, "smallest obstacle clearance",
     "smallest distance from the arm (joint origins and tool, or the links' surfaces) to an obstacle's "
     "surface; empty without obstacles"},
    {"clearance/self", "m", kMore, kOnlyWorsens, "smallest distance between links",
     "smallest distance between two links of the arm, except neighbours and links whose shapes overlap at "
     "nearly every position; empty without a cell or without known link shapes"},
    {"clearance/cell", "m", kMore, kOnlyWorsens, "smallest distance from the cell",
     "smallest distance between a moving link and a part of the cell; empty without a cell"},
    {"clearance/floor", "m", kMore, kOnlyWorsens, "smallest height above the floor",
     "smallest height of a moving link above the cell's floor; empty without a floor"},
    {"compensation_error/rms", "N m", kLess, kEitherWay, "RMS compensation error",
     "RMS of |Y (theta_hat - theta)|, the torque error of the controller's arm model, once the arm has "
     "left its singular start pose"},
    {"response/rise_time", "s", kLess, kEitherWay, "rise time",
     "time in which the tool's position or gaze goes from 10 % to 90 % of the scenario's step; empty "
     "without a step, or if 90 % is never reached"},
    {"response/overshoot", "1", kLess, kEitherWay, "overshoot",
     "largest amount by which the response exceeds the step, as a share of the step's size"},
    {"response/settling_time", "s", kLess, kEitherWay, "settling time",
     "time from the step until the response stays within 2 % of the step's size; if it never does, the "
     "time until the end of the scenario"},
    {"response/steady_state_error", "1", kLess, kEitherWay, "steady-state error",
     "|mean error| in the last tenth of the time after the step, as a share of the step's size"},
    {"response/bandwidth", "Hz", kMore, kEitherWay, "bandwidth",
     "frequency at which the response to the scenario's sines first falls 3 dB below them; if it never "
     "does, the highest sine frequency; if it is below already at the lowest sine, the "
     "frequency of that sine"},
}};

}  // namespace

const std::array<MetricField, kMetricCount>& metric_fields() {
  return kFields;
}

std::vector<Metric> all_metrics() {
  std::vector<Metric> metrics;
  for (std::size_t m = 0; m < kMetricCount; ++m) metrics.push_back(static_cast<Metric>(m));
  return metrics;
}

std::optional<Metric> metric_from_name(std::string_view name) {
  const auto& fields = metric_fields();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (name == fields[i].name) return static_cast<Metric>(i);
  }
  return std::nullopt;
}

std::string contact_text(const Metrics& metrics) {
  constexpr double kKnownDepth = 1e-6;  // m: of flat-faced bodies the depth is not known (closest.hpp)
  constexpr std::array kTouched = {"an obstacle", "another link of the arm", "a part of the cell",
                                   "the floor"};
  static_assert(kTouched.size() == kContactMetrics.size());
  for (std::size_t i = 0; i < kTouched.size(); ++i) {
    const double clearance = metrics[kContactMetrics[i]];
    if (clearance < -kKnownDepth)
      return fmt::format("reaches at least {:.3g} m into {}", -clearance, kTouched[i]);
    if (clearance < 0.0) return fmt::format("touches {}", kTouched[i]);
  }
  return {};
}

}  // namespace armtune::internal
