#include "sim/scenario/robot_file.hpp"

#include <fmt/format.h>

#include <array>

#include "core/robot/link_radius.hpp"
#include "core/robot/rotor_estimate.hpp"
#include "core/robot/urdf_reader.hpp"
#include "sim/scenario/cell_file.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/scenario/drive_keys.hpp"
#include "sim/scenario/plant_file.hpp"
#include "sim/scenario/urdf_keys.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune::internal {
namespace {

/// Keys that are read after the URDF, when the joints are known. Those in kJointKeys have a number per joint.
constexpr const char* kCompensation = "compensates_gravity";
constexpr const char* kRotors = "rotor_inertia";
constexpr const char* kDrives = "drives";
constexpr std::array kJointKeys{"viscous_friction", "coulomb_friction", "link_radius", "drive_velocity_gain",
                                "drive_velocity_integral"};
constexpr double kThickest = 10.0;  // m

/// True for a file with `rotor_inertia: estimated`.
bool asks_for_estimate(const RobotFile& file) {
  const yaml::Node* node = file.root ? file.root->find(kRotors) : nullptr;
  return node != nullptr && node->is_word("estimated");
}

/// Returns the numbers of `rotor_inertia: {MARK: ...}`; null if they do not have this mark.
const yaml::Node* marked(const char* mark, const yaml::Node& rotors) {
  const yaml::Node* values = rotors.kind() == yaml::Node::Kind::kMap ? rotors.find(mark) : nullptr;
  return values != nullptr && rotors.entries().size() == 1 ? values : nullptr;
}

/// Reads `rotor_inertia` of the joints.
void read_rotors(const yaml::Node& node, const std::vector<std::string>& joints, RobotModel& model) {
  if (node.is_word("estimated")) return;  // estimate_rotors needs valid limits and is called later
  const yaml::Node* values = marked("estimated", node);
  if (values != nullptr) model.estimated_rotors = joints;
  for (const RotorSource source : {RotorSource::kMeasured, RotorSource::kPublished, RotorSource::kAssumed}) {
    const yaml::Node* own = marked(name(source), node);
    if (own == nullptr) continue;
    values = own;
    model.rotor_source = source;
  }
  model.chain.rotor_inertia = yaml::joint_values(values != nullptr ? *values : node, joints);
}

/// Throws InputError if a link radius is out of range.
void check_radii(const yaml::Node& node, const RobotModel& model) {
  for (int i = 0; i < model.n(); ++i) {
    const double radius = model.link_radii[i];
    if (radius >= 0.0 && radius <= kThickest) continue;
    const std::string& link = model.joints[static_cast<std::size_t>(i)].link;
    node.fail(InputFault{.problem = fmt::format("the radius of {} is {} m", link, radius),
                         .value = fmt::to_string(radius),
                         .limit = fmt::format("0 to {} m", kThickest)});
  }
}

/// Throws InputError if a value is not finite, negative or, with above_zero, zero.
void check_drive(const RobotFile& file, const char* key, const JointVector& values, bool above_zero) {
  for (const double value : values) {
    if (std::isfinite(value) && (above_zero ? value > 0.0 : value >= 0.0)) continue;
    file.root->find(key)->fail(
        InputFault{.problem = fmt::format("a value is {}", value),
                   .value = fmt::to_string(value),
                   .limit = above_zero ? "finite and above 0" : "finite and at least 0"});
  }
}

}  // namespace

bool is_urdf(const std::string& name_or_path) {
  return name_or_path.ends_with(".urdf") || name_or_path.ends_with(".xml") ||
         name_or_path.ends_with(".xacro") || name_or_path.ends_with(".sdf") ||
         name_or_path.ends_with(".mjcf");
}

RobotFile read_robot_file(const std::string& name_or_path, const std::string& relative_to) {
  RobotFile file;
  file.path = find_data_file("robots", name_or_path, relative_to);
  if (is_urdf(name_or_path)) {
    file.urdf = file.path;
    return file;
  }
  file.root = yaml::parse_file(file.path);
  yaml::MapReader map(*file.root);
  file.options = read_urdf_options(map);
  const std::string urdf = map.required("urdf").as_string();
  file.urdf = urdf.starts_with('/') ? urdf : folder_of(file.path) + "/" + urdf;
  for (const char* key : kJointKeys) map.ignore(key);
  map.ignore(kRotors);
  map.ignore("payload");
  map.ignore("cell");
  map.ignore(kCompensation);
  map.ignore(kDrives);
  map.finish();
  return file;
}

std::shared_ptr<const RobotModel> load_robot(const std::string& name_or_path,
                                             const std::string& relative_to) {
  return load_robot(read_robot_file(name_or_path, relative_to));
}

std::shared_ptr<const RobotModel> load_robot(const RobotFile& file, MissingData* missing) {
  auto model = std::make_shared<RobotModel>(read_urdf(file.urdf, file.options, missing));
  model->link_radii = shape_radii(*model);
  if (file.root) {
    model->files.insert(model->files.begin(), file.path);
    Chain& chain = model->chain;
    const auto joints = joint_names(*model);
    const std::array<JointVector*, kJointKeys.size()> values{&chain.viscous_friction, &chain.coulomb_friction,
                                                             &model->link_radii, &model->drive_velocity_gain,
                                                             &model->drive_velocity_integral};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const yaml::Node* node = file.root->find(kJointKeys[i]);
      if (node != nullptr) *values[i] = yaml::joint_values(*node, joints);
    }
    if (const yaml::Node* node = file.root->find(kRotors)) read_rotors(*node, joints, *model);
    if (const yaml::Node* node = file.root->find("link_radius")) check_radii(*node, *model);
    check_drive(file, "drive_velocity_gain", model->drive_velocity_gain, true);
    check_drive(file, "drive_velocity_integral", model->drive_velocity_integral, false);
    if (const yaml::Node* node = file.root->find(kDrives)) read_drives(*node, joints, *model);
  }
  if (const yaml::Node* node = file.root ? file.root->find(kCompensation) : nullptr)
    model->compensates_gravity = node->as_boolean();
  if (const yaml::Node* payload = file.root ? file.root->find("payload") : nullptr)
    *model = with_payload(*model, read_payload(*payload));
  validate(*model);
  // The estimate divides by the limits, which are valid from here on.
  if (asks_for_estimate(file)) estimate_rotors(*model);
  return model;
}

std::optional<Cell> cell_of(const RobotFile& file, std::vector<std::string>& inputs) {
  const yaml::Node* cell = file.root ? file.root->find("cell") : nullptr;
  return cell == nullptr ? std::nullopt : std::optional(read_cell(*cell, inputs));
}

}  // namespace armtune::internal
