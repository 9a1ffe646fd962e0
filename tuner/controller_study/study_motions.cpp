#include "tuner/controller_study/study_motions.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <optional>
#include <set>
#include <string_view>
#include <utility>

#include "armtune/error.hpp"
#include "core/common/file_name.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/trajectory_message.hpp"
#include "sim/scenario/waypoints_file.hpp"

namespace armtune::internal {
namespace {

constexpr std::string_view kMotion = "_motion";  // added to the scenario's name for a planned motion
constexpr std::string_view kPath = "_path";      // likewise for a path of the tool
constexpr std::string_view kStart = "_start";    // likewise for the joint positions at its start

/// Returns `stem`, with a number added if this name is taken, and adds the result to `taken`.
std::string free_name(const std::string& stem, std::set<std::string>& taken) {
  std::string name = stem;
  for (int number = 2; !taken.insert(name).second; ++number) name = fmt::format("{}_{}", stem, number);
  return name;
}

/// True if straight lines join points of the motion, so that its velocity jumps at these points.
bool is_straight(const JointSpline& motion) {
  const std::vector<double>& time = motion.time();
  for (std::size_t k = 0; k + 1 < time.size(); ++k) {
    const double h = time[k + 1] - time[k];
    if (!motion.at(time[k] + 0.5 * h).velocity.isZero(1e-9) &&
        motion.at(time[k] + 0.25 * h).acceleration.isZero(1e-9) &&
        motion.at(time[k] + 0.75 * h).acceleration.isZero(1e-9))
      return true;
  }
  return false;
}

}  // namespace

std::optional<std::vector<StudyMotion>> study_motions(const ControllerStudyInputs& inputs, JointGoals arm,
                                                      Segments segments) {
  std::vector<StudyMotion> motions;
  std::set<std::string> taken = {"study", "robot", "gains"};
  for (const std::string& path : inputs.trajectories) {
    const std::string name = free_name(std::filesystem::path(path).stem().string(), taken);
    check_result_name(name, path);
    PlannedFile file{{path}, segments, inputs.speed};
    if (inputs.tool_motion && has_tool_waypoints(file.table, *arm.robot)) {
      check_result_name(name, path, kLongestName - kMotion.size());
      TimedGoals timed = inputs.tool_motion({file.table, arm.robot, arm.clearance, arm.ros2, inputs.speed});
      motions.push_back({path, name, std::move(timed.motion), "", std::move(timed.message), true});
      continue;
    }
    if (inputs.degrees && !is_trajectory_message(path)) file.table.units.angle = std::numbers::pi / 180.0;
    if (!inputs.timing) {
      motions.push_back({path, name, load_planned_motion(file, *arm.robot), absolute_path(path), ""});
      continue;
    }
    MotionOrGoals given = load_motion_or_goals(file, *arm.robot);
    if (given.motion) {
      motions.push_back({path, name, std::move(*given.motion), absolute_path(path), ""});
      continue;
    }
    check_result_name(name, path, kLongestName - kMotion.size());
    arm.file = path;
    arm.speed = inputs.speed;
    arm.positions = std::move(given.goals);
    std::optional<TimedGoals> timed = inputs.timing(arm);
    if (!timed) return std::nullopt;
    motions.push_back({path, name, std::move(timed->motion), "", std::move(timed->message)});
  }
  // The files of planned motions are named last, so that all scenarios keep their names.
  for (StudyMotion& motion : motions) {
    if (!motion.message.empty())
      motion.reference = free_name(motion.name + std::string(kMotion), taken) + ".yaml";
  }
  return motions;
}

std::vector<StudyMotion> tool_motions(const ControllerStudyInputs& inputs, const JointGoals& arm,
                                      double period) {
  std::vector<StudyMotion> motions;
  std::set<std::string> taken = {"study", "robot", "gains"};
  for (const std::string& file : inputs.trajectories) {
    const std::string name = free_name(std::filesystem::path(file).stem().string(), taken);
    check_result_name(name, file, kLongestName - kStart.size());
    if (!has_tool_waypoints({file}, *arm.robot))
      throw InputError(InputPlace{file, 0, "x"},
                       "this controller tracks the tool, so a motion of the joints says nothing about its "
                       "gains; give a CSV file with waypoints of the tool: time, x, y, z and, for its "
                       "orientation, qw, qx, qy, qz");
    ToolPath path = tool_path({{file}, arm.robot, arm.clearance, arm.ros2, inputs.speed}, period);
    const JointVector rest = JointVector::Zero(path.position.size());
    const MotionPoint<JointVector> start{path.position, rest, rest};
    const std::string waypoints = path.waypoints;
    motions.push_back({file, name, {{0.0, period}, {start, start}}, "", waypoints, true, std::move(path)});
  }
  for (StudyMotion& motion : motions) {
    motion.reference = free_name(motion.name + std::string(kPath), taken) + ".csv";
    motion.start_reference = free_name(motion.name + std::string(kStart), taken) + ".csv";
  }
  return motions;
}

void add_notes(const StudyMotion& move, Segments segments, std::vector<std::string>& notes) {
  if (move.path) {
    notes.push_back(fmt::format(
        "the arm follows the waypoints of {} from joint positions that armtune chose, after {:g} s of rest. "
        "{} has these positions; replace them by those of your robot{}",
        move.file, kRestBeforePath, move.start_reference,
        move.path->turns
            ? ""
            : ". The file gives no orientation of the tool, so gains of rotations have no effect"));
    return;
  }
  if (move.of_tool) {
    notes.push_back(fmt::format(
        "{} has waypoints of the tool. armtune chose joint positions with which the tool follows them; other "
        "software may choose others. {} contains this motion for the robot. The robot must be at its first "
        "point when the motion begins",
        move.file, move.reference));
  } else if (!move.message.empty()) {
    notes.push_back(fmt::format(
        "{} has joint goals but no times. The motion through them was planned, takes {:.1f} s and stops at "
        "every goal. {} contains this motion for the robot. The robot must be at the first goal when the "
        "motion begins",
        move.file, move.motion.end(), move.reference));
  }
  if (segments == Segments::kAsRos && move.message.empty() && is_straight(move.motion))
    notes.push_back(fmt::format(
        "{} has positions but no velocities. As in ROS, straight lines then join the points, and the desired "
        "velocity jumps at every point. A file that also has velocities gives smaller tracking errors",
        move.file));
  if (move.motion.begin() > 0.0)
    notes.push_back(fmt::format(
        "{} begins at {:g} s, and the motion to its first point is not simulated; add a point at 0 s with "
        "the arm's position at that time",
        move.file, move.motion.begin()));
}

}  // namespace armtune::internal
