#include "tuner/controller_study/study_motions.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "core/common/file_name.hpp"
#include "core/common/file_path.hpp"
#include "sim/csv/cell.hpp"
#include "sim/scenario/planned_motion.hpp"
#include "sim/scenario/robot_file.hpp"
#include "sim/scenario/trajectory_message.hpp"

namespace armtune::internal {
namespace {

/// One for each file, called as that, with a number where that is taken.
std::vector<std::string> names_of(const std::vector<std::string>& files) {
  std::vector<std::string> names;
  std::set<std::string> taken = {"study", "robot"};
  for (const std::string& file : files) {
    const std::string stem = std::filesystem::path(file).stem().string();
    std::string name = stem;
    for (int number = 2; !taken.insert(name).second; ++number) name = fmt::format("{}_{}", stem, number);
    check_result_name(name, file);
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

/// The knots of a motion, from which it reads back to the same bits.
std::string motion_csv(const JointSpline& motion, const std::vector<std::string>& joints) {
  std::string text = "time";
  for (const char* what : {"position", "velocity", "acceleration"}) {
    for (const std::string& joint : joints) text += "," + cell(fmt::format("joint/{}/{}", joint, what));
  }
  for (std::size_t k = 0; k < motion.time().size(); ++k) {
    const MotionPoint<JointVector>& knot = motion.knots()[k];
    text += "\n" + cell(motion.time()[k]);
    for (const JointVector* values : {&knot.position, &knot.velocity, &knot.acceleration}) {
      for (const double value : *values) text += "," + cell(value);
    }
  }
  return text + "\n";
}

}  // namespace

std::vector<StudyMotion> study_motions(const ControllerStudyInputs& inputs,
                                       const std::shared_ptr<const RobotModel>& robot,
                                       const std::shared_ptr<const ClearanceModel>& clearance) {
  const std::vector<std::string> names = names_of(inputs.trajectories);
  std::vector<StudyMotion> motions;
  for (std::size_t i = 0; i < names.size(); ++i) {
    const std::string& path = inputs.trajectories[i];
    PlannedFile file{{path}, true};
    if (inputs.degrees && !is_trajectory_message(path)) file.table.units.angle = std::numbers::pi / 180.0;
    std::optional<std::vector<JointVector>> goals;
    if (inputs.timing) goals = load_joint_goals(file, *robot);
    if (!goals) {
      motions.push_back({path, names[i], load_planned_motion(file, *robot), absolute_path(path), ""});
      continue;
    }
    JointSpline motion = inputs.timing({path, robot, clearance, std::move(*goals)});
    std::string csv = motion_csv(motion, joint_names(*robot));
    motions.push_back({path, names[i], std::move(motion), names[i] + ".csv", std::move(csv)});
  }
  return motions;
}

void add_notes(const StudyMotion& move, std::vector<std::string>& notes) {
  if (!move.timed.empty())
    notes.push_back(fmt::format(
        "{} has joint goals but no times. The motion through them was planned, takes {:.1f} s and stops at "
        "every goal: see {}",
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
