#include "tuner/report/arm_reader.hpp"

#include "sim/yaml/map_reader.hpp"

namespace armtune::report {
namespace {

Pose read_pose(yaml::MapReader& map) {
  const auto p = map.required("p").as_numbers(3);
  const auto q = map.required("q").as_numbers(4);
  return {Vec3(p[0], p[1], p[2]), Eigen::Quaterniond(q[0], q[1], q[2], q[3])};
}

/// Base64 of nine singles for each triangle, which needs no padding.
bool is_triangles(const std::string& text) {
  constexpr std::size_t kOfTriangle = 48;
  constexpr const char* kAlphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  return text.size() % kOfTriangle == 0 && text.find_first_not_of(kAlphabet) == std::string::npos;
}

std::optional<double> read_limit(yaml::MapReader& map, const char* name) {
  const yaml::Node& node = map.required(name);
  if (node.kind() == yaml::Node::Kind::kNull) return std::nullopt;
  return node.as_number();
}

}  // namespace

Arm read_arm(const yaml::Node& node) {
  yaml::MapReader map(node);
  Arm arm;
  arm.name = map.required("name").as_string();
  for (const yaml::Node& item : map.required("joints").items()) {
    yaml::MapReader joint_map(item);
    ArmJoint joint;
    joint.name = joint_map.required("name").as_string();
    joint.prismatic = joint_map.required("kind").as_string() == "prismatic";
    joint.pose = read_pose(joint_map);
    joint.velocity_limit = joint_map.number("velocity_limit");
    joint.effort_limit = joint_map.number("effort_limit");
    joint.lower = read_limit(joint_map, "lower");
    joint.upper = read_limit(joint_map, "upper");
    joint_map.finish();
    arm.joints.push_back(std::move(joint));
  }
  for (const yaml::Node& item : map.required("shapes").items()) {
    yaml::MapReader shape_map(item);
    ArmShape shape;
    const yaml::Node& joint = shape_map.required("joint");
    const long index = joint.as_integer();
    if (index < -1 || index >= static_cast<long>(arm.joints.size()))
      joint.fail("there is no such joint of this robot");
    shape.joint = static_cast<int>(index);
    shape.pose = read_pose(shape_map);
    shape.kind = shape_map.required("kind").as_string();
    shape.size = shape_map.required("size").as_numbers();
    if (const yaml::Node* triangles = shape_map.optional("triangles")) {
      shape.triangles = triangles->as_string();
      if (!is_triangles(shape.triangles)) triangles->fail("these are no triangles in base64");
    }
    shape_map.finish();
    arm.shapes.push_back(std::move(shape));
  }
  arm.undrawn = static_cast<std::size_t>(std::max(0L, map.integer("undrawn", 0)));
  yaml::MapReader tool(map.required("tool"));
  arm.tool = read_pose(tool);
  tool.finish();
  map.finish();
  return arm;
}

}  // namespace armtune::report
