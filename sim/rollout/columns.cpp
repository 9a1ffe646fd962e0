#include "sim/rollout/columns.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

namespace armtune::internal {
namespace {

constexpr const char* kAxes[] = {"x", "y", "z"};

void add_vector(std::vector<Column>& columns, const std::string& name, const char* unit, const char* meaning,
                const std::function<Vec3(const Observation&)>& value) {
  for (int axis = 0; axis < 3; ++axis) {
    columns.push_back({name + "/" + kAxes[axis], unit, std::string(meaning) + ", " + kAxes[axis],
                       [value, axis](const Observation& o) { return value(o)[axis]; }});
  }
}

void add_quaternion(std::vector<Column>& columns, const std::string& name, const char* meaning,
                    const std::function<Eigen::Quaterniond(const Observation&)>& value) {
  const auto add = [&](const char* part, double (*pick)(const Eigen::Quaterniond&)) {
    columns.push_back({name + "/" + part, "1", std::string(meaning) + ", quaternion " + part,
                       [value, pick](const Observation& o) { return pick(value(o)); }});
  };
  add("w", [](const Eigen::Quaterniond& q) { return q.w(); });
  add("x", [](const Eigen::Quaterniond& q) { return q.x(); });
  add("y", [](const Eigen::Quaterniond& q) { return q.y(); });
  add("z", [](const Eigen::Quaterniond& q) { return q.z(); });
}

void add_joint(std::vector<Column>& columns, const JointInfo& joint, int i, bool revolute) {
  const std::string tree = "joint/" + joint.name + "/";
  const double velocity_limit = joint.limits.velocity;
  const double effort_limit = joint.limits.effort;
  columns.push_back({tree + "position", revolute ? "rad" : "m", "true joint position",
                     [i](const Observation& o) { return (*o.q)[i]; }});
  columns.push_back({tree + "velocity", revolute ? "rad/s" : "m/s", "true joint velocity",
                     [i](const Observation& o) { return (*o.qd)[i]; }});
  columns.push_back({tree + "velocity_ratio", "1",
                     "largest ratio of |velocity| to its limit since the previous row",
                     [i, velocity_limit](const Observation& o) {
                       double most = std::abs((*o.qd)[i]);
                       for (const DriveInstant& at : o.between) most = std::max(most, std::abs(at.qd[i]));
                       return most / velocity_limit;
                     },
                     Over::kLargest});
  columns.push_back({tree + "torque", revolute ? "N m" : "N",
                     "commanded torque after saturation, at the start of the control period",
                     [i](const Observation& o) { return o.control->torque[i]; }});
  columns.push_back(
      {tree + "torque_ratio", "1",
       "largest ratio of the commanded |torque| to its limit since the previous row, before saturation",
       [i, effort_limit](const Observation& o) {
         double most = std::abs(o.control->commanded[i]);
         for (const DriveInstant& at : o.between) most = std::max(most, std::abs(at.commanded[i]));
         return most / effort_limit;
       },
       Over::kLargest});
}

/// Adds the planned position of a joint and its error. Both are empty in states that do not follow the plan.
void add_planned(std::vector<Column>& columns, const std::string& joint, int i, bool revolute) {
  const std::string tree = "joint/" + joint + "/";
  const auto planned = [i](const Observation& o) {
    return o.control->state == ControlState::kFollowPlan ? o.control->planned.position[i] : NAN;
  };
  const char* length = revolute ? "rad" : "m";
  columns.push_back(
      {tree + "planned", length, "planned joint position; empty when the plan is not followed", planned});
  columns.push_back({tree + "error", length, "true joint position minus the planned one",
                     [i, planned](const Observation& o) { return (*o.q)[i] - planned(o); }});
}

/// Adds the smallest distance of each kind, and the two points that are closest to each other.
void add_clearance(std::vector<Column>& columns, const Scenario& scenario) {
  const auto now = std::make_shared<ClearanceNow>(scenario.clearance);
  const auto seen = [now](const Observation& o) -> const ClearanceNow& {
    now->see(o.time, *o.q);
    return *now;
  };
  const auto add = [&](const char* name, Clearance kind, const char* meaning) {
    if (!scenario.clearance->has(kind)) return;
    columns.push_back(
        {name, "m", meaning,
         [seen, kind](const Observation& o) { return least_of(kind, seen(o).least()).distance; },
         Over::kSmallest});
  };
  add("clearance/self", Clearance::kSelf,
      "smallest distance between two links that are not neighbours, since the previous row");
  add("clearance/cell", Clearance::kCell,
      "smallest distance between a link and a part of the cell, since the previous row");
  add("clearance/floor", Clearance::kFloor,
      "smallest height of a link above the floor, since the previous row");
  add_vector(columns, "closest/of", "m",
             "point of the arm that is closest to another link, the cell or the floor",
             [seen](const Observation& o) { return seen(o).closest().on_a; });
  add_vector(columns, "closest/to", "m",
             "point of the other link, the cell or the floor that is closest to the point closest/of",
             [seen](const Observation& o) { return seen(o).closest().on_b; });
}

}  // namespace

std::vector<Column> rollout_columns(const Scenario& scenario) {
  std::vector<Column> columns;
  columns.push_back({"time", "s", "simulated time", [](const Observation& o) { return o.time; }});
  columns.push_back(
      {"state", "1",
       "0 leaveSingularity, 1 returnToTrajectory, 2 followTrajectory, 3 avoidObstacles, 4 followPlan",
       [](const Observation& o) { return static_cast<double>(o.control->state); }});
  columns.push_back({"slerping", "1", "1 while a slerp (a turn between two orientations) runs",
                     [](const Observation& o) { return o.control->slerping ? 1.0 : 0.0; }});
  add_vector(columns, "tool/position", "m", "tool position in the base frame",
             [](const Observation& o) { return o.poses->p_0T; });
  add_quaternion(columns, "tool/orientation", "tool orientation in the base frame",
                 [](const Observation& o) { return Eigen::Quaterniond(o.poses->R_0T); });
  add_vector(columns, "desired/position", "m",
             "desired tool position; in states that track no position, the actual one",
             [](const Observation& o) { return o.control->desired.position; });
  add_quaternion(columns, "desired/orientation",
                 "desired orientation (identity in leaveSingularity and followPlan)",
                 [](const Observation& o) { return o.control->desired_gaze.orientation; });
  add_vector(columns, "error/position", "m",
             "position error; zero in controller states that track no position",
             [](const Observation& o) -> Vec3 { return o.error.head<3>(); });
  add_vector(columns, "error/orientation", "rad", "rotation vector of the orientation error",
             [](const Observation& o) -> Vec3 { return o.error.tail<3>(); });
  add_vector(columns, "error/linear_velocity", "m/s", "linear velocity error",
             [](const Observation& o) -> Vec3 { return o.error_rate.head<3>(); });
  add_vector(columns, "error/angular_velocity", "rad/s", "angular velocity error",
             [](const Observation& o) -> Vec3 { return o.error_rate.tail<3>(); });
  columns.push_back({"gaze/angle", "rad", "angle between tool z and the line to the target",
                     [](const Observation& o) { return o.gaze_angle; }});
  for (int i = 0; i < scenario.robot->n(); ++i) {
    const auto k = static_cast<std::size_t>(i);
    add_joint(columns, scenario.robot->joints[k], i,
              scenario.robot->chain.motion[k] == JointMotion::kRevolute);
    if (scenario.planned) {
      add_planned(columns, scenario.robot->joints[k].name, i,
                  scenario.robot->chain.motion[k] == JointMotion::kRevolute);
    }
  }
  columns.push_back({"target/index", "1", "index of the active target, from 0",
                     [](const Observation& o) { return static_cast<double>(o.target); }});
  add_vector(columns, "target/position", "m", "position of the active target in the base frame",
             [](const Observation& o) { return o.target_motion.position; });
  if (!scenario.obstacles.empty()) {
    columns.push_back(
        {"obstacle/distance", "m",
         "smallest distance from the arm (joint origins and tool, or the links' surfaces) to an obstacle's "
         "surface since the previous row",
         [](const Observation& o) { return o.clearance; }, Over::kSmallest});
  }
  if (scenario.clearance && !scenario.clearance->pairs().empty()) add_clearance(columns, scenario);
  columns.push_back({"manipulability", "m^3", "sqrt(det(J J^T)) as the controller computed it",
                     [](const Observation& o) { return o.control->manipulability; }});
  columns.push_back({"compensation_error", "N m", "model compensation error |Y (theta_hat - theta)|",
                     [](const Observation& o) { return o.compensation_error; }});
  return columns;
}

std::vector<std::string> column_names(const std::vector<Column>& columns) {
  std::vector<std::string> names;
  names.reserve(columns.size());
  for (const Column& column : columns) names.push_back(column.name);
  return names;
}

std::vector<Column> rollout_columns(const std::vector<Scenario>& scenarios) {
  std::vector<Column> all;
  for (const Scenario& scenario : scenarios) {
    for (Column& column : rollout_columns(scenario)) {
      const auto same = [&column](const Column& c) { return c.name == column.name; };
      if (std::none_of(all.begin(), all.end(), same)) all.push_back(std::move(column));
    }
  }
  return all;
}

}  // namespace armtune::internal
