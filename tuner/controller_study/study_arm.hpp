#pragma once
// The arm of a controller study (controller_study.hpp): its model, and the limits that it can violate.

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "sim/cell/clearance_model.hpp"
#include "sim/metrics/metric.hpp"

namespace armtune::internal {

/// The arm, and the text of robot.yaml if its own files do not describe it completely.
struct StudyArm {
  std::shared_ptr<const RobotModel> model;
  std::shared_ptr<const ClearanceModel> clearance;
  bool has_cell = false;                         ///< true if its file describes the cell around it
  std::vector<std::pair<Metric, bool>> contact;  ///< metric of each kind of contact; true if it applies
  std::string yaml;                              ///< text of robot.yaml; empty: not needed
  std::string reference;                         ///< name by which scenarios refer to the arm

  bool touches_itself() const { return contact.front().second; }
};

/// Reads the arm. Estimates its rotor inertia if no file gives this inertia. robot: bundled name, robot YAML
/// or URDF. Throws InputError.
StudyArm study_arm(const std::string& robot);

/// Returns the limits that this arm can violate, as constraints of a study.
std::string constraints_of(const StudyArm& arm);

}  // namespace armtune::internal
