#pragma once
// Adds the inertias of a URDF's links to those of the arm's moving bodies. A body consists of all links that
// are fixed to each other. Inertias that no rigid body can have are found here.

#include <string>
#include <vector>

#include "core/robot/chain.hpp"
#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

/// The constant pose of a link's frame L in the frame B of the moving body that carries it, or in the base
/// (body -1).
struct Site {
  int body = -1;
  Mat3 R_BL = Mat3::Identity();
  Vec3 p_BL = Vec3::Zero();
};

/// Returns a link's inertia about the origin of its frame, from the values given for it.
LinkInertia in_link_frame(const GivenInertia& told);

/// Returns the inertia that the file gives the link, which must have one, about the origin of the link's
/// frame. Throws InputError with a message that begins with `source` if its mass or a moment of inertia is
/// negative. After the inertia is added to a body, that could no longer be detected.
LinkInertia inertia_of(const UrdfLink& link, const std::string& source);

/// The links that have been added to the bodies of a chain, so that a message can name those at fault.
class LinkInertias {
 public:
  /// Adds a link to the body that it is fixed to. in_L: about the origin of the link's frame.
  void add(const std::string& link, const LinkInertia& in_L, const Site& site, Chain& chain);

  /// Checks that a rigid body can have the inertia of each body in the chain. Otherwise it throws InputError
  /// with a message that begins with `source` and names all links that cause it. If `missing` is given, these
  /// links are collected there instead, and the chain gets the nearest possible inertias in their place.
  void judge(Chain& chain, const std::string& source, MissingData* missing) const;

 private:
  struct Part {
    std::string link;
    Site site;
    LinkInertia in_L;
  };
  static ImpossibleInertia proposal(const Part& part, const LinkInertia& nearest);

  std::vector<Part> parts_;
};

}  // namespace armtune::internal
