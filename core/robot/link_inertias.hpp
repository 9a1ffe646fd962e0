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

/// Adds an inertia about the origin of a link's frame to the moving body that carries the link.
void add_to_body(const LinkInertia& in_L, const Site& site, Chain& chain);

/// The links that have been added to the bodies of a chain, so that a message can name the links with
/// impossible inertias.
class LinkInertias {
 public:
  /// Adds a link to the body that it is fixed to, with the inertia that the file gives. The file must give
  /// one.
  void add(const UrdfLink& link, const Site& site, Chain& chain);
  /// Does the same with an inertia that replaces that of the file.
  void add(const std::string& link, const GivenInertia& given, const Site& site, Chain& chain);

  /// Finds the links with an inertia that no moving rigid body can have:
  ///   - the file gives a negative mass, or a moment of inertia that is negative,
  ///   - the principal moments are impossible (body_inertia.hpp), and so are those of the whole body,
  ///   - the joint turns the body about an axis about which it has no inertia.
  /// If there are any, throws InputError with a message that begins with `source` and names all of them. With
  /// `missing`, it does not throw. Instead it adds these links to `missing`, and replaces their inertias in
  /// the chain by the nearest possible ones, or by placeholders of 1 if there is none.
  void judge(Chain& chain, const std::string& source, MissingData* missing) const;

 private:
  struct Part {
    std::string link;
    Site site;
    LinkInertia in_L;        ///< about the origin of the link's frame
    GivenInertia given;      ///< the same, about the centre of mass
    double negative_moment;  ///< the moment that the file gives as negative; 0 if it gives none
  };
  /// These return the fault of a link as text, or an empty text if it has none of this kind.
  static std::string negative_value(const Part& part);
  static std::string impossible_moments(const Part& part);
  static ImpossibleInertia proposal(const Part& part, std::string fault);
  /// Finds the links at fault that belong to body i, and replaces their inertias in `body`.
  std::vector<ImpossibleInertia> replace_impossible(int i, JointMotion motion, LinkInertia& body) const;

  std::vector<Part> parts_;
};

}  // namespace armtune::internal
