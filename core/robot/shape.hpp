#pragma once
// A visual or collision shape of a robot's link: a box, cylinder, sphere, capsule, or mesh in a file. Its
// pose is fixed in a body frame. It is used for drawing, for collision checks and for the thickness of a link
// (link_radius.hpp).

#include <string>

#include "core/common/types.hpp"

namespace armtune::internal {

/// The kinds of shapes. kNoSize: a collision shape without a positive size in the file, so that it can be
/// neither drawn nor hit.
enum class ShapeKind { kBox, kCylinder, kSphere, kCapsule, kMesh, kNoSize };

/// Returns "box", "cylinder", "sphere", "capsule", "mesh" or "shape without size".
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
  int link = 0;            ///< number of its link; a body may have several links
  std::string link_name;   ///< name of that link, or "tool"
  bool collision = false;  ///< true: part of the collision geometry; false: of the visual geometry
  ShapeKind kind = ShapeKind::kSphere;
  Mat3 R_BS = Mat3::Identity();  ///< orientation in the body frame B (chain.hpp); lengths lie along z of S
  Vec3 p_BS = Vec3::Zero();      ///< its centre, or the origin of a mesh [m]
  /// Box: edges; cylinder and capsule: radius, length (capsules: without caps), 0; sphere: radius, 0, 0
  /// [m]. Mesh: scale factors of its coordinates.
  Vec3 size = Vec3::Zero();
  std::string file;  ///< file of a mesh, as named in the URDF
};

}  // namespace armtune::internal
