#include "core/robot/link_inertias.hpp"

#include <fmt/format.h>

#include "armtune/error.hpp"
#include "core/robot/body_inertia.hpp"
#include "core/robot/robot_model.hpp"

namespace armtune::internal {
namespace {

/// Tolerance for a negative moment of inertia, as a share of the largest one about the link's origin. A thin
/// rod's smallest moment can become negative by rounding when the author of a file rotates or shifts it.
constexpr double kRounding = 1e-12;

}  // namespace

LinkInertia in_link_frame(const GivenInertia& told) {
  return in_frame({told.mass, Vec3::Zero(), told.about_center}, Mat3::Identity(), told.center);
}

LinkInertia inertia_of(const UrdfLink& link, const std::string& source) {
  const UrdfInertial& given = *link.inertial;
  if (given.mass < 0.0)
    throw InputError(InputPlace{source},
                     fmt::format("link '{}': mass is {} kg; it must not be negative", link.name, given.mass));
  const double least = given.about_center.diagonal().minCoeff();
  const double largest = given.about_center.diagonal().maxCoeff() + given.mass * given.p_LC.squaredNorm();
  if (least < -kRounding * largest)
    throw InputError(
        InputPlace{source},
        fmt::format("link '{}': a moment of inertia is {} kg m^2; none may be negative", link.name, least));
  return in_frame({given.mass, Vec3::Zero(), given.about_center}, given.R_LC, given.p_LC);
}

void LinkInertias::add(const std::string& link, const LinkInertia& in_L, const Site& site, Chain& chain) {
  parts_.push_back({link, site, in_L});
  const LinkInertia in_B = in_frame(in_L, site.R_BL, site.p_BL);
  LinkInertia& body = chain.link[static_cast<std::size_t>(site.body)];
  body.mass += in_B.mass;
  body.first_moment += in_B.first_moment;
  body.inertia += in_B.inertia;
}

ImpossibleInertia LinkInertias::proposal(const Part& part, const LinkInertia& nearest) {
  ImpossibleInertia found{part.link, {}, 0.0};
  found.nearest.mass = nearest.mass;
  found.nearest.center = nearest.first_moment / nearest.mass;
  const auto about_center = [&](const LinkInertia& link) {
    return in_frame(link, Mat3::Identity(), -found.nearest.center).inertia.eval();
  };
  found.nearest.about_center = about_center(nearest);
  const Mat3 given = about_center(part.in_L);
  found.moved = (found.nearest.about_center - given).norm() / given.norm();
  return found;
}

void LinkInertias::judge(Chain& chain, const std::string& source, MissingData* missing) const {
  std::string named;
  for (int i = 0; i < chain.n; ++i) {
    LinkInertia& body = chain.link[static_cast<std::size_t>(i)];
    if (!(body.mass > 0.0) || !body.inertia.allFinite() || is_physical(body)) continue;
    for (const Part& part : parts_) {
      if (part.site.body != i || !(part.in_L.mass > 0.0) || is_physical(part.in_L)) continue;
      const Vec3 moments = principal_moments(part.in_L);
      named += fmt::format("{}{} ({:.4g}, {:.4g}, {:.4g})", named.empty() ? "" : ", ", part.link, moments[0],
                           moments[1], moments[2]);
      if (missing == nullptr) continue;
      const LinkInertia nearest = nearest_physical(part.in_L);
      missing->impossible.push_back(proposal(part, nearest));
      const LinkInertia change{0.0, Vec3::Zero(), nearest.inertia - part.in_L.inertia};
      body.inertia += in_frame(change, part.site.R_BL, part.site.p_BL).inertia;
    }
  }
  if (missing != nullptr || named.empty()) return;
  throw InputError(
      InputPlace{source},
      fmt::format(
          "no rigid body has these principal moments of inertia [kg m^2]: {}. None may be negative, or "
          "larger than the sum of the other two (triangle inequality). 'armtune robot {} --sidecar arm.yaml' "
          "proposes the nearest possible values",
          named, source));
}

}  // namespace armtune::internal
