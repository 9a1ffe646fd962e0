#pragma once
// The data that a report page needs to draw an arm in its 3D replay: joints, limits and shapes.

#include <optional>
#include <string>
#include <vector>

#include "core/robot/robot_model.hpp"
#include "core/robot/shape.hpp"
#include "tuner/record/declaration.hpp"

namespace armtune::internal::report {

struct Pose {
  Vec3 p = Vec3::Zero();  ///< [m]
  Eigen::Quaterniond q = Eigen::Quaterniond::Identity();
  bool operator==(const Pose&) const = default;

  static void declare(auto& f, auto& pose) { f.type("Pose")("p", pose.p, "m.")("q", pose.q); }
};

struct ArmJoint {
  std::string name;
  bool prismatic = false;
  Pose pose;
  double velocity_limit = 0.0, effort_limit = 0.0;
  std::optional<double> lower, upper;
  bool operator==(const ArmJoint&) const = default;

  static void declare(auto& f, auto& joint) {
    f.type("Joint", "A joint that turns about its own z axis, or moves along it.")("name", joint.name);
    f("kind", joint.prismatic, {"revolute", "prismatic"});
    f("p", joint.pose.p,
      "Origin of the joint's frame at position 0, in the frame of the previous joint or of the base, m.");
    f("q", joint.pose.q)("velocity_limit", joint.velocity_limit, "rad/s or m/s.");
    f("effort_limit", joint.effort_limit, "N m or N.");
    f("lower", joint.lower, "rad or m; null without a limit.")("upper", joint.upper);
  }
};

struct ArmShape {
  int joint = -1;
  Pose pose;
  ShapeKind kind = ShapeKind::kSphere;
  std::vector<double> size;
  std::string triangles;
  bool operator==(const ArmShape&) const = default;

  static void declare(auto& f, auto& shape) {
    f.type("Shape")("joint", shape.joint, "Index of the joint that moves this shape; -1: fixed to the base.")(
        "kind", shape.kind);
    f("size", shape.size,
      "Dimensions, m. Box: edges. Cylinder: radius, length along z. Sphere: radius. Capsule: radius, length "
      "along z between the centres of its half-spheres. Mesh: scale factors; 1 if empty.");
    f("p", shape.pose.p, "Origin of the shape in the joint's frame, m.")("q", shape.pose.q);
    f("triangles", shape.triangles, "Of a mesh: base64 of little-endian float32, nine per triangle.",
      record::Presence::kIfAny);
  }
};

struct Arm {
  std::string name;
  std::vector<ArmJoint> joints;
  std::vector<ArmShape> shapes;
  std::size_t undrawn = 0;
  Pose tool;
  bool operator==(const Arm&) const = default;

  static void declare(auto& f, auto& arm) {
    f.type("Robot", "An arm as the replay draws it.")("name", arm.name)("joints", arm.joints)("shapes",
                                                                                              arm.shapes);
    f("undrawn", arm.undrawn, "Number of URDF shapes that could not be drawn.", record::Presence::kLater);
    f("tool", arm.tool, "Pose of the tool in the last joint's frame; its z axis is the direction of gaze.");
  }
};

/// Returns the arm with its shapes from the URDF. A link has its visual shapes, or its collision shapes if no
/// visual shape can be drawn. Meshes that cannot be loaded are left out. The number of triangles of an arm is
/// limited, and meshes beyond this limit are left out too. A moving link without any shape gets capsules
/// between joint origins.
Arm arm_of(const RobotModel& model);

/// Removes the meshes, and draws links that have no other shape as capsules. Returns by how many bytes this
/// shortens the text of the page.
std::size_t draw_without_meshes(Arm& arm);

}  // namespace armtune::internal::report
