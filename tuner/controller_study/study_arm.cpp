#include "tuner/controller_study/study_arm.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/robot/rotor_estimate.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/robot_file.hpp"
#include "tuner/first_task/estimated_robot.hpp"

namespace armtune::internal {

StudyArm study_arm(const std::string& robot) {
  const RobotFile file = read_robot_file(robot);
  StudyArm arm;
  arm.model = load_robot(robot);
  arm.reference = portable_reference(file.path);
  std::vector<std::string> inputs;
  const std::optional<Cell> cell = cell_of(file, inputs);
  arm.has_cell = cell.has_value();
  arm.clearance = std::make_shared<const ClearanceModel>(arm.model, cell.value_or(Cell{}));
  for (const auto& [metric, kind] : {std::pair{Metric::kClearanceSelf, Clearance::kSelf},
                                     {Metric::kClearanceCell, Clearance::kCell},
                                     {Metric::kClearanceFloor, Clearance::kFloor}})
    arm.contact.emplace_back(metric, arm.clearance->has(kind));
  if (!lacks_rotors(file, *arm.model)) return arm;
  RobotModel estimated = *arm.model;
  estimate_rotors(estimated);
  arm.yaml = estimated_robot_yaml(file, estimated);
  arm.model = std::make_shared<const RobotModel>(std::move(estimated));
  arm.reference = "robot.yaml";
  return arm;
}

std::string constraints_of(const StudyArm& arm) {
  std::string text;
  const auto add = [&text](Metric metric) {
    text += fmt::format("  - {{metric: {}, at_least: 0}}\n", name(metric));
  };
  const auto& joints = arm.model->joints;
  if (std::any_of(joints.begin(), joints.end(),
                  [](const JointInfo& joint) { return joint.limits.has_position; }))
    add(Metric::kJointPositionMinMargin);
  if (std::any_of(joints.begin(), joints.end(),
                  [](const JointInfo& joint) { return std::isfinite(joint.limits.acceleration); }))
    text += fmt::format("  - {{metric: {}, at_most: 0.9}}\n", name(Metric::kJointAccelerationMaxRatio));
  for (const auto& [metric, possible] : arm.contact) {
    if (possible) add(metric);
  }
  return text;
}

}  // namespace armtune::internal
