#pragma once
// The inertia that the links of a URDF give to the moving bodies of an arm.

#include <string>
#include <vector>

#include "core/robot/chain.hpp"
#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

/// Where a link's frame L sits: fixed in the frame B of a moving body, or in the base (body -1).
struct Site {
  int body = -1;
  Mat3 R_BL = Mat3::Identity();
  Vec3 p_BL = Vec3::Zero();
};

/// Returns a link's inertia about the origin of its frame, from what is told of it.
LinkInertia in_link_frame(const GivenInertia& told);

/// Returns the inertia that the file gives the link, about the origin of the link's frame; it has an inertial
/// element. Throws InputError, beginning with `source`, if its mass or a moment of inertia is negative: when
/// it is added to a body, that would no longer be seen.
LinkInertia inertia_of(const UrdfLink& link, const std::string& source);

class LinkInertias {
 public:
  /// Adds a link to the body that it is fixed to. in_L: about the origin of the link's frame.
  void add(const std::string& link, const LinkInertia& in_L, const Site& site, Chain& chain);

  /// Throws InputError, beginning with `source`, if there are bodies in the chain whose inertia no rigid body
  /// has; it names all links that are to blame. missing, where given, collects these links instead, and the
  /// chain gets the nearest inertia that a rigid body can have in their place.
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
