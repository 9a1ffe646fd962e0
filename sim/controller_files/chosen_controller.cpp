// Chooses the controller of a parameter file that is tuned. A robot's file usually has several.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>

#include "armtune/error.hpp"
#include "core/common/nearest.hpp"
#include "sim/controller_files/commanded_interfaces.hpp"
#include "sim/controller_files/joint_impedance_file.hpp"
#include "sim/controller_files/joint_parameters.hpp"
#include "sim/controller_files/ros_controllers.hpp"

namespace armtune::internal {
namespace {

using Candidates = std::vector<const RosController*>;

bool is_trajectory(const RosController& controller) {
  if (controller.layout != GainLayout::kPidByJoint) return false;
  if (!controller.type.empty()) return controller.type.ends_with("JointTrajectoryController");
  return controller.parameters->find("joints") != nullptr ||
         controller.parameters->find("command_interfaces") != nullptr;
}

bool is_impedance(const RosController& controller) {
  return controller.layout == GainLayout::kImpedance;
}

/// A kind of controller, in the order in which kinds are preferred.
struct TunableKind {
  bool (*fits)(const RosController&);
  const char* name;
};
constexpr TunableKind kKinds[] = {{is_trajectory, "joint trajectory controllers"},
                                  {is_impedance, "joint impedance controllers"}};

bool has_gains_of(const RosController& controller, const std::vector<std::string>& joints) {
  const std::vector<yaml::PlacedEntry>& gains = controller.parameters->find("gains")->entries;
  return gains.size() == joints.size() &&
         std::all_of(gains.begin(), gains.end(), [&joints](const yaml::PlacedEntry& entry) {
           return std::find(joints.begin(), joints.end(), without_prefix(entry.key)) != joints.end();
         });
}

/// Returns true if armtune simulates the controller. joints: those for which it must have gains; empty: any.
bool can_be_tuned(const RosController& controller, const std::vector<std::string>& joints) {
  if (is_impedance(controller))
    return is_known_joint_impedance(controller) &&
           (joints.empty() || controller.parameters->find("k_gains")->items.size() == joints.size());
  return are_simulated(commanded_interfaces(controller), controller.ros2) &&
         (joints.empty() || has_gains_of(controller, joints));
}

Candidates those(const std::vector<RosController>& all,
                 const std::function<bool(const RosController&)>& fits) {
  Candidates found;
  for (const RosController& controller : all) {
    if (fits(controller)) found.push_back(&controller);
  }
  return found;
}

std::string names_of(const Candidates& controllers) {
  std::vector<std::string> names;
  names.reserve(controllers.size());
  for (const RosController* controller : controllers) names.push_back(controller->name);
  return fmt::format("{}", fmt::join(names, ", "));
}

[[noreturn]] void refuse_several(const Candidates& found, const char* what, const std::string& file) {
  throw InputError(
      InputPlace{file},
      fmt::format("found {} {} with gains: {}; name one of them: --node NAME, or in a study 'node: NAME'",
                  found.size(), what, names_of(found)))
      .with_value(fmt::to_string(found.size()), fmt::format("one of: {}", names_of(found)));
}

std::string list_of(const std::vector<RosController>& all) {
  return all.empty() ? "the file has none"
                     : fmt::format("the file has: {}",
                                   names_of(those(all, [](const RosController&) { return true; })));
}

RosController named(const std::vector<RosController>& all, const std::string& file, const std::string& name) {
  const Candidates able =
      those(all, [&name](const RosController& controller) { return controller.name == name; });
  if (able.size() == 1) return *able.front();
  std::vector<std::string> names;
  names.reserve(all.size());
  for (const RosController& controller : all) names.push_back(controller.name);
  if (!all.empty()) {
    for (const RosController& other : controllers_without_gains(all.front().all, file)) {
      if (other.name == name) refuse_file_without_gains(all.front().all, file, name);
    }
  }
  throw InputError(InputPlace{file}, fmt::format("no controller '{}' with gains{}; {}", name,
                                                 suggestion(name, names), list_of(all)))
      .with_value(name, all.empty() ? "" : fmt::format("one of: {}", fmt::join(names, ", ")));
}

}  // namespace

RosController chosen_controller(const std::vector<RosController>& all, const std::string& file,
                                const std::string& name, const std::vector<std::string>& joints) {
  if (!name.empty()) return named(all, file, name);
  for (const auto& [fits, what] : kKinds) {
    const auto is_of_kind = fits;
    const Candidates able = those(all, [&joints, is_of_kind](const RosController& controller) {
      return is_of_kind(controller) && can_be_tuned(controller, joints);
    });
    if (able.size() == 1) return *able.front();
    if (able.size() > 1) refuse_several(able, what, file);
  }
  // None can be tuned. If there is only one, its reader says why.
  for (const auto& [fits, what] : kKinds) {
    const Candidates found = those(all, fits);
    if (found.size() == 1) return *found.front();
    if (found.size() > 1) refuse_several(found, what, file);
  }
  if (!all.empty() && !controllers_without_gains(all.front().all, file).empty())
    refuse_file_without_gains(all.front().all, file, name);
  throw InputError(InputPlace{file}, fmt::format("found no {} with gains; {}", kKinds[0].name, list_of(all)));
}

}  // namespace armtune::internal
