#include "sim/rollout/motion_bag.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "armtune/error.hpp"
#include "core/robot/kinematics.hpp"
#include "sim/logs/builtin_schema.hpp"
#include "sim/logs/mcap_writer.hpp"
#include "sim/logs/ros_messages.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kFloat = "std_msgs/msg/Float64";
constexpr const char* kJointState = "sensor_msgs/msg/JointState";
constexpr const char* kPoseStamped = "geometry_msgs/msg/PoseStamped";
constexpr const char* kTf = "tf2_msgs/msg/TFMessage";

/// Returns the name, with underscores behind it if a link of the arm is called the same.
std::string free_frame(const RobotModel& robot, std::string name) {
  const auto taken = [&name](const LinkFrame& link) { return link.name == name; };
  while (std::any_of(robot.links.begin(), robot.links.end(), taken)) name += '_';
  return name;
}

/// Returns the pose of the arm's base in the frame of the same origin in which gravity acts along -z.
FramePose base_in_map(const Vec3& gravity) {
  if (gravity.isZero(0.0)) return {};
  return {Eigen::Quaterniond::FromTwoVectors(gravity, -Vec3::UnitZ()).toRotationMatrix(), Vec3::Zero()};
}

/// Reads columns by name, row by row.
class MotionRows {
 public:
  explicit MotionRows(const MotionTable& motion)
      : motion_(motion), is_used_(motion.columns.size(), false), row_(motion.values.data()) {}

  /// Returns the index of the column, which then has a message of its own; nothing if there is none.
  std::optional<std::size_t> find(const std::string& name) {
    const auto found = std::find(motion_.columns.begin(), motion_.columns.end(), name);
    if (found == motion_.columns.end()) return std::nullopt;
    const auto column = static_cast<std::size_t>(found - motion_.columns.begin());
    is_used_[column] = true;
    return column;
  }
  std::size_t need(const std::string& name) {
    if (const auto column = find(name)) return *column;
    throw InputError(InputPlace{.key = name}, InputFault{.problem = "the motion has no such column",
                                                         .limit = "a column of this name"});
  }
  /// Returns the indices of several columns; none if one of the columns is missing.
  std::vector<std::size_t> group(const std::vector<std::string>& names) {
    std::vector<std::size_t> columns;
    for (const std::string& name : names) {
      if (const auto column = find(name)) columns.push_back(*column);
    }
    if (columns.size() < names.size()) columns.clear();
    return columns;
  }
  /// Returns the columns that were not asked for.
  std::vector<std::size_t> others() const {
    std::vector<std::size_t> columns;
    for (std::size_t c = 0; c < is_used_.size(); ++c) {
      if (!is_used_[c]) columns.push_back(c);
    }
    return columns;
  }

  bool has_row() const { return row_ != motion_.values.data() + motion_.values.size(); }
  void next() { row_ += motion_.columns.size(); }
  double operator[](std::size_t column) const { return row_[column]; }
  /// Copies the values of the columns; false if there are none, or if one of them is not finite.
  bool read(const std::vector<std::size_t>& columns, std::vector<double>& values) const {
    values.clear();
    for (const std::size_t column : columns) values.push_back(row_[column]);
    return !values.empty() &&
           std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  }

 private:
  const MotionTable& motion_;
  std::vector<bool> is_used_;
  const double* row_;
};

class MotionBag {
 public:
  MotionBag(const std::string& path, const MotionTable& motion)
      : motion_(motion),
        robot_(motion.robot),
        names_(joint_names(robot_)),
        map_(free_frame(robot_, "map")),
        tool_(free_frame(robot_, "tool")),
        rows_(motion),
        bag_(path) {
    find_columns();
    add_topics();
  }

  void write(const Metrics* metrics) {
    bool is_first = true;
    for (; rows_.has_row(); rows_.next()) {
      stamp_ = std::llround(1e9 * rows_[time_]);
      if (is_first) write_fixed_frames();
      is_first = false;
      write_row();
    }
    if (metrics != nullptr && !is_first) write_metrics(*metrics);
    bag_.finish();
  }

 private:
  std::size_t topic(const std::string& name, const char* type) {
    return bag_.add_topic(builtin_topic(name, type));
  }

  void find_columns() {
    time_ = rows_.need("time");
    std::vector<std::string> planned;
    for (const std::string& name : names_) {
      const std::string tree = "joint/" + name + "/";
      position_.push_back(rows_.need(tree + "position"));
      velocity_.push_back(rows_.need(tree + "velocity"));
      effort_.push_back(rows_.need(tree + "torque"));
      planned.push_back(tree + "planned");
    }
    planned_ = rows_.group(planned);
    const auto vector = [this](const std::string& name) {
      return rows_.group({name + "/x", name + "/y", name + "/z"});
    };
    const auto quaternion = [this](const std::string& name) {
      return rows_.group({name + "/w", name + "/x", name + "/y", name + "/z"});
    };
    desired_ = vector("desired/position");
    desired_turn_ = quaternion("desired/orientation");
    target_ = vector("target/position");
    vector("tool/position");  // these follow from the joint positions
    quaternion("tool/orientation");
    others_ = rows_.others();
  }

