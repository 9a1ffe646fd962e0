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

/// Keys that are read after the URDF, when the joints are known. Those in kJointKeys have a number per joint,
/// those in kMarkedKeys also a mark that says where the numbers come from.
constexpr const char* kCompensation = "compensates_gravity";
constexpr const char* kRotors = "rotor_inertia";
constexpr const char* kDrives = "drives";
constexpr std::array kMarkedKeys{kRotors, "viscous_friction", "coulomb_friction"};
constexpr std::array kJointKeys{"link_radius", "drive_velocity_gain", "drive_velocity_integral"};
constexpr double kThickest = 10.0;  // m

/// True for a file with `rotor_inertia: estimated`.
bool asks_for_estimate(const RobotFile& file) {
  const yaml::Node* node = file.root ? file.root->find(kRotors) : nullptr;
  return node != nullptr && node->is_word("estimated");
}

/// Reads numbers of the joints, or `{MARK: NUMBERS}`. Returns the mark; kGiven if there is none.
ValueSource read_marked(const yaml::Node& node, const std::vector<std::string>& joints, JointVector& values) {
  const bool one_key = node.kind() == yaml::Node::Kind::kMap && node.entries().size() == 1;
  for (const ValueSource source : kMarkedSources) {
    const yaml::Node* marked = one_key ? node.find(name(source)) : nullptr;
    if (marked == nullptr) continue;
    values = yaml::joint_values(*marked, joints);
    return source;
  }
  values = yaml::joint_values(node, joints);
  return ValueSource::kGiven;
}

/// Reads rotor inertia and friction of the joints.
void read_marked_values(const yaml::Node& root, const std::vector<std::string>& joints, RobotModel& model) {
  const std::array values{&model.chain.rotor_inertia, &model.chain.viscous_friction,
                          &model.chain.coulomb_friction};
  const std::array sources{&model.rotor_source, &model.viscous_source, &model.coulomb_source};
  for (std::size_t i = 0; i < kMarkedKeys.size(); ++i) {
    const yaml::Node* node = root.find(kMarkedKeys[i]);
    if (node == nullptr) continue;
    if (kMarkedKeys[i] == kRotors && node->is_word("estimated")) continue;  // needs valid limits: read later
    *sources[i] = read_marked(*node, joints, *values[i]);
  }
  if (model.rotor_source != ValueSource::kEstimated) return;
  model.estimated_rotors = joints;
  model.rotor_source = ValueSource::kGiven;  // of the other joints
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
  for (const char* key : kMarkedKeys) map.ignore(key);
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
    const auto joints = joint_names(*model);
    const std::array<JointVector*, kJointKeys.size()> values{&model->link_radii, &model->drive_velocity_gain,
                                                             &model->drive_velocity_integral};
    for (std::size_t i = 0; i < values.size(); ++i) {
      const yaml::Node* node = file.root->find(kJointKeys[i]);
      if (node != nullptr) *values[i] = yaml::joint_values(*node, joints);
    }
    read_marked_values(*file.root, joints, *model);
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
