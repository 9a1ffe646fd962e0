#include "sim/scenario/trajectory_message.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/common/nearest.hpp"
#include "sim/yaml/document.hpp"

namespace armtune::internal {
namespace {

/// Reads a message without the line "---" with which `ros2 topic echo` ends every message.
yaml::Node parse_message(const std::string& path) {
  std::string text = read_input_file(path, yaml::kMaxBytes, "a trajectory message");
  while (text.ends_with('\n') || text.ends_with('\r')) text.pop_back();
  if (text.ends_with("\n---")) text.resize(text.size() - 3);
  return yaml::parse_text(text, path);
}

/// Returns the map that has `points`, at the top or within a goal or another message.
const yaml::Node& trajectory_in(const yaml::Node& root) {
  const yaml::Node* node = &root;
  while (node->kind() == yaml::Node::Kind::kMap && node->find("points") == nullptr) {
    const yaml::Node* inner = nullptr;
    for (const char* key : {"goal", "trajectory", "joint_trajectory"}) {
      if (inner == nullptr) inner = node->find(key);
    }
    if (inner == nullptr) break;
    node = inner;
  }
  if (node->kind() != yaml::Node::Kind::kMap || node->find("points") == nullptr)
    root.fail("not a trajectory_msgs/JointTrajectory: there is neither 'points' nor 'joint_trajectory'",
              "a trajectory_msgs/JointTrajectory");
  return *node;
}

const yaml::Node& required(const yaml::Node& map, const char* key) {
  const yaml::Node* node = map.find(key);
  if (node == nullptr) map.fail(fmt::format("missing key '{}'", key), fmt::format("the key '{}'", key));
  return *node;
}

/// Returns the index of each joint of the robot in the message.
std::vector<std::size_t> places_of(const yaml::Node& names, const RobotModel& robot) {
  const std::vector<std::string> in_file = names.as_strings();
  for (std::size_t i = 1; i < in_file.size(); ++i) {
    if (std::find(in_file.begin(), in_file.begin() + static_cast<std::ptrdiff_t>(i), in_file[i]) !=
        in_file.begin() + static_cast<std::ptrdiff_t>(i))
      names.items()[i].fail(fmt::format("joint '{}' is listed twice", in_file[i]), "each joint once");
  }
  std::vector<std::size_t> places;
  places.reserve(robot.joints.size());
  for (const JointInfo& joint : robot.joints) {
    const auto found = std::find(in_file.begin(), in_file.end(), joint.name);
    if (found == in_file.end()) {
      names.fail(fmt::format("joint '{0}' of {1} is missing{2}; the file has: {3}", joint.name, robot.name,
                             suggestion(joint.name, in_file), fmt::join(in_file, ", ")),
                 fmt::format("a list with '{}'", joint.name));
    }
    places.push_back(static_cast<std::size_t>(found - in_file.begin()));
  }
  return places;
}

/// Returns a time [s] that is given as {sec, nanosec} (ROS 2), {secs, nsecs} (ROS 1) or a number of seconds.
double seconds_in(const yaml::Node& time) {
  if (time.kind() != yaml::Node::Kind::kMap) return time.as_number();
  const bool ros1 = time.find("secs") != nullptr;
  const yaml::Node* nanoseconds = time.find(ros1 ? "nsecs" : "nanosec");
  return required(time, ros1 ? "secs" : "sec").as_number() +
         (nanoseconds == nullptr ? 0.0 : 1e-9 * nanoseconds->as_number());
}

/// Throws InputError if a time [s] is negative, or not later than the time of the point before.
void check_time(const yaml::Node& node, double time, const std::vector<double>& before) {
  if (time < 0.0) {
    node.fail(InputFault{.problem = fmt::format("the time is {} s", time),
                         .value = fmt::to_string(time),
                         .limit = "0 or more"});
  }
  if (before.empty() || time > before.back()) return;
  node.fail(InputFault{.problem = fmt::format("the time {} s is not later than in the point before", time),
                       .value = fmt::to_string(time),
                       .limit = fmt::format("above {} s", before.back())});
}

/// True if all points lack time_from_start, or if it is 0 in all of them because nobody filled in the times.
bool have_no_times(const yaml::Node& points) {
  const auto all = [&points](const auto& is) {
    return std::all_of(points.items().begin(), points.items().end(), [&is](const yaml::Node& point) {
      return point.kind() == yaml::Node::Kind::kMap && is(point.find("time_from_start"));
    });
  };
  return all([](const yaml::Node* time) { return time == nullptr; }) ||
         all([](const yaml::Node* time) { return time != nullptr && seconds_in(*time) == 0.0; });
}

/// Returns the list at `key`, or null if it is absent or empty.
const yaml::Node* numbers_in(const yaml::Node& point, const char* key) {
  const yaml::Node* node = point.find(key);
  return node == nullptr || node->kind() == yaml::Node::Kind::kNull || node->items().empty() ? nullptr : node;
}

class Points {
 public:
  Points(const yaml::Node& message, const RobotModel& robot)
      : places_(places_of(required(message, "joint_names"), robot)),
        joints_(required(message, "joint_names").items().size()) {}