  void add_topics() {
    tf_static_topic_ = topic("/tf_static", kTf);
    tf_topic_ = topic("/tf", kTf);
    states_topic_ = topic("/joint_states", kJointState);
    tool_topic_ = topic("/tool_pose", kPoseStamped);
    if (!planned_.empty()) references_topic_ = topic("/joint_references", kJointState);
    if (!planned_.empty() || !desired_.empty()) desired_topic_ = topic("/target_pose", kPoseStamped);
    if (!target_.empty()) target_topic_ = topic("/gaze_target", kPoseStamped);
    for (const std::size_t column : others_)
      other_topics_.push_back(topic("/recording/" + motion_.columns[column], kFloat));
  }

  void write_fixed_frames() {
    std::vector<NamedTransform> frames = {{map_, robot_.base_link, base_in_map(robot_.chain.gravity)}};
    for (const LinkFrame& link : robot_.links) {
      if (link.body < 0 && link.name != robot_.base_link)
        frames.push_back({robot_.base_link, link.name, {link.R_BL, link.p_BL}});
      if (link.body >= 0) moving_.push_back({robot_.base_link, link.name, {}});
    }
    moving_.push_back({robot_.base_link, tool_, {}});
    bag_.write(tf_static_topic_, stamp_, tf_message(out_, stamp_, frames));
  }

  void write_row() {
    const bool has_pose = rows_.read(position_, q_);
    rows_.read(velocity_, qd_);
    rows_.read(effort_, torque_);
    bag_.write(states_topic_, stamp_, joint_state_message(out_, stamp_, names_, q_, qd_, torque_));
    if (has_pose) {
      const FramePose tool = tool_at(q_);
      write_frames(tool);
      bag_.write(tool_topic_, stamp_, pose_message(out_, stamp_, robot_.base_link, tool));
    }
    write_target();
    for (std::size_t i = 0; i < others_.size(); ++i) {
      const double value = rows_[others_[i]];
      if (std::isfinite(value)) bag_.write(other_topics_[i], stamp_, float_message(out_, value));
    }
  }

  /// Computes the poses at these joint positions and returns that of the tool.
  FramePose tool_at(const std::vector<double>& q) {
    const JointVector at = Eigen::Map<const Eigen::VectorXd>(q.data(), robot_.n());
    forward_kinematics(robot_.chain, at, poses_);
    return {poses_.R_0T, poses_.p_0T};
  }

  void write_frames(const FramePose& tool) {
    std::size_t frame = 0;
    for (const LinkFrame& link : robot_.links) {
      if (link.body < 0) continue;
      const auto body = static_cast<std::size_t>(link.body);
      const Mat3& R_0B = poses_.R_0B[body];
      moving_[frame++].pose = {R_0B * link.R_BL, poses_.p_0B[body] + R_0B * link.p_BL};
    }
    moving_[frame].pose = tool;
    bag_.write(tf_topic_, stamp_, tf_message(out_, stamp_, moving_));
  }

  /// Writes the references of the joints, the pose that the tool is meant to have, and the gaze target.
  void write_target() {
    std::optional<FramePose> aim;
    if (rows_.read(planned_, q_)) {
      bag_.write(references_topic_, stamp_, joint_state_message(out_, stamp_, names_, q_, {}, {}));
      aim = tool_at(q_);
    } else if (rows_.read(desired_, q_)) {
      aim.emplace().p = Vec3(q_[0], q_[1], q_[2]);
      if (rows_.read(desired_turn_, q_))
        aim->R = Eigen::Quaterniond(q_[0], q_[1], q_[2], q_[3]).toRotationMatrix();
    }
    if (aim) bag_.write(desired_topic_, stamp_, pose_message(out_, stamp_, robot_.base_link, *aim));
    if (!rows_.read(target_, q_)) return;
    const FramePose target{Mat3::Identity(), Vec3(q_[0], q_[1], q_[2])};
    bag_.write(target_topic_, stamp_, pose_message(out_, stamp_, robot_.base_link, target));
  }

  void write_metrics(const Metrics& metrics) {
    for (const Metric metric : all_metrics()) {
      if (!std::isfinite(metrics[metric])) continue;
      const std::size_t place = topic(std::string("/metrics/") + name(metric), kFloat);
      bag_.write(place, stamp_, float_message(out_, metrics[metric]));
    }
  }

  const MotionTable& motion_;
  const RobotModel& robot_;
  std::vector<std::string> names_;
  std::string map_, tool_;  // names of frames that are not links
  MotionRows rows_;
  McapWriter bag_;
  CdrWriter out_;
  std::int64_t stamp_ = 0;  ///< of the row [ns]
  std::size_t time_ = 0;
  std::vector<std::size_t> position_, velocity_, effort_, planned_, desired_, desired_turn_, target_, others_;
  std::size_t tf_topic_ = 0, tf_static_topic_ = 0, states_topic_ = 0, references_topic_ = 0, tool_topic_ = 0,
              desired_topic_ = 0, target_topic_ = 0;
  std::vector<std::size_t> other_topics_;
  std::vector<NamedTransform>
      moving_;  ///< of the links that move, in the order of robot_.links, and the tool
  Poses poses_;
  std::vector<double> q_, qd_, torque_;  // of the row
};

}  // namespace

void write_motion_bag(const std::string& path, const MotionTable& motion, const Metrics* metrics) {
  MotionBag(path, motion).write(metrics);
}

}  // namespace armtune::internal
