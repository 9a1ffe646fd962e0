#include "sim/scenario/robot_file.hpp"

#include <Eigen/Geometry>

#include "core/robot/urdf_reader.hpp"
#include "sim/scenario/data_files.hpp"
#include "sim/yaml/joint_values.hpp"
#include "sim/yaml/map_reader.hpp"

namespace armtune {
namespace {

void read_tool(const yaml::Node& node, UrdfOptions& options) {
  yaml::MapReader map(node);
  if (const yaml::Node* xyz = map.optional("xyz")) options.p_tip_T = Vec3(xyz->as_numbers(3).data());
  if (const yaml::Node* rpy = map.optional("rpy")) {
    const auto angles = rpy->as_numbers(3);
    options.R_tip_T =
        (Eigen::AngleAxisd(angles[2], Vec3::UnitZ()) * Eigen::AngleAxisd(angles[1], Vec3::UnitY()) *
         Eigen::AngleAxisd(angles[0], Vec3::UnitX()))
            .toRotationMatrix();
  }
  map.finish();
}

}  // namespace

bool is_urdf(const std::string& name_or_path) {
  return name_or_path.ends_with(".urdf") || name_or_path.ends_with(".xml") ||
         name_or_path.ends_with(".xacro");
}

std::shared_ptr<const RobotModel> load_robot(const std::string& name_or_path,
                                             const std::string& relative_to) {
  if (is_urdf(name_or_path)) {
    auto model = std::make_shared<RobotModel>(read_urdf(find_data_file("robots", name_or_path, relative_to)));
    validate(*model);
    return model;
  }
  const std::string path = find_data_file("robots", name_or_path, relative_to);
  const yaml::Node root = yaml::parse_file(path);
  yaml::MapReader map(root);
  UrdfOptions options;
  options.tip_link = map.string("tip_link", "");
  if (const yaml::Node* tool = map.optional("tool")) read_tool(*tool, options);
  const std::string urdf = map.required("urdf").as_string();
  auto model = std::make_shared<RobotModel>(
      read_urdf(urdf.starts_with('/') ? urdf : folder_of(path) + "/" + urdf, options));
  const auto joints = joint_names(*model);
  if (const auto* node = map.optional("rotor_inertia")) {
    model->chain.rotor_inertia = yaml::joint_values(*node, joints);
  }
  if (const auto* node = map.optional("viscous_friction")) {
    model->chain.viscous_friction = yaml::joint_values(*node, joints);
  }
  if (const auto* node = map.optional("coulomb_friction")) {
    model->chain.coulomb_friction = yaml::joint_values(*node, joints);
  }
  map.finish();
  validate(*model);
  return model;
}

}  // namespace armtune
