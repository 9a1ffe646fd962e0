#include "sim/metrics/metric.hpp"

#include <fmt/format.h>

namespace armtune::internal {

// Tracking errors count in followTrajectory from 1 s after it was entered, outside a slerp; joint errors in
// followPlan; gaze and compensation count always after leaveSingularity, followPlan included; limits count
// always. All from the plant's true state.
const std::array<MetricField, kMetricCount>& metric_fields() {
  using enum Better;
  using enum Course;
  static constexpr std::array<MetricField, kMetricCount> fields{{
      {"error/position/x/max", "m", kLess, kOnlyWorsens, "largest position error in x",
       "largest |x - xd| of the tool while tracking"},
      {"error/position/y/max", "m", kLess, kOnlyWorsens, "largest position error in y",
       "largest |y - yd| of the tool while tracking"},
      {"error/position/z/max", "m", kLess, kOnlyWorsens, "largest position error in z",
       "largest |z - zd| of the tool while tracking"},
      {"error/position/rms", "m", kLess, kEitherWay, "RMS position error",
       "RMS of the tool's distance from its desired position while tracking"},
      {"error/position/max", "m", kLess, kOnlyWorsens, "largest position error",
       "largest distance from the desired position while tracking"},
      {"error/orientation/x/max", "rad", kLess, kOnlyWorsens, "largest orientation error about x",
       "largest |x| of the rotation vector to the gaze orientation while tracking"},
      {"error/orientation/y/max", "rad", kLess, kOnlyWorsens, "largest orientation error about y",
       "largest |y| of that vector"},
      {"error/orientation/z/max", "rad", kLess, kOnlyWorsens, "largest orientation error about z",
       "largest |z| of that vector"},
      {"error/orientation/rms", "rad", kLess, kEitherWay, "RMS orientation error",
       "RMS of the angle to the gaze orientation while tracking"},
      {"error/orientation/max", "rad", kLess, kOnlyWorsens, "largest orientation error",
       "largest angle to the gaze orientation while tracking"},
      {"error/linear_velocity/rms", "m/s", kLess, kEitherWay, "RMS linear velocity error",
       "RMS of |v - vd| of the tool while tracking"},
      {"error/linear_velocity/max", "m/s", kLess, kOnlyWorsens, "largest linear velocity error",
       "largest |v - vd| while tracking"},
      {"error/angular_velocity/rms", "rad/s", kLess, kEitherWay, "RMS angular velocity error",
       "RMS of |w - wd| of the tool while tracking"},
      {"error/angular_velocity/max", "rad/s", kLess, kOnlyWorsens, "largest angular velocity error",
       "largest |w - wd| while tracking"},
      {"samples", "1", kMore, kEitherWay, "tracked periods", "control periods that count as tracking"},
      {"gaze/rms", "rad", kLess, kEitherWay, "RMS gaze angle",
       "RMS angle between the tool's z axis and the line to the target, after leaveSingularity"},
      {"gaze/max", "rad", kLess, kOnlyWorsens, "largest gaze angle", "largest such angle"},
      {"gaze/rate_error/rms", "rad/s", kLess, kEitherWay, "RMS gaze rate error",
       "RMS difference between the turn rates of tool z and of that line"},
      {"gaze/rate_error/max", "rad/s", kLess, kOnlyWorsens, "largest gaze rate error",
       "largest such difference"},
      {"gaze/time_outside_threshold", "s", kLess, kOnlyWorsens, "time with the gaze off its target",
       "time with the gaze angle at or above slerpAngularErrorThreshold"},
      {"reacquisition/time", "s", kLess, kEitherWay, "time to the next target",
       "longest time from a target switch until the gaze angle is below the threshold for good; the whole "
       "time "
       "to the next switch or the end if it never is"},
      {"joint_velocity/max_ratio", "1", kLess, kOnlyWorsens, "largest joint velocity over its limit",
       "largest |q'| over its limit, of any joint, at any time"},
      {"joint_velocity/max_ratio_time", "s", kNeither, kEitherWay, "time of the largest joint velocity",
       "when that was"},
      {"joint_position/min_margin", "rad", kMore, kOnlyWorsens, "smallest distance to a position limit",
       "smallest distance of any joint to a position limit; negative: passed"},
      {"joint_effort/max_ratio", "1", kLess, kOnlyWorsens, "largest torque over its limit",
       "largest commanded |torque| over its limit, before saturation"},
      {"joint_effort/saturated_periods", "1", kLess, kOnlyWorsens, "periods with a saturated joint",
       "control periods in which a joint was commanded more than its effort limit"},
      {"joint_error/rms", "rad", kLess, kEitherWay, "RMS joint error",
       "RMS of q - qd over joints and time while a planned trajectory is followed; empty without one"},
      {"joint_error/max", "rad", kLess, kOnlyWorsens, "largest joint error",
       "largest |q - qd| of any joint while a planned trajectory is followed"},
      {"effort_rate/rms", "N m/s", kLess, kEitherWay, "RMS torque rate",
       "RMS over time of the norm of the change per second of the torque sent, after saturation"},
      {"obstacle/min_clearance", "m", kMore, kOnlyWorsens, "smallest obstacle clearance",
       "smallest distance of any joint origin or the tool, or of any link's surface, to an obstacle's "
       "surface"},
      {"clearance/self", "m", kMore, kOnlyWorsens, "smallest distance between links",
       "smallest distance between two links of the arm, but for neighbours and for links whose shapes meet at nearly "
       "every position; empty without a cell, or where the links' shapes are not known"},
      {"clearance/cell", "m", kMore, kOnlyWorsens, "smallest distance from the cell",
       "smallest distance of any moving link from a part of the cell; empty without one"},
      {"clearance/floor", "m", kMore, kOnlyWorsens, "smallest height above the floor",
       "smallest height of any moving link above the cell's floor; empty without one"},
      {"compensation_error/rms", "N m", kLess, kEitherWay, "RMS compensation error",
       "RMS of |Y (theta_hat - theta)| after leaveSingularity"},
      {"response/rise_time", "s", kLess, kEitherWay, "rise time",
       "time from 10 % to 90 % of the scenario's step, of the tool's position or its gaze; empty without a "
       "step or if it never came to 90 %"},
      {"response/overshoot", "1", kLess, kEitherWay, "overshoot",
       "by how much the response passed the step, over the step's size"},
      {"response/settling_time", "s", kLess, kEitherWay, "settling time",
       "time from the step until the response is within 2 % of the step's size for good; the whole time to "
       "the end if it never is"},
      {"response/steady_state_error", "1", kLess, kEitherWay, "steady-state error",
       "|mean error| over the last tenth of the time after the step, over the step's size"},
      {"response/bandwidth", "Hz", kMore, kEitherWay, "bandwidth",
       "frequency at which the response to the scenario's sines first falls 3 dB below them; the highest "
       "sine's frequency if it never does, the lowest's if it starts below"},
  }};
  return fields;
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
  constexpr double kKnownDepth = 1e-6;  // m: bodies of flat faces only know that they meet (closest.hpp)
  constexpr std::array kTouched = {"an obstacle", "another link of the arm", "a part of the cell",
                                   "the floor"};
  static_assert(kTouched.size() == kContactMetrics.size());
  for (std::size_t i = 0; i < kTouched.size(); ++i) {
    const double clearance = metrics[kContactMetrics[i]];
    if (clearance < -kKnownDepth)
      return fmt::format("comes at least {:.3g} m into {}", -clearance, kTouched[i]);
    if (clearance < 0.0) return fmt::format("touches {}", kTouched[i]);
  }
  return {};
}

}  // namespace armtune::internal
