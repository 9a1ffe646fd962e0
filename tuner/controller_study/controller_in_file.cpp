#include "tuner/controller_study/controller_in_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <unordered_map>

#include "armtune/error.hpp"
#include "core/common/input_file.hpp"
#include "core/control/laws/cartesian_impedance_law.hpp"
#include "core/control/laws/controller_kind.hpp"
#include "core/control/laws/joint_impedance_law.hpp"
#include "core/control/laws/valid_gains.hpp"
#include "sim/controller_files/changed_gains.hpp"
#include "sim/controller_files/controller_gains.hpp"
#include "sim/controller_files/parameter_file.hpp"
#include "sim/yaml/document.hpp"
#include "tuner/controller_study/shared_numbers.hpp"

namespace armtune::internal {
namespace {

/// True if a map binds a gain of the control loop to the file that most controllers of this kind do not have.
bool is_bound(const ControllerInFile& from, const GainField& field) {
  const auto& places = from.controller.places;
  return from.controller.layout == GainLayout::kMapped && field.loop != LoopGain::kNone &&
         std::any_of(places.begin(), places.end(), [&field](const GainPlace& place) {
           return std::string_view(place.gain).substr(0, place.gain.find('/')) == field.name;
         });
}

/// Returns one bound for each value of the stiffness from the numbers of --max-stiffness. parts: names of the
/// values. Throws InputError if their count is wrong.
std::vector<double> one_for_each(const std::vector<double>& given, const std::vector<std::string>& parts,
                                 bool of_tool) {
  const std::size_t n = parts.size();
  if (given.size() == n) return given;
  if (of_tool && given.size() == 2) {
    std::vector<double> most(n, given[0]);
    std::fill(most.begin() + 3, most.end(), given[1]);
    return most;
  }
  if (!of_tool && given.size() == 1) return std::vector<double>(n, given.front());
  throw InputError(fmt::format("--max-stiffness has {} numbers; give {}, or {} numbers in the order {}",
                               given.size(),
                               of_tool ? "one for translations and one for rotations" : "one for all joints",
                               n, fmt::join(parts, ", ")))
      .with_value(fmt::to_string(given.size()), fmt::format("{} or {}", of_tool ? 2 : 1, n));
}

/// Throws InputError if the values of the gains in the file cannot be replaced. This is checked before the
/// search, because the result could otherwise not be written.
void require_room(const ControllerInFile& from) {
  Gains others = from.gains;
  const std::vector<SharedNumber> shared = shared_numbers(from);
  std::unordered_map<const SharedNumber*, double> factors;
  double factor = 1.0;
  for (const GainField* field : searched_fields(from)) {
    JointVector& values = values_of(others, *field);
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      if (!is_in_file(from, *field, k)) continue;
      factor += 0.01;
      const SharedNumber* number = number_of(shared, *field, static_cast<std::size_t>(k));
      values[k] *= number == nullptr ? factor : factors.emplace(number, factor).first->second;
    }
  }
  with_gains(from.text, from.controller, from.file, others, from.joints);
}

}  // namespace

std::vector<const GainField*> searched_fields(const ControllerInFile& from) {
  std::vector<const GainField*> found;
  for (const GainField& field : fields_of(from.gains)) {
    if (std::holds_alternative<OwnGain>(field.member) &&
        (field.search != SearchRange::kNone || is_bound(from, field)))
      found.push_back(&field);
  }
  return found;
}

JointVector& values_of(Gains& gains, const GainField& field) {
  return gains.own[std::get<OwnGain>(field.member).place];
}

bool is_in_file(const ControllerInFile& from, const GainField& field, Eigen::Index k) {
  if (from.controller.layout != GainLayout::kMapped) return true;
  const auto& places = from.controller.places;
  return std::any_of(places.begin(), places.end(), [&](const GainPlace& place) {
    return place.gain == field.name ||
           place.gain == fmt::format("{}/{}", field.name,
                                     component_names(field, from.joints)[static_cast<std::size_t>(k)]);
  });
}

std::string entry_name(const GainField& field, const std::string& part) {
  return part.empty() ? std::string(field.name) : fmt::format("{}/{}", field.name, part);
}

ControllerInFile read_controller(const std::string& file, const std::string& node,
                                 const std::vector<std::string>& joints, std::optional<RosDistro> distro) {
  ControllerInFile read;
  ParameterFile found = required_parameter_file(file, node, distro, joints);
  read.file = std::move(found.path);
  read.text = std::move(found.text);
  read.controller = std::move(found.controller);
  read.joints = joints;
  read.gains = controller_gains(read.controller, read.file, joints);
  validate(read.gains, joints, read.file);
  const auto fields = searched_fields(read);
  if (std::all_of(fields.begin(), fields.end(),
                  [&read](const GainField* field) { return values_of(read.gains, *field).isZero(0.0); }))
    throw InputError(InputPlace{file},
                     fmt::format("every gain of {} that could be tuned is 0; give start gains above 0",
                                 read.controller.name));
  require_room(read);
  return read;
}

ControllerInFile new_controller(const std::string& kind, const RobotModel& arm, const JointVector& q) {
  controller_kind(kind);  // throws InputError if the name is unknown
  const std::vector<std::string> kinds = motion_controllers();
  if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end())
    throw InputError(fmt::format(
        "the gains of the controller '{}' cannot be tuned on given motions; choose one of {}, or write a "
        "study for a task of the tool ('armtune robot --task')",
        kind, fmt::join(kinds, ", ")));
  ControllerInFile made;
  made.controller.name = kind;
  made.joints = joint_names(arm);
  made.gains = joint_motion_gains(kind, arm.n());
  controller_kind(kind).start(arm, q, made.gains);
  return made;
}

const char* stiffness_of_controller(const ControllerInFile& from) {
  return is_of_tool(from) ? "cartesian_impedance_k" : "joint_impedance_k";
}

bool is_of_tool(const ControllerInFile& from) {
  return from.gains.controller == kCartesianImpedance;
}

bool has_stiffness(const ControllerInFile& from) {
  return from.gains.controller == kJointImpedance || is_of_tool(from);
}

std::vector<double> bounded_stiffness(const std::vector<double>& given, ControllerInFile& from) {
  if (given.empty()) return {};
  if (!has_stiffness(from))
    throw InputError(
        fmt::format("--max-stiffness has no effect: {} has no stiffness", from.gains.controller));
  const char* stiffness = stiffness_of_controller(from);
  std::vector<std::string> parts = from.joints;
  for (const GainField* field : searched_fields(from)) {
    if (field->name == std::string_view(stiffness)) parts = component_names(*field, from.joints);
  }
  const std::vector<double> most = one_for_each(given, parts, is_of_tool(from));
  JointVector& start = own(from.gains, stiffness);
  for (std::size_t k = 0; k < most.size(); ++k) {
    double& value = start[static_cast<Eigen::Index>(k)];
    if (value <= most[k]) continue;
    if (!from.file.empty())
      throw InputError(
          InputPlace{from.file},
          fmt::format("the stiffness of {} is {:.6g}, above --max-stiffness {:.6g}; lower it in the "
                      "file, or allow more",
                      parts[k], value, most[k]))
          .with_value(fmt::format("{:.6g}", value), fmt::format("at most {:.6g}", most[k]));
    value = most[k];
  }
  return most;
}

}  // namespace armtune::internal
