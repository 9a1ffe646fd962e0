#include "tuner/controller_study/controller_in_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_trajectory_law.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/yaml/document.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

constexpr double kMostDamping = 5.0;  // of what the arm's inertia asks for

/// Its own gains that are searched unless a study says otherwise.
std::vector<const GainField*> searched_fields(const Gains& gains) {
  std::vector<const GainField*> found;
  for (const GainField& field : fields_of(gains)) {
    if (std::holds_alternative<OwnGain>(field.member) && field.search != SearchRange::kNone)
      found.push_back(&field);
  }
  return found;
}

JointVector& values_of(Gains& gains, const GainField& field) {
  return gains.own[std::get<OwnGain>(field.member).place];
}

/// Throws InputError where the file could not hold other numbers than it has: better now than after a search.
void require_room(const ControllerInFile& from) {
  Gains others = from.gains;
  double factor = 1.0;
  for (const GainField* field : searched_fields(from.gains)) {
    for (double& value : values_of(others, *field)) value *= factor += 0.01;
  }
  with_gains(from.text, from.controller, from.file, others, from.joints);
}

/// Whether the file has a place for the d of joint k.
bool has_room_for_damping(const ControllerInFile& from, Eigen::Index k) {
  Gains damped = from.gains;
  jtc_gain(damped, "d")[k] = 1.0;
  try {
    with_gains(from.text, from.controller, from.file, damped, from.joints);
  } catch (const InputError&) {
    return false;
  }
  return true;
}

std::string entry(const std::string& gain, const std::string& joint, const std::string& bounds = "") {
  return fmt::format("  - {{name: {}{}}}\n", yaml::quoted(fmt::format("{}/{}", gain, joint)), bounds);
}

}  // namespace

ControllerInFile read_controller(const std::string& file, const std::string& node,
                                 const std::vector<std::string>& joints) {
  ControllerInFile read;
  read.file = file;
  read.text = read_input_file(file, yaml::kMaxBytes, "a ROS parameter file");
  read.controller = chosen_controller(ros_controllers(read.text, file), file, node);
  read.joints = joints;
  read.gains = controller_gains(read.controller, file, joints);
  validate(read.gains, joints, file);
  const auto fields = searched_fields(read.gains);
  if (std::all_of(fields.begin(), fields.end(),
                  [&read](const GainField* field) { return values_of(read.gains, *field).isZero(0.0); }))
    throw InputError(InputPlace{file},
                     fmt::format("every gain of {} that could be tuned is 0; give start gains above 0",
                                 read.controller.name));
  require_room(read);
  return read;
}

std::string tuned_parameters(const ControllerInFile& from, const RobotModel& arm, const JointVector& q,
                             std::vector<std::string>& undamped) {
  Gains gains = from.gains;
  // Drives have damping of their own.
  const bool needs_damping = gains.controller == kJointTrajectoryController;
  Gains first = gains;
  controller_kind(gains.controller).start(arm, q, first);
  std::string text;
  for (const GainField* field : searched_fields(from.gains)) {
    const JointVector& values = values_of(gains, *field);
    if ((values.array() != 0.0).all()) {
      text += fmt::format("  - {{name: {}}}\n", field->name);
      continue;
    }
    for (std::size_t k = 0; k < from.joints.size(); ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      if (values[i] != 0.0) {
        text += entry(field->name, from.joints[k]);
      } else if (needs_damping && &values == &jtc_gain(gains, "d") && jtc_gain(gains, "p")[i] != 0.0 &&
                 has_room_for_damping(from, i)) {
        undamped.push_back(from.joints[k]);
        text += entry(
            field->name, from.joints[k],
            fmt::format(", lower: 0, upper: {:.4g}, scale: linear", kMostDamping * jtc_gain(first, "d")[i]));
      }
    }
  }
  return text;
}

}  // namespace armtune::internal
