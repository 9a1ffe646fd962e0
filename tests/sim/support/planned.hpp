#pragma once
// Planned trajectories as files, made without a planner: a quintic in every joint, at knots.

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "core/control/joint_space_law.hpp"
#include "core/robot/robot_model.hpp"
#include "core/trajectory/linear_acceleration.hpp"
#include "sim/csv/cell.hpp"

namespace armtune::internal::test {

/// From rest to rest.
struct QuinticPlan {
  JointVector start, goal;
  double begin = 8.0;
  double duration = 2.0;
  double step = 0.005;  ///< between knots [s]

  MotionPoint<JointVector> at(double t) const { return joint_trajectory(start, goal, duration, t - begin); }
};

inline std::string plan_header(const RobotModel& robot) {
  std::string text = "time";
  for (const JointInfo& joint : robot.joints) {
    for (const char* what : {"position", "velocity", "acceleration"})
      text += ",joint/" + joint.name + "/" + what;
  }
  return text + "\n";
}

inline std::string plan_row(double time, const MotionPoint<JointVector>& point) {
  std::string text = cell(time);
  for (Eigen::Index i = 0; i < point.position.size(); ++i) {
    for (const double value : {point.position[i], point.velocity[i], point.acceleration[i]})
      text += "," + cell(value);
  }
  return text + "\n";
}

/// The plan as CSV: the accelerations of the quintic at the knots, and the motion that they integrate to.
inline std::string plan_csv(const RobotModel& robot, const QuinticPlan& plan) {
  std::string text = plan_header(robot);
  const int knots = static_cast<int>(std::lround(plan.duration / plan.step));
  MotionPoint<JointVector> point = plan.at(plan.begin);
  for (int k = 0; k <= knots; ++k) {
    const double t = plan.begin + plan.duration * k / knots;
    if (k > 0) {
      const double h = plan.duration / knots;
      point = linear_acceleration(point, plan.at(t).acceleration, h, h);
    }
    text += plan_row(t, point);
  }
  return text;
}

}  // namespace armtune::internal::test