  JointVector values(const yaml::Node& list) const {
    const std::vector<double> all = list.as_numbers(joints_);
    JointVector values(static_cast<Eigen::Index>(places_.size()));
    for (std::size_t i = 0; i < places_.size(); ++i) values[static_cast<Eigen::Index>(i)] = all[places_[i]];
    return values;
  }
  JointVector values_or_zero(const yaml::Node* list) const {
    return list == nullptr ? JointVector(JointVector::Zero(static_cast<Eigen::Index>(places_.size())))
                           : values(*list);
  }

 private:
  std::vector<std::size_t> places_;
  std::size_t joints_;
};

PointsGive given_in(const yaml::Node& point) {
  const bool velocities = numbers_in(point, "velocities") != nullptr;
  const bool accelerations = numbers_in(point, "accelerations") != nullptr;
  if (accelerations && !velocities)
    point.fail(
        "the point has accelerations but no velocities; give velocities too, or leave the accelerations out",
        "velocities with accelerations");
  return accelerations ? PointsGive::kAccelerations
         : velocities  ? PointsGive::kVelocities
                       : PointsGive::kPositions;
}

}  // namespace

bool is_trajectory_message(const std::string& path) {
  return path.ends_with(".yaml") || path.ends_with(".yml");
}

MotionPoints load_trajectory_message(const std::string& path, const RobotModel& robot) {
  const yaml::Node root = parse_message(path);
  const yaml::Node& message = trajectory_in(root);
  const yaml::Node& points = required(message, "points");
  const Points reader(message, robot);
  MotionPoints motion;
  motion.file = path;
  const bool timed = !have_no_times(points);
  for (const yaml::Node& point : points.items()) {
    const double time = timed ? seconds_in(required(point, "time_from_start")) : 0.0;
    if (timed) check_time(*point.find("time_from_start"), time, motion.time);
    const PointsGive given = given_in(point);
    if (motion.points.empty()) motion.given = given;
    if (given != motion.given)
      point.fail("only some points have velocities or accelerations; give them for all or for none",
                 "what the first point has");
    const yaml::Node* positions = numbers_in(point, "positions");
    if (positions == nullptr)
      point.fail("the point has no positions; give one for each joint", "a position for each joint");
    if (timed) motion.time.push_back(time);
    motion.points.push_back({reader.values(*positions),
                             reader.values_or_zero(numbers_in(point, "velocities")),
                             reader.values_or_zero(numbers_in(point, "accelerations"))});
    motion.lines.push_back(static_cast<std::size_t>(point.line()));
  }
  if (motion.points.size() < 2)
    points.fail(
        fmt::format("the message has {} points; a motion needs at least two, and the first one is the arm's "
                    "start position",
                    motion.points.size()),
        "at least 2 points");
  return motion;
}

}  // namespace armtune::internal
