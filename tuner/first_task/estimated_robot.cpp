#include "tuner/first_task/estimated_robot.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <vector>

#include "armtune/error.hpp"
#include "core/common/file_path.hpp"
#include "core/common/input_file.hpp"
#include "sim/yaml/quoted.hpp"

namespace armtune::internal {
namespace {

/// Returns the lines of the file, except the one that names the URDF.
std::string other_lines(const RobotFile& file) {
  const yaml::Node* urdf = file.root->find("urdf");
  std::istringstream lines(read_input_file(file.path, yaml::kMaxBytes, "a robot file"));
  std::string kept, line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (number != urdf->line()) kept += line + "\n";
  }
  return kept;
}

/// Returns true if the text has the keys of `file` and exactly one more, that of the estimate.
bool says_the_same(const std::string& text, const RobotFile& file) {
  try {
    const yaml::Node root = yaml::parse_text(text, file.path);
    std::size_t found = 0;
    for (const auto& [key, value] : file.root->entries()) found += root.find(key) != nullptr ? 1 : 0;
    return found == file.root->entries().size() && root.entries().size() == found + 1;
  } catch (const InputError&) {
    return false;
  }
}

/// Returns true if the robot file's cell names waypoint files, whose paths are relative to the file's folder.
bool names_waypoints(const RobotFile& file) {
  const yaml::Node* cell = file.root->find("cell");
  const yaml::Node* parts = cell == nullptr ? nullptr : cell->find("parts");
  if (parts == nullptr) return false;
  return std::any_of(parts->items().begin(), parts->items().end(),
                     [](const yaml::Node& part) { return part.find("waypoints") != nullptr; });
}

}  // namespace

bool lacks_rotors(const RobotFile& file, const RobotModel& robot) {
  const bool told = file.root && file.root->find("rotor_inertia") != nullptr;
  return !told && (robot.chain.rotor_inertia.array() == 0.0).any();
}

std::string estimated_robot_yaml(const RobotFile& file, const RobotModel& estimated) {
  std::vector<std::string> figures;
  figures.reserve(static_cast<std::size_t>(estimated.n()));
  for (int i = 0; i < estimated.n(); ++i)
    figures.push_back(fmt::format("{:.3g}", estimated.chain.rotor_inertia[i]));
  std::string text =
      fmt::format("urdf: {}\n{}", yaml::quoted(absolute_path(file.urdf)),
                  file.root ? other_lines(file) : "") +
      fmt::format(
          "\n# No file gives the rotor inertia of {}. It is estimated from the limits of effort and velocity, in\n"
          "# kg m^2: [{}].\n"
          "# Better: replace 'estimated' by a list of the arm's real values.\nrotor_inertia: estimated\n",
          estimated.estimated_rotors.size() == std::size_t(estimated.n())
              ? "the joints"
              : fmt::format("{}", fmt::join(estimated.estimated_rotors, ", ")),
          fmt::join(figures, ", "));
  if (file.root && (!says_the_same(text, file) || names_waypoints(file))) {
    throw InputError(InputPlace{file.path, 0, "rotor_inertia"},
                     "the file gives no rotor inertia; add the line 'rotor_inertia: estimated' to it")
        .with_value({}, "the key 'rotor_inertia'");
  }
  return text;
}

}  // namespace armtune::internal
