#include "tuner/controller_study/study_motions.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "core/common/file_name.hpp"
#include "core/common/file_path.hpp"
#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/trajectory_message.hpp"

namespace armtune::internal {
namespace {

constexpr const char* kMotion = "_motion";  // behind the scenario's name: a motion that was planned

/// One for each file, called as that, with a number where that is taken.
std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::set<std::string> taken = {"study", "robot"};
  for (const std::string& file : files) {
    const std::string stem = std::filesystem::path(file).stem().string();
    std::string name = stem;
    for (int number = 2; taken.count(name) + taken.count(name + kMotion) > 0; ++number)
      name = fmt::format("{}_{}", stem, number);
    check_result_name(name + kMotion, file);
    taken.insert({name, name + kMotion});
    names.push_back(name);
  }
  return names;
}

/// Whether a motion goes along straight lines, so that its velocity jumps at points.
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

std::vector<StudyMotion> study_motions(const ControllerStudyInputs& inputs, JointGoals arm) {
  const std::vector<std::string> names = names_of(inputs.trajectories);
  std::vector<StudyMotion> motions;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& path = inputs.trajectories[i];
    PlannedFile file{{path}, true};
    if (inputs.degrees && !is_trajectory_message(path)) file.table.units.angle = std::numbers::pi / 180.0;
    std::optional<std::vector<JointVector>> goals;
    if (inputs.timing) goals = load_joint_goals(file, *arm.robot);
    if (!goals) {
      motions.push_back({path, names[i], load_planned_motion(file, *arm.robot), absolute_path(path), ""});
      continue;
    }
    arm.file = path;
    arm.positions = std::move(*goals);
    TimedGoals timed = inputs.timing(arm);
    motions.push_back(
        {path, names[i], std::move(timed.motion), names[i] + kMotion + ".yaml", std::move(timed.message)});
  }
  return motions;
}

void add_notes(const StudyMotion& move, std::vector<std::string>& notes) {
  if (!move.message.empty())
    notes.push_back(fmt::format(
        "{} has joint goals but no times. The motion through them was planned, takes {:.1f} s and stops at "
        "every goal: {} has it for the robot",
        move.file, move.motion.end(), move.reference));
  if (is_straight(move.motion))
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
