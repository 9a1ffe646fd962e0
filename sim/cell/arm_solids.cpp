#include "sim/cell/arm_solids.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <utility>

#include "sim/cell/hull.hpp"
#include "sim/cell/mesh_file.hpp"
#include "sim/cell/mesh_path.hpp"

namespace armtune::internal {
namespace {

constexpr std::size_t kMostTriangles = 500000;
constexpr double kRod = 1e-3;  // m

/// Returns the convex hull of a mesh, and adds its file to `meshes`. If the mesh cannot be used, returns
/// nothing and sets `why` to the reason.
std::optional<Solid> hull_of_mesh(const Shape& shape, const std::string& urdf,
                                  std::vector<std::string>& meshes, std::string& why) {
  const auto path = mesh_path(shape.file, urdf);
  if (!path) {
    why = fmt::format(
        "there is no such file in the robot's folder or in a package of a sourced ROS workspace; give its folder "
        "in the environment variable {}",
        kMeshFolders);
    return std::nullopt;
  }
  const Mesh mesh = read_mesh(*path, kMostTriangles);
  if (!mesh.refusal.empty()) {
    why = mesh.refusal;
    return std::nullopt;
  }
  if (std::find(meshes.begin(), meshes.end(), *path) == meshes.end()) meshes.push_back(*path);
  std::vector<Vec3> points;
  const std::vector<float>& corners = mesh.corners;
  points.reserve(corners.size() / 3);
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Eigen::Vector3f point(corners[i], corners[i + 1], corners[i + 2]);
    points.push_back(shape.size.cwiseProduct(point.cast<double>()));
  }
  auto hull = convex_hull(points);
  if (!hull) why = "its points enclose no volume";
  return hull;
}

std::optional<Solid> solid_of(const Shape& shape, const std::string& urdf, std::vector<std::string>& meshes,
                              std::string& why) {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return box(shape.size);
    case ShapeKind::kCylinder:
      return cylinder(shape.size[0], shape.size[1]);
    case ShapeKind::kSphere:
      return sphere(shape.size[0]);
    case ShapeKind::kCapsule:
      return capsule(shape.size[0], shape.size[1]);
    case ShapeKind::kNoSize:
      why = "the size of a collision shape is not above zero";
      return std::nullopt;
    case ShapeKind::kMesh:
      break;
  }
  return hull_of_mesh(shape, urdf, meshes, why);
}

/// Returns the shapes that represent a link: its collision shapes, or its visual shapes if it has none. The
/// shapes without size come last.
std::vector<const Shape*> counting(const RobotModel& robot, int link) {
  std::vector<const Shape*> collision, seen, without_size;
  for (const Shape& shape : robot.shapes) {
    if (shape.link != link) continue;
    auto& of_its_kind = shape.kind == ShapeKind::kNoSize ? without_size : shape.collision ? collision : seen;
    of_its_kind.push_back(&shape);
  }
  std::vector<const Shape*>& counted = collision.empty() ? seen : collision;
  counted.insert(counted.end(), without_size.begin(), without_size.end());
  return counted;
}

/// Adds the bodies without any shape to arm.unknown, under the names of their links.
void add_bare_bodies(const RobotModel& robot, ArmSolids& arm) {
  for (int body = -1; body < robot.n(); ++body) {
    const auto is_on = [body](const auto& shape) { return shape.body == body; };
    if (std::any_of(robot.shapes.begin(), robot.shapes.end(), is_on)) continue;
    arm.unknown.push_back(body < 0 ? robot.base_link : robot.joints[static_cast<std::size_t>(body)].link);
  }
}

/// Returns a thin rod from the last body's shapes to the origin of the tool frame, the point that does the
/// work. Returns nothing if this origin lies on or in the shapes. Other parts of the tool are known only from
/// the robot's file.
std::optional<ArmSolid> rod_to_tool(const RobotModel& robot, const std::vector<ArmSolid>& solids) {
  const Vec3& tool = robot.chain.p_BT;
  const int last = robot.n() - 1;
  const Solid point = sphere(kRod);
  Vec3 from = Vec3::Zero();  // the joint's origin, if no shape is closer
  double least = tool.norm();
  for (const ArmSolid& solid : solids) {
    if (solid.body != last) continue;
    const Closest near =
        closest(solid.placed.solid, solid.placed.R_BS, solid.placed.p_BS, point, Mat3::Identity(), tool);
    if (near.distance >= least) continue;
    least = near.distance;
    from = near.on_a;
  }
  if (least <= kRod) return std::nullopt;
  const Vec3 way = tool - from;
  return ArmSolid{
      last,
      "tool",
      {capsule(kRod, way.norm()), Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), way).toRotationMatrix(),
       0.5 * (from + tool)}};
}

}  // namespace

ArmSolids arm_solids(const RobotModel& robot) {
  ArmSolids arm;
  int links = 0;
  for (const Shape& shape : robot.shapes) links = std::max(links, shape.link + 1);
  for (int link = 0; link < links; ++link) {
    const std::vector<const Shape*> shapes = counting(robot, link);
    bool whole = true;
    for (const Shape* shape : shapes) {
      std::string why;
      const auto solid = solid_of(*shape, robot.source, arm.meshes, why);
      const std::string& what = shape->file.empty() ? shape->link_name : shape->file;
      if (!solid) arm.unread.push_back(fmt::format("{}: {}", what, why));
      whole = whole && solid;
      if (solid)
        arm.solids.push_back(
            {shape->body, shape->link_name, {*solid, shape->R_BS, shape->p_BS}, !shape->collision});
    }
    if (!whole) arm.unknown.push_back(shapes.front()->link_name);
  }
  add_bare_bodies(robot, arm);
  if (!arm.solids.empty()) {
    if (auto rod = rod_to_tool(robot, arm.solids)) arm.solids.push_back(std::move(*rod));
  }
  std::stable_sort(arm.solids.begin(), arm.solids.end(),
                   [](const ArmSolid& a, const ArmSolid& b) { return a.body < b.body; });
  return arm;
}

std::vector<std::string> drawn_links(const ArmSolids& arm) {
  std::vector<std::string> links;
  for (const ArmSolid& solid : arm.solids) {
    if (solid.drawn && std::find(links.begin(), links.end(), solid.link) == links.end())
      links.push_back(solid.link);
  }
  return links;
}

}  // namespace armtune::internal
