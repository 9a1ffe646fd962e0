#pragma once
// What a link looks like: a simple body, or a mesh in a file, fixed in a body frame. For drawing, and for
// how thick a link is (link_radius.hpp).

#include <string>

#include "core/common/types.hpp"

namespace armtune::internal {

/// kNoSize: a collision shape whose size the file does not give as above zero, so that it can neither be
/// drawn nor met.
enum class ShapeKind { kBox, kCylinder, kSphere, kCapsule, kMesh, kNoSize };

/// "box", "cylinder", "sphere", "capsule", "mesh", "shape without size"
constexpr const char* name(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::kBox:
      return "box";
    case ShapeKind::kCylinder:
      return "cylinder";
    case ShapeKind::kSphere:
      return "sphere";
    case ShapeKind::kCapsule:
      return "capsule";
    case ShapeKind::kMesh:
      return "mesh";
    case ShapeKind::kNoSize:
      return "shape without size";
  }
  return "";
}

struct Shape {
  int body = -1;           ///< index of the joint that moves it; -1: the base
  int link = 0;            ///< the same for all shapes of a link, of which a body may have several
  std::string link_name;   ///< of that link, or "tool"
  bool collision = false;  ///< of the link's collision geometry, not of what is to be seen
  ShapeKind kind = ShapeKind::kSphere;
  Mat3 R_BS = Mat3::Identity();  ///< shape in the body frame B (see chain.hpp); lengths lie along its z
  Vec3 p_BS = Vec3::Zero();      ///< of its centre, of a mesh its origin [m]
  /// Box: edges; cylinder and capsule: radius, length (a capsule's without its caps), 0; sphere: radius, 0, 0
  /// [m]; mesh: factors on its coordinates.
  Vec3 size = Vec3::Zero();
  std::string file;  ///< of a mesh, as the URDF names it
};

}  // namespace armtune::internal
