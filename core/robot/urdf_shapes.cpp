#include "core/robot/urdf_shapes.hpp"

#include <urdf_model/link.h>

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

namespace armtune::internal {
namespace {

bool drawable(double length) {
  return std::isfinite(length) && length > 0.0;
}

/// Returns the shape with its kind, size and file; nothing if it cannot be drawn.
std::optional<Shape> shape_of(const urdf::Geometry& geometry) {
  Shape shape;
  bool whole = false;
  switch (geometry.type) {
    case urdf::Geometry::BOX: {
      const urdf::Vector3& edges = static_cast<const urdf::Box&>(geometry).dim;
      shape.kind = ShapeKind::kBox;
      shape.size = {edges.x, edges.y, edges.z};
      whole = drawable(edges.x) && drawable(edges.y) && drawable(edges.z);
      break;
    }
    case urdf::Geometry::CYLINDER: {
      const auto& cylinder = static_cast<const urdf::Cylinder&>(geometry);
      shape.kind = ShapeKind::kCylinder;
      shape.size = {cylinder.radius, cylinder.length, 0.0};
      whole = drawable(cylinder.radius) && drawable(cylinder.length);
      break;
    }
    case urdf::Geometry::SPHERE: {
      const double radius = static_cast<const urdf::Sphere&>(geometry).radius;
      shape.kind = ShapeKind::kSphere;
      shape.size = {radius, 0.0, 0.0};
      whole = drawable(radius);
      break;
    }
    case urdf::Geometry::MESH: {
      const auto& mesh = static_cast<const urdf::Mesh&>(geometry);
      shape.kind = ShapeKind::kMesh;
      shape.size = {mesh.scale.x, mesh.scale.y, mesh.scale.z};
      shape.file = mesh.filename;
      whole = shape.size.allFinite() && !mesh.filename.empty();  // a negative factor mirrors the mesh
      break;
    }
  }
  return whole ? std::optional(shape) : std::nullopt;
}

void append(const urdf::Geometry* geometry, const urdf::Pose& origin, bool collision,
            std::vector<Shape>& shapes) {
  if (geometry == nullptr) return;
  auto shape = shape_of(*geometry);
  if (!shape && collision) {
    shape.emplace();
    shape->kind = ShapeKind::kNoSize;  // the link is larger than its other shapes show
  }
  if (!shape) return;
  const urdf::Rotation& q = origin.rotation;
  shape->collision = collision;
  shape->R_BS = Eigen::Quaterniond(q.w, q.x, q.y, q.z).toRotationMatrix();
  shape->p_BS = Vec3(origin.position.x, origin.position.y, origin.position.z);
  if (shape->R_BS.allFinite() && shape->p_BS.allFinite()) shapes.push_back(*shape);
}

}  // namespace

std::vector<Shape> shapes_of(const urdf::Link& link) {
  std::vector<Shape> shapes;
  for (const auto& visual : link.visual_array) {
    if (visual) append(visual->geometry.get(), visual->origin, false, shapes);
  }
  for (const auto& collision : link.collision_array) {
    if (collision) append(collision->geometry.get(), collision->origin, true, shapes);
  }
  return shapes;
}

}  // namespace armtune::internal
