#include "tuner/report/arm.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/cell/mesh_file.hpp"
#include "sim/cell/mesh_path.hpp"
#include "tuner/report/base64.hpp"

namespace armtune::internal::report {
namespace {

/// Largest number of triangles in all meshes of an arm. Each takes 48 bytes of text, together 1.4 MB.
constexpr std::size_t kMostTriangles = 30000;

Pose pose_of(const Mat3& R, const Vec3& p) {
  return {p, Eigen::Quaterniond(R).normalized()};
}

std::vector<double> size_of(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::kSphere:
      return {shape.size.x()};
    case ShapeKind::kCylinder:
    case ShapeKind::kCapsule:
      return {shape.size.x(), shape.size.y()};
    default:
      return {shape.size.x(), shape.size.y(), shape.size.z()};
  }
}

/// Returns a capsule from one point to another in the frame of `joint`, or a sphere if the points coincide.
ArmShape limb(int joint, const Vec3& from, const Vec3& to, double radius) {
  ArmShape shape;
  shape.joint = joint;
  const Vec3 along = to - from;
  shape.pose = {0.5 * (from + to), Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), along)};
  if (along.norm() < 1e-6) {
    shape.pose.q.setIdentity();
    shape.kind = ShapeKind::kSphere;
    shape.size = {radius};
  } else {
    shape.kind = ShapeKind::kCapsule;
    shape.size = {radius, along.norm()};
  }
  return shape;
}

/// Returns nothing for a shape without size, and for a mesh that cannot be loaded or has more triangles than
/// are left.
std::optional<ArmShape> drawn(const Shape& shape, const std::string& urdf, std::size_t& triangles_left) {
  if (shape.kind == ShapeKind::kNoSize) return std::nullopt;
  ArmShape result{shape.body, pose_of(shape.R_BS, shape.p_BS), shape.kind, size_of(shape), {}};
  if (shape.kind != ShapeKind::kMesh) return result;
  const auto path = mesh_path(shape.file, urdf);
  if (!path) return std::nullopt;
  const Mesh mesh = read_mesh(*path, triangles_left);
  if (!mesh.refusal.empty()) return std::nullopt;
  triangles_left -= mesh.corners.size() / 9;
  result.triangles = base64_f32(mesh.corners);
  return result;
}

void add_shapes(const RobotModel& model, Arm& arm) {
  std::size_t triangles_left = kMostTriangles;
  const auto& shapes = model.shapes;
  for (auto begin = shapes.begin(); begin != shapes.end();) {
    const auto end =
        std::find_if(begin, shapes.end(), [begin](const Shape& s) { return s.link != begin->link; });
    std::size_t found = 0;
    std::size_t failed = 0;
    // Visual shapes often are meshes of a kind that cannot be loaded. Then the simpler collision shapes are
    // drawn.
    for (const bool collision : {false, true}) {
      for (auto shape = begin; shape != end; ++shape) {
        if (shape->collision != collision) continue;
        auto shown = drawn(*shape, model.source, triangles_left);
        ++(shown ? found : failed);
        if (shown) arm.shapes.push_back(std::move(*shown));
      }
      if (found > 0) break;
    }
    if (found == 0) arm.undrawn += failed;
    begin = end;
  }
}

/// Adds a capsule from every joint whose link has no shape to the next joint. It is as thick as the wrist of
/// an industrial arm.
void add_limbs(double reach, Arm& arm) {
  constexpr double kThickness = 0.04;  // of the reach
  const int n = static_cast<int>(arm.joints.size());
  for (int next = 0; next <= n; ++next) {
    const int body = next - 1;
    const bool has_shape = std::any_of(arm.shapes.begin(), arm.shapes.end(),
                                       [body](const ArmShape& shape) { return shape.joint == body; });
    if (has_shape) continue;
    const Vec3 end = next == n ? arm.tool.p : arm.joints[static_cast<std::size_t>(next)].pose.p;
    if (body >= 0 || end.norm() > 0.0)
      arm.shapes.push_back(limb(body, Vec3::Zero(), end, kThickness * reach));
  }
}

}  // namespace

Arm arm_of(const RobotModel& model) {
  Arm arm;
  arm.name = model.name;
  arm.joints.reserve(model.joints.size());
  for (std::size_t k = 0; k < model.joints.size(); ++k) {
    const JointInfo& info = model.joints[k];
    ArmJoint joint;
    joint.name = info.name;
    joint.prismatic = model.chain.motion[k] == JointMotion::kPrismatic;
    joint.pose = pose_of(model.chain.R_PB0[k], model.chain.p_PB0[k]);
    joint.velocity_limit = info.limits.velocity;
    joint.effort_limit = info.limits.effort;
    if (info.limits.has_position) {
      joint.lower = info.limits.lower;
      joint.upper = info.limits.upper;
    }
    arm.joints.push_back(std::move(joint));
  }
  arm.tool = pose_of(model.chain.R_BT, model.chain.p_BT);
  add_shapes(model, arm);
  add_limbs(reach(model), arm);
  return arm;
}

std::size_t draw_without_meshes(Arm& arm) {
  std::size_t bytes = 0;
  std::erase_if(arm.shapes, [&bytes](const ArmShape& shape) {
    bytes += shape.triangles.size();
    return !shape.triangles.empty();
  });
  if (bytes == 0) return 0;
  double reach = arm.tool.p.norm();
  for (const ArmJoint& joint : arm.joints) reach += joint.pose.p.norm();
  add_limbs(reach, arm);
  return bytes;
}

}  // namespace armtune::internal::report
