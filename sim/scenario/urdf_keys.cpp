#include "sim/scenario/urdf_keys.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include "core/robot/body_inertia.hpp"
#include "core/robot/link_inertias.hpp"
#include "sim/scenario/solid_keys.hpp"

namespace armtune::internal {
namespace {

std::optional<double> number_of(yaml::MapReader& map, const char* key) {
  const yaml::Node* node = map.optional(key);
  return node == nullptr ? std::nullopt : std::optional(node->as_number());
}

GivenLimits read_limits(const yaml::Node& node) {
  yaml::MapReader map(node);
  const GivenLimits limits{number_of(map, "lower"), number_of(map, "upper"), number_of(map, "velocity"),
                           number_of(map, "effort"), number_of(map, "acceleration")};
  map.finish();
  return limits;
}

/// Reads mass, center and moments.
GivenInertia read_inertia(yaml::MapReader& map) {
  GivenInertia given;
  const yaml::Node& mass = map.required("mass");
  given.mass = mass.as_number();
  if (!(given.mass >= 0.0))
    mass.fail(fmt::format("the mass is {} kg; it must not be negative", given.mass), "not negative");
  if (const yaml::Node* center = map.optional("center")) given.center = Vec3(center->as_numbers(3).data());
  const auto m = map.required("moments").as_numbers(6);
  given.about_center << m[0], m[1], m[2],  //
      m[1], m[3], m[4],                    //
      m[2], m[4], m[5];
  return given;
}

GivenInertia read_link_inertia(const yaml::Node& node) {
  yaml::MapReader map(node);
  GivenInertia given = read_inertia(map);
  map.finish();
  return given;
}

ShapeKind kind_of(SolidKind kind) {
  switch (kind) {
    case SolidKind::kSphere:
      return ShapeKind::kSphere;
    case SolidKind::kCapsule:
      return ShapeKind::kCapsule;
    case SolidKind::kBox:
      return ShapeKind::kBox;
    default:
      return ShapeKind::kCylinder;
  }
}

/// Reads shapes as collision geometry.
std::vector<Shape> read_shapes(const yaml::Node& node) {
  std::vector<Shape> shapes;
  for (const yaml::Node& item : node.items()) {
    yaml::MapReader map(item);
    const PlacedSolid placed = read_placed_solid(map);
    map.finish();
    Shape shape;
    shape.collision = true;
    shape.kind = kind_of(placed.solid.kind);
    shape.size = placed.solid.size;
    if (placed.solid.radius > 0.0) shape.size = Vec3(placed.solid.radius, placed.solid.size[0], 0.0);
    shape.R_BS = placed.R_BS;
    shape.p_BS = placed.p_BS;
    shapes.push_back(shape);
  }
  return shapes;
}

void read_tool(const yaml::Node& node, UrdfOptions& options) {
  yaml::MapReader map(node);
  for (const char* key : {"xyz", "rpy", "mass", "center", "moments", "shapes"}) map.ignore(key);
  map.finish();  // reports a misspelt key before the reads below report a missing one
  if (const yaml::Node* xyz = map.optional("xyz")) options.p_tip_T = Vec3(xyz->as_numbers(3).data());
  if (const yaml::Node* rpy = map.optional("rpy")) {
    const auto angles = rpy->as_numbers(3);
    options.R_tip_T =
        (Eigen::AngleAxisd(angles[2], Vec3::UnitZ()) * Eigen::AngleAxisd(angles[1], Vec3::UnitY()) *
         Eigen::AngleAxisd(angles[0], Vec3::UnitX()))
            .toRotationMatrix();
  }
  if (map.has("mass") || map.has("center") || map.has("moments")) {
    options.tool_inertia = read_inertia(map);
    if (!(options.tool_inertia->mass > 0.0))
      map.required("mass").fail(
          "the mass of a tool must be above zero; if nothing is mounted, leave out mass, center and moments",
          "above zero");
    if (!is_physical(in_link_frame(*options.tool_inertia)))
      map.required("moments").fail(
          "no rigid body has these moments of inertia; no principal moment may be negative or larger than "
          "the sum of the other two",
          "moments of a rigid body");
  }
  if (const yaml::Node* shapes = map.optional("shapes")) options.tool_shapes = read_shapes(*shapes);
}

}  // namespace

UrdfOptions read_urdf_options(yaml::MapReader& map) {
  UrdfOptions options;
  options.base_link = map.string("base_link", "");
  options.tip_link = map.string("tip_link", "");
  if (const yaml::Node* tool = map.optional("tool")) read_tool(*tool, options);
  if (const yaml::Node* hold = map.optional("hold")) {
    for (const auto& [joint, value] : hold->entries()) options.held[joint] = value.as_number();
  }
  if (const yaml::Node* limits = map.optional("limits")) {
    for (const auto& [joint, value] : limits->entries()) options.limits[joint] = read_limits(value);
  }
  if (const yaml::Node* inertia = map.optional("inertia")) {
    for (const auto& [link, value] : inertia->entries()) options.inertia[link] = read_link_inertia(value);
  }
  if (const yaml::Node* shapes = map.optional("shapes")) {
    for (const auto& [link, value] : shapes->entries()) options.shapes[link] = read_shapes(value);
  }
  return options;
}

}  // namespace armtune::internal
