#include "sim/scenario/solid_keys.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

namespace armtune::internal {
namespace {

constexpr double kLargest = 1000.0;  // m

double length(double value, const yaml::Node& node, const char* what) {
  if (value > 0.0 && value <= kLargest) return value;
  const std::string limit = fmt::format("above 0 and at most {}", kLargest);
  node.fail(InputFault{
      .problem = fmt::format("{} is {} m", what, value), .value = fmt::to_string(value), .limit = limit});
}

Vec3 place(const yaml::Node& node) {
  Vec3 point(node.as_numbers(3).data());
  if (!(point.cwiseAbs().maxCoeff() <= kLargest))
    node.fail(fmt::format("a coordinate exceeds +-{} m; give metres", kLargest),
              fmt::format("-{0} to {0} m", kLargest));
  return point;
}

Solid read_round(const yaml::Node& node, SolidKind kind) {
  yaml::MapReader map(node);
  const double radius = length(map.number("radius"), map.required("radius"), "a radius");
  if (kind == SolidKind::kSphere) {
    map.finish();
    return sphere(radius);
  }
  const double along = length(map.number("length"), map.required("length"), "a length");
  map.finish();
  return kind == SolidKind::kCapsule ? capsule(radius, along) : cylinder(radius, along);
}

/// Reads a cylinder or capsule that is given by its end points. Returns nothing if it is given otherwise.
std::optional<PlacedSolid> read_between(const yaml::Node* node, SolidKind kind) {
  if (node == nullptr || (node->find("from") == nullptr && node->find("to") == nullptr)) return std::nullopt;
  yaml::MapReader map(*node);
  const double radius = length(map.number("radius"), map.required("radius"), "a radius");
  const Vec3 from = place(map.required("from"));
  const Vec3 to = place(map.required("to"));
  map.finish();
  const Vec3 line = to - from;
  PlacedSolid placed;
  placed.p_BS = 0.5 * (from + to);
  if (line.isZero(0.0)) {
    if (kind == SolidKind::kCylinder)
      node->fail("'from' and 'to' are the same point; a cylinder needs a length");
    placed.solid = sphere(radius);
    return placed;
  }
  placed.R_BS = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), line).toRotationMatrix();
  placed.solid = kind == SolidKind::kCapsule ? capsule(radius, line.norm()) : cylinder(radius, line.norm());
  return placed;
}

Solid read_box(const yaml::Node& node) {
  const Vec3 edges(node.as_numbers(3).data());
  for (const double edge : edges) length(edge, node, "an edge");
  return box(edges);
}

}  // namespace

Solid read_solid(yaml::MapReader& map) {
  std::optional<Solid> solid;
  const auto take = [&solid](const yaml::Node* node, auto read) {
    if (node == nullptr) return;
    if (solid) node->fail("this entry has a second shape; give each shape its own entry");
    solid = read(*node);
  };
  take(map.optional("box"), read_box);
  take(map.optional("cylinder"), [](const yaml::Node& n) { return read_round(n, SolidKind::kCylinder); });
  take(map.optional("capsule"), [](const yaml::Node& n) { return read_round(n, SolidKind::kCapsule); });
  take(map.optional("sphere"), [](const yaml::Node& n) { return read_round(n, SolidKind::kSphere); });
  if (!solid) map.none_of({"box", "cylinder", "capsule", "sphere"});
  return *solid;
}

Mat3 read_turn(yaml::MapReader& map) {
  const yaml::Node* node = map.optional("rpy_deg");
  if (node == nullptr) return Mat3::Identity();
  const auto degrees = node->as_numbers(3);
  const auto turn = [&degrees](std::size_t i, const Vec3& axis) {
    return Eigen::AngleAxisd(degrees[i] * std::numbers::pi / 180.0, axis);
  };
  return (turn(2, Vec3::UnitZ()) * turn(1, Vec3::UnitY()) * turn(0, Vec3::UnitX())).toRotationMatrix();
}

PlacedSolid read_placed_solid(yaml::MapReader& map) {
  for (const auto& [key, kind] :
       {std::pair{"capsule", SolidKind::kCapsule}, std::pair{"cylinder", SolidKind::kCylinder}}) {
    if (!map.has(key)) continue;
    if (const auto placed = read_between(map.optional(key), kind)) return *placed;
  }
  PlacedSolid placed;
  placed.solid = read_solid(map);
  placed.R_BS = read_turn(map);
  if (const yaml::Node* center = map.optional("center")) placed.p_BS = place(*center);
  return placed;
}

}  // namespace armtune::internal
