#pragma once
// Adds the inertias of a URDF's links to those of the arm's moving bodies, and detects inertias that no rigid
// body can have. A moving body consists of all links that are fixed to each other.

#include <string>
#include <vector>

#include "core/robot/chain.hpp"
#include "core/robot/urdf_options.hpp"
#include "core/robot/urdf_tree.hpp"

namespace armtune::internal {

/// The constant pose of a link's frame L in the frame B of the moving body that carries it. For a link that
/// does not move, `body` is -1 and B is the base frame.
struct Site {
  int body = -1;
  Mat3 R_BL = Mat3::Identity();
  Vec3 p_BL = Vec3::Zero();
};

/// Converts an inertia that is given by mass, centre and inertia about the centre. The result is about the
/// origin of the link's frame.
LinkInertia in_link_frame(const GivenInertia& told);

/// Returns the inertia that the file gives for the link, about the origin of the link's frame. The file must
/// give one. Throws InputError with a message that begins with `source` if the mass or a moment of inertia is
/// negative. After the inertia is added to a body, a negative value could no longer be detected.
LinkInertia inertia_of(const UrdfLink& link, const std::string& source);

/// The links that have been added to the bodies of a chain, so that a message can name those at fault.
class LinkInertias {
 public:
  /// Adds a link to the body that it is fixed to. in_L: about the origin of the link's frame.
  void add(const std::string& link, const LinkInertia& in_L, const Site& site, Chain& chain);

  /// Checks that a rigid body can have the inertia of each body in the chain. If not, it throws InputError
  /// with a message that begins with `source` and names all links at fault. With `missing`, it does not
  /// throw. Instead it adds these links to `missing`, and replaces their inertias in the chain by the nearest
  /// possible ones.
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
